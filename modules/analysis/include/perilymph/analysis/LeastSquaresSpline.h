#pragma once

// A smooth curve through scattered measurements: what the paper did with every insertion.

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace perilymph::analysis {

/// A cubic spline with evenly spaced knots, in B-splines.
class CubicSpline {
public:
  /// @param low, high     Where it holds.
  /// @param coefficients  Of the B-splines: intervals + 3, at least 4.
  CubicSpline(double low, double high, std::vector<double> coefficients);

  /// The value at x; beyond the ends the first and the last interval's cubic goes on.
  double at(double x) const noexcept;

private:
  double low_, perInterval_;
  std::vector<double> coefficients_;
};

/// The cubic spline over [low, high] with so many even intervals that minimizes the sum of squared
/// distances to the points (x, y). Points outside [low, high] do not count. Nothing if the points
/// do not determine it: a stretch of some intervals has too few.
///
/// Sums in the order of the points, banded Cholesky (L D L^T): the same bits on every machine.
std::optional<CubicSpline> fitSpline(std::span<const double> x, std::span<const double> y,
                                     double low, double high, std::size_t intervals);

}  // namespace perilymph::analysis
