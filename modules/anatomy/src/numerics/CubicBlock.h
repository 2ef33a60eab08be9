// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// 4 x 4 x 4 coefficients of a uniform tricubic B-spline, summed four at a time.

#include <cstddef>
#include <cstring>

#include "numerics/CubicTable.h"
#include "perilymph/foundation/Four.h"

namespace perilymph::anatomy {

/// Four neighbors along the last axis.
PERILYMPH_IN_LANES Four fourNeighbors(const float* first) noexcept
{
  using FourFloats [[gnu::vector_size(16)]] = float;
  FourFloats values;
  std::memcpy(&values, first, sizeof values);
  return __builtin_convertvector(values, Four);
}

/// Their sum with weights: the first and the third, the second and the fourth, then both.
PERILYMPH_IN_LANES double weighted(const Four& values, const Four& weights) noexcept
{
  const Four products = values * weights;
  return (products[0] + products[2]) + (products[1] + products[3]);
}

/// Value and derivatives of the spline by the indices of its axes: a, p and q, the last contiguous.
struct CubicBlock {
  double value, byA, byP, byQ, byAa, byAp, byAq, byPp, byPq, byQq;

  /// @param corner  The first coefficient.
  /// @param aStep   Stride along a.
  /// @param pStep   Stride along p.
  CubicBlock(const float* corner, std::size_t aStep, std::size_t pStep, const CubicWeights& a,
             const CubicWeights& p, const CubicWeights& q) noexcept
  {
    withLanes([&]() PERILYMPH_KERNEL { set(corner, aStep, pStep, a, p, q); });
  }

private:
  PERILYMPH_IN_LANES void set(const float* corner, std::size_t aStep, std::size_t pStep,
                              const CubicWeights& a, const CubicWeights& p,
                              const CubicWeights& q) noexcept
  {
    Four sum{}, sumByA{}, sumByP{}, sumByAa{}, sumByAp{}, sumByPp{};
    for (std::size_t j = 0; j < 4; ++j) {
      Four here{}, slope{}, bend{};
      for (std::size_t i = 0; i < 4; ++i) {
        const Four row = fourNeighbors(corner + i * aStep + j * pStep);
        here += a.value[i] * row;
        slope += a.slope[i] * row;
        bend += a.bend[i] * row;
      }
      sum += p.value[j] * here;
      sumByP += p.slope[j] * here;
      sumByPp += p.bend[j] * here;
      sumByA += p.value[j] * slope;
      sumByAp += p.slope[j] * slope;
      sumByAa += p.value[j] * bend;
    }
    const Four byValue = load<Four>(q.value, 0), bySlope = load<Four>(q.slope, 0);
    value = weighted(sum, byValue);
    byA = weighted(sumByA, byValue);
    byP = weighted(sumByP, byValue);
    byQ = weighted(sum, bySlope);
    byAa = weighted(sumByAa, byValue);
    byAp = weighted(sumByAp, byValue);
    byAq = weighted(sumByA, bySlope);
    byPp = weighted(sumByPp, byValue);
    byPq = weighted(sumByP, bySlope);
    byQq = weighted(sum, load<Four>(q.bend, 0));
  }
};

}  // namespace perilymph::anatomy
