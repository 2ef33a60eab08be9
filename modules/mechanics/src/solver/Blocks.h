// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// 3x3 blocks as plain numbers. T is a double, or a pair or four of them processed in
// parallel (BandFactors, lanes/Lanes.h). Everything is written out, so that the compiler keeps a whole block in registers
// and the order of the sums, and with it the last bit, is fixed.

namespace perilymph::mechanics {

/// Three numbers, such as a force or a displacement.
template <class T>
struct Triple {
  T x{}, y{}, z{};

  [[gnu::always_inline]] Triple& operator+=(const Triple& o) noexcept
  {
    x += o.x, y += o.y, z += o.z;
    return *this;
  }
  [[gnu::always_inline]] Triple& operator-=(const Triple& o) noexcept
  {
    x -= o.x, y -= o.y, z -= o.z;
    return *this;
  }
};

/// A symmetric block.
template <class T>
struct SymmetricBlock {
  T xx{}, xy{}, xz{}, yy{}, yz{}, zz{};

  [[gnu::always_inline]] SymmetricBlock& operator+=(const SymmetricBlock& o) noexcept
  {
    xx += o.xx, xy += o.xy, xz += o.xz, yy += o.yy, yz += o.yz, zz += o.zz;
    return *this;
  }
  [[gnu::always_inline]] SymmetricBlock& operator-=(const SymmetricBlock& o) noexcept
  {
    xx -= o.xx, xy -= o.xy, xz -= o.xz, yy -= o.yy, yz -= o.yz, zz -= o.zz;
    return *this;
  }
};

/// A general block, by rows.
template <class T>
struct Block {
  T xx{}, xy{}, xz{}, yx{}, yy{}, yz{}, zx{}, zy{}, zz{};

  [[gnu::always_inline]] Block& operator+=(const Block& o) noexcept
  {
    xx += o.xx, xy += o.xy, xz += o.xz;
    yx += o.yx, yy += o.yy, yz += o.yz;
    zx += o.zx, zy += o.zy, zz += o.zz;
    return *this;
  }
  [[gnu::always_inline]] Block& operator-=(const Block& o) noexcept
  {
    xx -= o.xx, xy -= o.xy, xz -= o.xz;
    yx -= o.yx, yy -= o.yy, yz -= o.yz;
    zx -= o.zx, zy -= o.zy, zz -= o.zz;
    return *this;
  }
};

template <class T>
[[gnu::always_inline]] inline Block<T> transposed(const Block<T>& a) noexcept
{
  return {a.xx, a.yx, a.zx, a.xy, a.yy, a.zy, a.xz, a.yz, a.zz};
}

/// a S
template <class T>
[[gnu::always_inline]] inline Block<T> product(const Block<T>& a,
                                               const SymmetricBlock<T>& s) noexcept
{
  return {a.xx * s.xx + a.xy * s.xy + a.xz * s.xz, a.xx * s.xy + a.xy * s.yy + a.xz * s.yz,
          a.xx * s.xz + a.xy * s.yz + a.xz * s.zz, a.yx * s.xx + a.yy * s.xy + a.yz * s.xz,
          a.yx * s.xy + a.yy * s.yy + a.yz * s.yz, a.yx * s.xz + a.yy * s.yz + a.yz * s.zz,
          a.zx * s.xx + a.zy * s.xy + a.zz * s.xz, a.zx * s.xy + a.zy * s.yy + a.zz * s.yz,
          a.zx * s.xz + a.zy * s.yz + a.zz * s.zz};
}

/// a b^T
template <class T>
[[gnu::always_inline]] inline Block<T> productWithTransposed(const Block<T>& a,
                                                             const Block<T>& b) noexcept
{
  return {a.xx * b.xx + a.xy * b.xy + a.xz * b.xz, a.xx * b.yx + a.xy * b.yy + a.xz * b.yz,
          a.xx * b.zx + a.xy * b.zy + a.xz * b.zz, a.yx * b.xx + a.yy * b.xy + a.yz * b.xz,
          a.yx * b.yx + a.yy * b.yy + a.yz * b.yz, a.yx * b.zx + a.yy * b.zy + a.yz * b.zz,
          a.zx * b.xx + a.zy * b.xy + a.zz * b.xz, a.zx * b.yx + a.zy * b.yy + a.zz * b.yz,
          a.zx * b.zx + a.zy * b.zy + a.zz * b.zz};
}

/// a b^T if the result is known to be symmetric.
template <class T>
[[gnu::always_inline]] inline SymmetricBlock<T> symmetricProduct(const Block<T>& a,
                                                                 const Block<T>& b) noexcept
{
  return {a.xx * b.xx + a.xy * b.xy + a.xz * b.xz, a.xx * b.yx + a.xy * b.yy + a.xz * b.yz,
          a.xx * b.zx + a.xy * b.zy + a.xz * b.zz, a.yx * b.yx + a.yy * b.yy + a.yz * b.yz,
          a.yx * b.zx + a.yy * b.zy + a.yz * b.zz, a.zx * b.zx + a.zy * b.zy + a.zz * b.zz};
}

template <class T>
[[gnu::always_inline]] inline Triple<T> operator*(const SymmetricBlock<T>& s,
                                                  const Triple<T>& v) noexcept
{
  return {s.xx * v.x + s.xy * v.y + s.xz * v.z, s.xy * v.x + s.yy * v.y + s.yz * v.z,
          s.xz * v.x + s.yz * v.y + s.zz * v.z};
}

template <class T>
[[gnu::always_inline]] inline Triple<T> operator*(const Block<T>& a, const Triple<T>& v) noexcept
{
  return {a.xx * v.x + a.xy * v.y + a.xz * v.z, a.yx * v.x + a.yy * v.y + a.yz * v.z,
          a.zx * v.x + a.zy * v.y + a.zz * v.z};
}

/// a^T v
template <class T>
[[gnu::always_inline]] inline Triple<T> transposedTimes(const Block<T>& a,
                                                        const Triple<T>& v) noexcept
{
  return {a.xx * v.x + a.yx * v.y + a.zx * v.z, a.xy * v.x + a.yy * v.y + a.zy * v.z,
          a.xz * v.x + a.yz * v.y + a.zz * v.z};
}

}  // namespace perilymph::mechanics
