// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The normal distribution, based on foundation's exponential: the same bits on every machine.

namespace perilymph::ct {

/// Density of the standard normal distribution.
double normalDensity(double x);

/// Probability of a standard normal deviate below x. Absolute error below 1e-7.
double normalCumulative(double x);

}  // namespace perilymph::ct
