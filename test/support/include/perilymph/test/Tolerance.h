// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace perilymph::test {

/// A tolerance with its reason, scaled by PERILYMPH_TOLERANCE_SCALE: 0 in the environment makes
/// every inexact test show its true residual; 1 or unset leaves the tolerance unchanged.
///
///     const double oneElement = tolerance(0.01, "one element of a hundred");
///
/// @param value   The tolerance at scale 1, 0 or more.
/// @param reason  Why this value, for the reader; not empty.
/// @throws std::invalid_argument for a negative value, an empty reason, or an invalid scale.
double tolerance(double value, const char* reason);

}  // namespace perilymph::test
