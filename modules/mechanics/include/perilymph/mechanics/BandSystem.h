#pragma once

// The linear system of one Newton step: symmetric positive definite, 3x3 blocks, two beside the
// diagonal on each side.

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "perilymph/mechanics/Blocks.h"

namespace perilymph::mechanics {

/// Unknown block 0 is the base (nodes 0 and 1 move with it); block j is node j + 1.
///
/// Solved by block LDL^T, O(blocks). The chain is eliminated from both its ends at once, and what
/// is left in the middle (one to three blocks) last. The two ends do not depend on each other, so
/// they run side by side in the two lanes of a register that every x86-64 processor has.
class BandSystem {
public:
  explicit BandSystem(std::size_t blocks = 0);

  std::size_t blocks() const noexcept { return diagonal.size(); }

  /// Makes the matrix zero. The factors stay.
  void clear() noexcept;

  /// Makes block 0 the identity, coupled to nothing: an unknown whose value is given.
  void holdFirst() noexcept;

  /// Finds the factors of the matrix, for any number of solutions. False if it is not positive
  /// definite: then there are none. Real-time safe.
  bool factorize() noexcept;

  /// Replaces `right` by the solution. Needs factors. Real-time safe.
  void solve(std::vector<Eigen::Vector3d>& right) noexcept;

  std::vector<SymmetricBlock<double>> diagonal;  ///< Block (j, j).
  std::vector<Block<double>> beside;             ///< Block (j, j - 1).
  std::vector<Block<double>> beyond;             ///< Block (j, j - 2).

private:
  /// Two numbers side by side: of the chain from the base, and of the chain from the tip.
  using Lanes [[gnu::vector_size(16)]] = double;

  /// Column k of the factors, in the order of elimination.
  template <class T>
  struct Column {
    SymmetricBlock<T> inverse;  ///< Of the pivot.
    Block<T> beside;            ///< Block (k + 1, k).
    Block<T> beyond;            ///< Block (k + 2, k).
    Triple<T> solution;         ///< Room for solve().
  };

  std::size_t steps_;  ///< Blocks eliminated from each end.
  std::size_t left_;   ///< Blocks left in the middle, 1 to 3.
  std::vector<Column<Lanes>> ends_;
  std::vector<Column<double>> middle_;
};

}  // namespace perilymph::mechanics
