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

/// Fills a plan's arrays and their differences, from its request, thresholds, friction and insertions.
void addSummary(Plan& plan, const std::vector<PlannedArray>& arrays);

/// Number of simulations from which on quantiles are called a band: the 90 % band of 16 holds 0.88 +-
/// 0.08 of what is to come, that of 64 0.90 +- 0.04.
inline constexpr std::size_t fewestForBand = 64;

/// Whether the bands of angle and peak force of all arrays stand: there are enough simulations, and the
/// standard errors of both edges are at most a tenth of the width, 5 degrees or 5 % of the median peak
/// force (choices, medium).
bool hasConverged(const Plan& plan);

}  // namespace perilymph::planning
