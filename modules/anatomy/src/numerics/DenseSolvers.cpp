// SPDX-License-Identifier: BSD-3-Clause
#include "numerics/DenseSolvers.h"

#include <cmath>
#include <utility>

namespace perilymph::anatomy {

Eigen3::Eigen3(const Eigen::Matrix3d& matrix) noexcept : vectors(Eigen::Matrix3d::Identity())
{
  constexpr int sweeps = 8;  // convergence is quadratic: 5 suffice in double precision
  double a[3][3];
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < 3; ++k) a[i][k] = matrix(i, k);
  for (int sweep = 0; sweep < sweeps; ++sweep)
    for (int p = 0; p < 2; ++p)
      for (int q = p + 1; q < 3; ++q) {
        if (a[p][q] == 0.0) continue;
        // the rotation in the p-q plane that makes the off-diagonal element zero
        const double half = 0.5 * (a[q][q] - a[p][p]) / a[p][q];
        const double sign = half < 0.0 ? -1.0 : 1.0;
        const double t = sign / (std::fabs(half) + std::sqrt(half * half + 1.0));
        const double c = 1.0 / std::sqrt(t * t + 1.0);
        const double s = t * c;
        for (int k = 0; k < 3; ++k) {
          const double kp = a[k][p], kq = a[k][q];
          a[k][p] = c * kp - s * kq;
          a[k][q] = s * kp + c * kq;
        }
        for (int k = 0; k < 3; ++k) {
          const double pk = a[p][k], qk = a[q][k];
          a[p][k] = c * pk - s * qk;
          a[q][k] = s * pk + c * qk;
        }
        a[p][q] = a[q][p] = 0.0;
        for (int k = 0; k < 3; ++k) {
          const double kp = vectors(k, p), kq = vectors(k, q);
          vectors(k, p) = c * kp - s * kq;
          vectors(k, q) = s * kp + c * kq;
        }
      }
  values = {a[0][0], a[1][1], a[2][2]};
}

LeastSquares::LeastSquares(std::size_t unknowns)
    : unknowns_(unknowns), matrix_(unknowns * (unknowns + 1), 0.0)
{
}

void LeastSquares::add(const std::vector<double>& row, double right)
{
  for (std::size_t i = 0; i < unknowns_; ++i) {
    double* const line = matrix_.data() + i * (unknowns_ + 1);
    for (std::size_t k = 0; k < unknowns_; ++k) line[k] += row[i] * row[k];
    line[unknowns_] += row[i] * right;
  }
}

std::vector<double> LeastSquares::solve() const
{
  // Gaussian elimination with partial pivoting
  const std::size_t width = unknowns_ + 1;
  std::vector<double> m = matrix_;
  std::vector<double> x(unknowns_, 0.0);
  std::vector<bool> isKnown(unknowns_, false);
  for (std::size_t i = 0; i < unknowns_; ++i) {
    std::size_t pivot = i;
    for (std::size_t k = i + 1; k < unknowns_; ++k)
      if (std::fabs(m[k * width + i]) > std::fabs(m[pivot * width + i])) pivot = k;
    for (std::size_t k = 0; k < width; ++k) std::swap(m[i * width + k], m[pivot * width + k]);
    if (std::fabs(m[i * width + i]) < 1e-14 * (1.0 + std::fabs(matrix_[i * width + i]))) continue;
    isKnown[i] = true;
    for (std::size_t k = i + 1; k < unknowns_; ++k) {
      const double factor = m[k * width + i] / m[i * width + i];
      for (std::size_t j = i; j < width; ++j) m[k * width + j] -= factor * m[i * width + j];
    }
  }
  for (std::size_t i = unknowns_; i-- > 0;) {
    if (!isKnown[i]) continue;
    double sum = m[i * width + unknowns_];
    for (std::size_t k = i + 1; k < unknowns_; ++k) sum -= m[i * width + k] * x[k];
    x[i] = sum / m[i * width + i];
  }
  return x;
}

}  // namespace perilymph::anatomy
