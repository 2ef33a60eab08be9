#pragma once

// The linear system of one Newton step: symmetric positive definite, 3x3 blocks, two beside the
// diagonal on each side.

#include <Eigen/Core>
#include <vector>

namespace perilymph::mechanics {

/// Unknown block 0 is the base (nodes 0 and 1 move with it); block j is node j + 1.
struct BandSystem {
  explicit BandSystem(std::size_t blocks = 0)
      : diagonal(blocks), beside(blocks), beyond(blocks), right(blocks)
  {
    clear();
  }

  std::size_t blocks() const noexcept { return diagonal.size(); }
  void clear() noexcept;

  /// Adds to the block (row, column); only row >= column is kept.
  void add(std::size_t row, std::size_t column, const Eigen::Matrix3d& block) noexcept
  {
    if (row == column)
      diagonal[row] += block;
    else if (row == column + 1)
      beside[row] += block;
    else
      beyond[row] += block;
  }

  /// Replaces the system by its solution in `right`, by a block LDL^T factorization, O(blocks).
  /// False if a pivot is not positive definite: then `right` is not usable. Real-time safe.
  bool solve() noexcept;

  std::vector<Eigen::Matrix3d> diagonal;  ///< Block (j, j).
  std::vector<Eigen::Matrix3d> beside;    ///< Block (j, j - 1).
  std::vector<Eigen::Matrix3d> beyond;    ///< Block (j, j - 2).
  std::vector<Eigen::Vector3d> right;     ///< Right-hand side, then the solution.
};

}  // namespace perilymph::mechanics
