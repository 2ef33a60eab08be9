#pragma once

// Cubic splines through unevenly spaced knots: what lies between measured sections.

#include <vector>

namespace perilymph::anatomy {

/// What a spline does at its ends, where there is no neighbor to bend toward.
enum class SplineEnds {
  natural,   ///< No bend at the first and the last knot.
  notAKnot,  ///< The first two pieces are one cubic, and so are the last two.
};

/// Cubic spline through knots, twice continuously differentiable. Beyond the knots its outermost
/// cubics go on. At least four knots.
class KnotSpline {
public:
  KnotSpline(std::vector<double> x, std::vector<double> y, SplineEnds ends = SplineEnds::natural);

  double operator()(double x) const;

private:
  std::vector<double> x_, y_, bend_;
};

}  // namespace perilymph::anatomy
