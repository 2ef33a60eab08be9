#pragma once

// Small symmetric problems by hand: the same bits on every machine, whatever a library would
// choose.

#include <Eigen/Core>
#include <array>
#include <vector>

namespace perilymph::anatomy {

/// Eigenvalues and unit eigenvectors (columns) of a symmetric 3 x 3 matrix, in no order, by a fixed
/// number of Jacobi sweeps. Real-time safe.
struct Eigen3 {
  Eigen::Vector3d values;
  Eigen::Matrix3d vectors;
  explicit Eigen3(const Eigen::Matrix3d& matrix) noexcept;
};

/// Least squares by normal equations: takes rows one by one.
class LeastSquares {
public:
  explicit LeastSquares(std::size_t unknowns);

  void add(const std::vector<double>& row, double right);

  /// The unknowns. Directions that no row tells anything about stay 0.
  std::vector<double> solve() const;

private:
  std::size_t unknowns_;
  std::vector<double> matrix_;  ///< [row][column], the right-hand side last in each row.
};

}  // namespace perilymph::anatomy
