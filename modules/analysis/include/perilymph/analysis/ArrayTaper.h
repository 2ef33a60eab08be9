// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The taper of an array whose file states a range of it: drawn alike by plans and by the clinical table.

#include <cstdint>

#include "perilymph/analysis/RandomStream.h"

namespace perilymph::analysis {

/// A place in the range of electrode::TaperRange, from 0, the thinnest, to 1, the thickest, uniform: that of
/// item `number` of a seed, the same for all arrays.
inline double drawTaper(std::uint64_t seed, std::uint64_t number)
{
  constexpr std::uint64_t purpose = 300;  // apart from those of surgeons and plans
  return RandomStream(seed, number, purpose).uniform();
}

}  // namespace perilymph::analysis
