// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Least-squares cubic spline, which the paper fitted to every insertion.

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace perilymph::validation {

/// A uniform cubic spline in B-spline form.
class CubicSpline {
public:
  /// @param low, high     Its range.
  /// @param coefficients  B-spline coefficients: intervals + 3, at least 4.
  CubicSpline(double low, double high, std::vector<double> coefficients);

  /// Value at x; extrapolated by the first and the last cubic.
  double at(double x) const noexcept;

private:
  double low_, perInterval_;
  std::vector<double> coefficients_;
};

/// Fits a cubic spline over [low, high] with a number of equal intervals, by least squares to the
/// points (x, y). Points outside [low, high] are ignored. Empty if the points do not determine it,
/// because some intervals have too few.
///
/// Sums in the order of the points; banded L D L^T: the same bits on every machine.
std::optional<CubicSpline> fitSpline(std::span<const double> x, std::span<const double> y,
                                     double low, double high, std::size_t intervals);

}  // namespace perilymph::validation
