// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The stop lengths of a plan's simulations, computed once and kept beside the plan.

#include <cstddef>
#include <filesystem>
#include <stop_token>

#include "perilymph/foundation/Result.h"
#include "perilymph/planning/PlanRequest.h"
#include "perilymph/planning/UnstoppedDraws.h"

namespace perilymph::outcome {

/// The simulations of a plan's array without a stop. They are read from `stops-N.sqlite` in the plan's
/// folder, N the place of the array from 1; those that it lacks are computed, in parallel, and added in
/// blocks, so that an interruption keeps what was done. A second call computes nothing.
///
/// @param array   Index into the request's arrays.
/// @param folder  The plan's folder.
/// @param stop    Ends it early, with an error.
/// @return        The request's number of simulations, by number. Refuses a file of another plan, and one that
///                was changed after the program wrote it.
Result<std::vector<planning::UnstoppedDraw>> stopLengths(const planning::PlanRequest& request,
                                                         std::size_t array,
                                                         const std::filesystem::path& folder,
                                                         const analysis::RunProgress& progress = {},
                                                         const std::stop_token& stop = {});

/// Name of the file of an array.
std::string stopLengthsFile(std::size_t array);

}  // namespace perilymph::outcome
