// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// A plan: electrode arrays in one patient's cochlea, with bands for what measures, hand, approach and
// stiffness leave open. Values are those of the model, none is a recommendation. Its request and its
// result have headers of their own.

#include <filesystem>
#include <stop_token>
#include <string>

#include "perilymph/analysis/RunProgress.h"
#include "perilymph/foundation/Result.h"
#include "perilymph/planning/PlanRequest.h"
#include "perilymph/planning/PlanResult.h"
#include "perilymph/planning/PlanSummary.h"

namespace perilymph::planning {

/// Makes a plan. Every draw is a cochlea, an approach, a hand and a stiffness, the same for all
/// arrays. Draws are kept in a file as they are done: a plan that was interrupted continues there,
/// and is the same, to the bit, for any number of threads and interruptions.
///
/// @param draws  File of the draws (`.sqlite`), created or continued; in memory only if empty.
/// @param stop   Ends the work early, with an error.
/// @return       Refuses a patient without A and B, unknown arrays, a file of another plan.
Result<Plan> makePlan(const PlanRequest& request, const std::filesystem::path& draws,
                      const analysis::RunProgress& progress = {}, const std::stop_token& stop = {});

/// Reads a plan from its file of draws, as it was made; computes no insertion. If an array, the
/// scenario, a distribution, a threshold, a filter or the program was changed since, thresholds and filters are those of the
/// plan.json beside the file.
///
/// @param request  As for makePlan(); of its draws exactly as many are read.
/// @param draws    File of the draws, which is not written to.
/// @return         Refuses a file with fewer draws, and a changed plan without a plan.json.
Result<Plan> viewPlan(const PlanRequest& request, const std::filesystem::path& draws);

/// Plan::fingerprint of a request, before a plan is made. The errors are those of makePlan().
Result<std::string> fingerprintOf(const PlanRequest& request);

}  // namespace perilymph::planning
