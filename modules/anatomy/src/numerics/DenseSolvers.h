// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Solvers of small dense symmetric problems, with the same bits on every machine, independent of a
// library.

#include <Eigen/Core>
#include <array>
#include <vector>

namespace perilymph::anatomy {

/// Eigenvalues and unit eigenvectors (columns) of a symmetric 3 x 3 matrix, unsorted, by a fixed
/// number of Jacobi sweeps. Real-time safe.
struct Eigen3 {
  Eigen::Vector3d values;
  Eigen::Matrix3d vectors;
  explicit Eigen3(const Eigen::Matrix3d& matrix) noexcept;
};

/// Least squares by normal equations; rows are added one by one.
class LeastSquares {
public:
  explicit LeastSquares(std::size_t unknowns);

  void add(const std::vector<double>& row, double right);

  /// The solution. Directions that no row determines are 0.
  std::vector<double> solve() const;

private:
  std::size_t unknowns_;
  std::vector<double> matrix_;  ///< [row][column], the right-hand side as the last column.
};

}  // namespace perilymph::anatomy
