// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// What a study will cost.

#include <stop_token>

#include "perilymph/foundation/Result.h"
#include "perilymph/study/Study.h"

namespace perilymph::study {

/// Duration and size of a study on this machine, from insertions that were run to measure them.
struct StudyEstimate {
  double processorTime_s =
      0.0;                   ///< Time of one processor; divided by the processors, the duration.
  double bytes = 0.0;        ///< On the disk: shard, merged file and table.
  std::size_t measured = 0;  ///< Insertions that were run.
};

/// Runs up to three of the combinations in the first cochlea. Depends on the load of the machine.
///
/// @param stop  Ends the work with an error.
Result<StudyEstimate> estimate(const Study& study, const std::stop_token& stop = {});

}  // namespace perilymph::study
