// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// One insertion of an experiment, as measured by a load cell: a force every 50 ms.

#include <memory>
#include <optional>
#include <stop_token>
#include <vector>

#include "perilymph/anatomy/ScalaTympani.h"
#include "perilymph/validation/IncompleteInsertion.h"
#include "perilymph/validation/Variability.h"

namespace perilymph::validation {

/// Samples of load cell and crosshead.
struct MeasuredInsertion {
  /// Why it ended before its stop; empty if it reached it.
  std::optional<IncompleteInsertion> incomplete;
  /// Crosshead travel since the first motion [m], as experiments measure it. It differs from the
  /// tip's travel if the array bends before the opening.
  std::vector<double> travel;
  std::vector<double> depth;  ///< Past the opening [m].
  std::vector<double> force;  ///< Axial on the hand, with the cell's noise [N].
  std::uint64_t ticks = 0;
  std::uint64_t ticksNotConverged = 0;
};

/// Runs a drawn insertion up to a travel in virtual time and samples its force. One that cannot
/// reach the travel is a result, not an error: it ends where that is certain.
///
/// @param anatomy  The cochlea of its scenario, shared between insertions.
/// @param travel   At the end.
/// @param stop     Ends it early, with an error.
Result<MeasuredInsertion> measure(const DrawnInsertion& drawn,
                                  std::shared_ptr<const anatomy::ScalaTympani> anatomy,
                                  Duration samplePeriod, Length travel,
                                  const std::stop_token& stop);

}  // namespace perilymph::validation
