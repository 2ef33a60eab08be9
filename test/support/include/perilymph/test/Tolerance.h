#pragma once

namespace perilymph::test {

/// A tolerance with its reason, as PERILYMPH_TOLERANCE_SCALE wants it: 0 in the environment makes
/// every test that is not exact show its true residual; 1, or nothing, leaves the tolerance alone.
///
///     const double oneElement = tolerance(0.01, "one element of a hundred");
///
/// @param value   The tolerance at scale 1, 0 or more.
/// @param reason  Why this much, for the reader; not empty.
/// @throws std::invalid_argument for a value below 0, no reason, or a scale that is no number.
double tolerance(double value, const char* reason);

}  // namespace perilymph::test
