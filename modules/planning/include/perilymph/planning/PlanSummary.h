// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// From the insertions of a plan to its bands.

#include <vector>

#include "perilymph/planning/PlanResult.h"

namespace perilymph::planning {

/// The band of some values: 5, 25, 50, 75 and 95 % of the cochlea and hand to come; zeros without a
/// value, as if no insertion of an array could be prepared. The i-th
/// of n sorted draws is the quantile i / (n + 1), whose expectation no distribution changes
/// (Hyndman and Fan 1996, Am Stat 50:361, definition 6); below 19 draws low and high are the extremes
/// and hold less than 90 %.
Band bandOf(std::vector<double> values);

/// Summaries of a request's arrays from insertions by draw and array.
std::vector<ArrayPlan> summarize(const PlanRequest& request,
                                 const std::vector<PlannedArray>& arrays,
                                 const Thresholds& thresholds,
                                 const std::vector<PlannedInsertion>& insertions);

/// Whether the bands of all arrays stand: the standard errors of the median angle and of the median
/// peak force are at most 5 degrees and 5 % (choices, medium).
bool bandsStand(const std::vector<ArrayPlan>& arrays);

}  // namespace perilymph::planning
