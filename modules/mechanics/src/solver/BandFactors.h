// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Factorization of a band matrix, for any number of right-hand sides.

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "solver/BandMatrix.h"
#include "solver/Blocks.h"

namespace perilymph {
class Hash;
}

namespace perilymph::mechanics {

/// Block LDL^T, O(blocks). The chain is eliminated from both ends at once, and the one to three
/// blocks in the middle last. The two ends are independent, so they are computed in parallel in the
/// two lanes of an SSE2 register, which every x86-64 processor has.
class BandFactors {
public:
  explicit BandFactors(std::size_t blocks = 0);

  /// Factorizes a matrix. False, without factors, if it is not positive definite. Real-time safe.
  bool factorize(const BandMatrix& matrix) noexcept;

  bool exist() const noexcept { return exist_; }
  void invalidate() noexcept { exist_ = false; }
  /// Whether the first unknown was held in the factorized matrix.
  bool firstIsHeld() const noexcept { return firstIsHeld_; }

  /// Replaces `right` by the solution. Real-time safe.
  void solve(std::vector<Eigen::Vector3d>& right) noexcept;

  /// Adds all data that solutions depend on.
  void addTo(Hash& hash) const noexcept;

private:
  /// Two numbers: one for the chain from the base, one for the chain from the tip.
  using Lanes [[gnu::vector_size(16)]] = double;

  void factorizeInLanes(const BandMatrix& matrix) noexcept;
  void solveInLanes(std::vector<Eigen::Vector3d>& right) noexcept;

  /// Column k of the factors, in the order of elimination.
  template <class T>
  struct Column {
    SymmetricBlock<T> inverse;  ///< Inverse of the pivot.
    Block<T> beside;            ///< Block (k + 1, k).
    Block<T> beyond;            ///< Block (k + 2, k).
    Triple<T> solution;         ///< Workspace of solve().
  };

  std::size_t blocks_;
  std::size_t steps_;  ///< Blocks eliminated from each end.
  std::size_t left_;   ///< Blocks left in the middle, 1 to 3.
  bool exist_ = false;
  bool firstIsHeld_ = false;
  std::vector<Column<Lanes>> ends_;
  std::vector<Column<double>> middle_;
};

}  // namespace perilymph::mechanics
