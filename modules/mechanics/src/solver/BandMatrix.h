// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The matrix of a Newton step: symmetric, 3x3 blocks, two off-diagonals on each side.

#include <cstddef>
#include <vector>

#include "lanes/Lanes.h"
#include "solver/Blocks.h"

namespace perilymph::mechanics {

/// Symmetric blocks, component by component, so that four of them are assembled at a time.
struct SymmetricBlocks {
  explicit SymmetricBlocks(std::size_t n) : xx(n), xy(n), xz(n), yy(n), yz(n), zz(n) {}

  SymmetricBlock<double> operator[](std::size_t i) const noexcept
  {
    return {xx[i], xy[i], xz[i], yy[i], yz[i], zz[i]};
  }
  void set(std::size_t i, const SymmetricBlock<double>& b) noexcept
  {
    xx[i] = b.xx, xy[i] = b.xy, xz[i] = b.xz, yy[i] = b.yy, yz[i] = b.yz, zz[i] = b.zz;
  }
  void add(std::size_t i, const SymmetricBlock<double>& b) noexcept
  {
    xx[i] += b.xx, xy[i] += b.xy, xz[i] += b.xz, yy[i] += b.yy, yz[i] += b.yz, zz[i] += b.zz;
  }

  std::vector<double> xx, xy, xz, yy, yz, zz;
};

/// General blocks in the same way.
struct Blocks {
  explicit Blocks(std::size_t n) : xx(n), xy(n), xz(n), yx(n), yy(n), yz(n), zx(n), zy(n), zz(n) {}

  Block<double> operator[](std::size_t i) const noexcept
  {
    return {xx[i], xy[i], xz[i], yx[i], yy[i], yz[i], zx[i], zy[i], zz[i]};
  }
  void set(std::size_t i, const Block<double>& b) noexcept
  {
    xx[i] = b.xx, xy[i] = b.xy, xz[i] = b.xz;
    yx[i] = b.yx, yy[i] = b.yy, yz[i] = b.yz;
    zx[i] = b.zx, zy[i] = b.zy, zz[i] = b.zz;
  }
  void add(std::size_t i, const Block<double>& b) noexcept
  {
    xx[i] += b.xx, xy[i] += b.xy, xz[i] += b.xz;
    yx[i] += b.yx, yy[i] += b.yy, yz[i] += b.yz;
    zx[i] += b.zx, zy[i] += b.zy, zz[i] += b.zz;
  }

  std::vector<double> xx, xy, xz, yx, yy, yz, zx, zy, zz;
};

template <class T>
PERILYMPH_IN_LANES SymmetricBlock<T> load(const SymmetricBlocks& from, std::size_t i) noexcept
{
  return {load<T>(from.xx, i), load<T>(from.xy, i), load<T>(from.xz, i),
          load<T>(from.yy, i), load<T>(from.yz, i), load<T>(from.zz, i)};
}

template <class T>
PERILYMPH_IN_LANES void store(const SymmetricBlock<T>& b, SymmetricBlocks& to,
                              std::size_t i) noexcept
{
  store(b.xx, to.xx, i), store(b.xy, to.xy, i), store(b.xz, to.xz, i);
  store(b.yy, to.yy, i), store(b.yz, to.yz, i), store(b.zz, to.zz, i);
}

template <class T>
PERILYMPH_IN_LANES Block<T> load(const Blocks& from, std::size_t i) noexcept
{
  return {load<T>(from.xx, i), load<T>(from.xy, i), load<T>(from.xz, i),
          load<T>(from.yx, i), load<T>(from.yy, i), load<T>(from.yz, i),
          load<T>(from.zx, i), load<T>(from.zy, i), load<T>(from.zz, i)};
}

template <class T>
PERILYMPH_IN_LANES void store(const Block<T>& b, Blocks& to, std::size_t i) noexcept
{
  store(b.xx, to.xx, i), store(b.xy, to.xy, i), store(b.xz, to.xz, i);
  store(b.yx, to.yx, i), store(b.yy, to.yy, i), store(b.yz, to.yz, i);
  store(b.zx, to.zx, i), store(b.zy, to.zy, i), store(b.zz, to.zz, i);
}

/// Unknown block 0 is the base (nodes 0 and 1 move with it); block j is node j + 1.
struct BandMatrix {
  explicit BandMatrix(std::size_t blocks = 0) : diagonal(blocks), beside(blocks), beyond(blocks) {}

  std::size_t blocks() const noexcept { return diagonal.xx.size(); }

  /// Makes block 0 the identity, uncoupled from all others: an unknown with a prescribed value.
  void holdFirst() noexcept;

  SymmetricBlocks diagonal;  ///< Block (j, j).
  Blocks beside;             ///< Block (j, j - 1).
  Blocks beyond;             ///< Block (j, j - 2).
  bool firstIsHeld = false;
};

}  // namespace perilymph::mechanics
