// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Cubic splines through unevenly spaced knots, to interpolate between measured sections.

#include <vector>

namespace perilymph::anatomy {

/// End conditions of a spline.
enum class SplineEnds {
  natural,   ///< Zero second derivative at the first and the last knot.
  notAKnot,  ///< The first two pieces are one cubic, and so are the last two.
};

/// Interpolating cubic spline, twice continuously differentiable, extrapolated by its outermost
/// cubics. At least four knots.
class KnotSpline {
public:
  KnotSpline(std::vector<double> x, std::vector<double> y, SplineEnds ends = SplineEnds::natural);

  double operator()(double x) const;

private:
  std::vector<double> x_, y_, bend_;
};

}  // namespace perilymph::anatomy
