// SPDX-License-Identifier: BSD-3-Clause
#include "numerics/KnotSpline.h"

#include <cstddef>
#include <utility>

namespace perilymph::anatomy {

KnotSpline::KnotSpline(std::vector<double> x, std::vector<double> y, SplineEnds ends)
    : x_(std::move(x)), y_(std::move(y))
{
  const std::size_t n = x_.size();
  const auto gap = [&](std::size_t i) { return x_[i + 1] - x_[i]; };
  // Not-a-knot ends: the second derivative at an end is extrapolated linearly from the next two:
  // bend[0] = (1 + s) bend[1] - s bend[2].
  const bool isNatural = ends == SplineEnds::natural;
  const double s = isNatural ? 0.0 : gap(0) / gap(1);
  const double t = isNatural ? 0.0 : gap(n - 2) / gap(n - 3);

  bend_.assign(n, 0.0);
  std::vector<double> upper(n, 0.0);
  for (std::size_t i = 1; i + 1 < n; ++i) {
    const double before = gap(i - 1);
    const double after = gap(i);
    const double right = 6.0 * ((y_[i + 1] - y_[i]) / after - (y_[i] - y_[i - 1]) / before);
    double lower = before, diagonal = 2.0 * (before + after), higher = after;
    if (i == 1 && !isNatural) {
      diagonal += before * (1.0 + s);
      higher -= before * s;
    }
    if (i == n - 2 && !isNatural) {
      diagonal += after * (1.0 + t);
      lower -= after * t;
    }
    const double pivot = diagonal - lower * upper[i - 1];
    upper[i] = higher / pivot;
    bend_[i] = (right - lower * bend_[i - 1]) / pivot;
  }
  for (std::size_t i = n - 2; i-- > 1;) bend_[i] -= upper[i] * bend_[i + 1];
  if (!isNatural) {
    bend_[0] = (1.0 + s) * bend_[1] - s * bend_[2];
    bend_[n - 1] = (1.0 + t) * bend_[n - 2] - t * bend_[n - 3];
  }
}

double KnotSpline::operator()(double x) const
{
  std::size_t i = 1;
  while (i + 1 < x_.size() && x > x_[i]) ++i;
  const double h = x_[i] - x_[i - 1];
  const double a = (x_[i] - x) / h;
  const double b = (x - x_[i - 1]) / h;
  return a * y_[i - 1] + b * y_[i] +
         ((a * a * a - a) * bend_[i - 1] + (b * b * b - b) * bend_[i]) * h * h / 6.0;
}

}  // namespace perilymph::anatomy
