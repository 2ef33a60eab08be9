// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// 4 x 4 x 4 coefficients of a uniform tricubic B-spline, summed four at a time.

#include <cstddef>
#include <cstring>

#include "numerics/CubicTable.h"

namespace perilymph::anatomy {

/// Four neighbors along the last axis, in two SSE2 registers, which every x86-64 processor has.
struct FourNeighbors {
  using Two [[gnu::vector_size(16)]] = double;

  Two low{}, high{};

  /// Adds weight times four consecutive values.
  void add(double weight, const FourNeighbors& other) noexcept
  {
    low += weight * other.low;
    high += weight * other.high;
  }
  static FourNeighbors load(const float* first) noexcept
  {
    const double values[4] = {first[0], first[1], first[2], first[3]};
    FourNeighbors four;
    std::memcpy(&four.low, values, sizeof four.low);
    std::memcpy(&four.high, values + 2, sizeof four.high);
    return four;
  }
  double weighted(const double weights[4]) const noexcept
  {
    const Two sums = low * Two{weights[0], weights[1]} + high * Two{weights[2], weights[3]};
    return sums[0] + sums[1];
  }
};

/// Value and derivatives of the spline by the indices of its axes: a, p and q, the last contiguous.
struct CubicBlock {
  double value, byA, byP, byQ, byAa, byAp, byAq, byPp, byPq, byQq;

  /// @param corner  The first coefficient.
  /// @param aStep   Stride along a.
  /// @param pStep   Stride along p.
  CubicBlock(const float* corner, std::size_t aStep, std::size_t pStep, const CubicWeights& a,
             const CubicWeights& p, const CubicWeights& q) noexcept
  {
    FourNeighbors sum, sumByA, sumByP, sumByAa, sumByAp, sumByPp;
    for (std::size_t j = 0; j < 4; ++j) {
      FourNeighbors here, slope, bend;
      for (std::size_t i = 0; i < 4; ++i) {
        const FourNeighbors row = FourNeighbors::load(corner + i * aStep + j * pStep);
        here.add(a.value[i], row);
        slope.add(a.slope[i], row);
        bend.add(a.bend[i], row);
      }
      sum.add(p.value[j], here);
      sumByP.add(p.slope[j], here);
      sumByPp.add(p.bend[j], here);
      sumByA.add(p.value[j], slope);
      sumByAp.add(p.slope[j], slope);
      sumByAa.add(p.value[j], bend);
    }
    value = sum.weighted(q.value);
    byA = sumByA.weighted(q.value);
    byP = sumByP.weighted(q.value);
    byQ = sum.weighted(q.slope);
    byAa = sumByAa.weighted(q.value);
    byAp = sumByAp.weighted(q.value);
    byAq = sumByA.weighted(q.slope);
    byPp = sumByPp.weighted(q.value);
    byPq = sumByP.weighted(q.slope);
    byQq = sum.weighted(q.bend);
  }
};

}  // namespace perilymph::anatomy
