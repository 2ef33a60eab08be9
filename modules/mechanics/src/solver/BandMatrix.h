// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The matrix of a Newton step: symmetric, 3x3 blocks, two off-diagonals on each side.

#include <cstddef>
#include <vector>

#include "solver/Blocks.h"

namespace perilymph::mechanics {

/// Unknown block 0 is the base (nodes 0 and 1 move with it); block j is node j + 1.
struct BandMatrix {
  explicit BandMatrix(std::size_t blocks = 0) : diagonal(blocks), beside(blocks), beyond(blocks) {}

  std::size_t blocks() const noexcept { return diagonal.size(); }

  /// All blocks zero.
  void clear() noexcept;

  /// Makes block 0 the identity, uncoupled from all others: an unknown with a prescribed value.
  void holdFirst() noexcept;

  std::vector<SymmetricBlock<double>> diagonal;  ///< Block (j, j).
  std::vector<Block<double>> beside;             ///< Block (j, j - 1).
  std::vector<Block<double>> beyond;             ///< Block (j, j - 2).
  bool firstIsHeld = false;
};

}  // namespace perilymph::mechanics
