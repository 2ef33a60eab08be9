// SPDX-License-Identifier: BSD-3-Clause
#include "experiment/LeastSquaresSpline.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

namespace perilymph::validation {

namespace {

constexpr std::size_t order = 4;  // number of nonzero B-splines at a point

/// An interval and the four B-splines there.
struct Basis {
  std::size_t first = 0;
  std::array<double, order> weight{};
};

Basis basisAt(double place, std::size_t intervals)
{
  Basis basis;
  const double last = static_cast<double>(intervals - 1);
  const double whole = std::clamp(std::floor(place), 0.0, last);
  basis.first = static_cast<std::size_t>(whole);
  const double t = place - whole;
  const double u = 1.0 - t;
  basis.weight = {u * u * u / 6.0, (t * t * (3.0 * t - 6.0) + 4.0) / 6.0,
                  (u * u * (3.0 * u - 6.0) + 4.0) / 6.0, t * t * t / 6.0};
  return basis;
}

/// Symmetric band matrix, three diagonals below the main one: row i holds (i, i - 3) to (i, i).
struct Band {
  explicit Band(std::size_t size) : rows(size), right(size, 0.0) {}

  void add(const Basis& basis, double value)
  {
    for (std::size_t i = 0; i < order; ++i) {
      right[basis.first + i] += basis.weight[i] * value;
      for (std::size_t j = 0; j <= i; ++j)
        rows[basis.first + i][order - 1 - (i - j)] += basis.weight[i] * basis.weight[j];
    }
  }

  double& at(std::size_t row, std::size_t column) { return rows[row][order - 1 - (row - column)]; }

  /// Replaces `right` by the solution; false if the points do not determine it.
  bool solve()
  {
    const std::size_t size = rows.size();
    for (std::size_t i = 0; i < size; ++i) {
      const double before = at(i, i);
      const std::size_t first = i < order ? 0 : i - (order - 1);
      for (std::size_t j = first; j < i; ++j) {
        double entry = at(i, j);  // becomes L(i, j) D(j)
        const std::size_t common = std::max(first, j < order ? 0 : j - (order - 1));
        for (std::size_t k = common; k < j; ++k) entry -= at(i, k) * at(j, k) * at(k, k);
        at(i, j) = entry / at(j, j);
        at(i, i) -= at(i, j) * at(i, j) * at(j, j);
      }
      // A pivot that cancels to rounding errors means that this coefficient is undetermined.
      if (!(at(i, i) > 1e-9 * before) || !(before > 0.0)) return false;
      for (std::size_t j = first; j < i; ++j) right[i] -= at(i, j) * right[j];
    }
    for (std::size_t i = size; i-- > 0;) {
      right[i] /= at(i, i);
      for (std::size_t j = i + 1; j < std::min(size, i + order); ++j)
        right[i] -= at(j, i) * right[j];
    }
    return true;
  }

  std::vector<std::array<double, order>> rows;
  std::vector<double> right;
};

}  // namespace

CubicSpline::CubicSpline(double low, double high, std::vector<double> coefficients)
    : low_(low), perInterval_(0.0), coefficients_(std::move(coefficients))
{
  if (coefficients_.size() < order || !(high > low))
    throw std::invalid_argument("A cubic spline needs an interval and at least 4 coefficients.");
  perInterval_ = static_cast<double>(coefficients_.size() - (order - 1)) / (high - low);
}

double CubicSpline::at(double x) const noexcept
{
  const Basis basis = basisAt((x - low_) * perInterval_, coefficients_.size() - (order - 1));
  double value = 0.0;
  for (std::size_t i = 0; i < order; ++i) value += basis.weight[i] * coefficients_[basis.first + i];
  return value;
}

std::optional<CubicSpline> fitSpline(std::span<const double> x, std::span<const double> y,
                                     double low, double high, std::size_t intervals)
{
  if (intervals == 0 || !(high > low) || x.size() != y.size()) return std::nullopt;
  Band normal(intervals + order - 1);
  const double perInterval = static_cast<double>(intervals) / (high - low);
  for (std::size_t i = 0; i < x.size(); ++i)
    if (x[i] >= low && x[i] <= high)
      normal.add(basisAt((x[i] - low) * perInterval, intervals), y[i]);
  if (!normal.solve()) return std::nullopt;
  return CubicSpline(low, high, std::move(normal.right));
}

}  // namespace perilymph::validation
