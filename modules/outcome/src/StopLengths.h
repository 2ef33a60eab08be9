// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The stop lengths of a plan's simulations, computed once and kept beside the plan.

#include <cstddef>
#include <filesystem>
#include <stop_token>
#include <vector>

#include "perilymph/foundation/Result.h"
#include "perilymph/planning/PlanRequest.h"
#include "perilymph/planning/UnstoppedDraws.h"

namespace perilymph::outcome {

/// The simulations of a plan's array without a stop.
struct KnownStops {
  std::vector<planning::UnstoppedDraw> draws;  ///< By number, as many as the request has.
  bool isRenewed = false;  ///< A file was there that could not be continued, and was begun again.
};

/// Reads them from `stops-N.sqlite` in the plan's folder, N the place of the array from 1; those that it
/// lacks are computed, in parallel, and added in blocks: each is in the file as a whole or not at all, and an
/// interruption keeps what was done. A second call computes nothing, and one while another program computes
/// waits for it. The file is begun again if it is of another build of the program or of another plan, was
/// changed after the program wrote it, or is damaged.
///
/// @param array   Index into the request's arrays.
/// @param folder  The plan's folder.
/// @param stop    Ends it early, with an error.
/// @return        Refuses a link, a folder and a file that an older program works on.
Result<KnownStops> stopLengths(const planning::PlanRequest& request, std::size_t array,
                               const std::filesystem::path& folder,
                               const analysis::RunProgress& progress = {},
                               const std::stop_token& stop = {});

/// Name of the file of an array.
std::string stopLengthsFile(std::size_t array);

}  // namespace perilymph::outcome
