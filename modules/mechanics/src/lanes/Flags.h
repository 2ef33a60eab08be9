// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Flags of nodes, 0 or 1, four at a time.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <type_traits>
#include <vector>

#include "lanes/Lanes.h"

namespace perilymph::mechanics {

using Flags [[gnu::vector_size(4)]] = unsigned char;

/// The flag of a comparison, or those of the comparisons in four lanes.
template <class Condition>
PERILYMPH_IN_LANES auto flagsOf(const Condition& condition) noexcept
{
  if constexpr (std::is_arithmetic_v<Condition>)
    return static_cast<unsigned char>(condition != 0 ? 1 : 0);
  else
    return __builtin_convertvector(condition, Flags) & 1;
}

/// Flags that are 1 where the others are 0.
template <class F>
PERILYMPH_IN_LANES F opposite(const F& flags) noexcept
{
  return static_cast<F>(flags ^ 1);
}

/// The flags of a node, or of four: as many as a kernel's T has lanes.
PERILYMPH_IN_LANES unsigned char flagsAt(double, const std::vector<unsigned char>& flags,
                                         std::size_t i) noexcept
{
  return flags.data()[i];
}
PERILYMPH_IN_LANES Flags flagsAt(Four, const std::vector<unsigned char>& flags,
                                 std::size_t i) noexcept
{
  Flags four;
  std::memcpy(&four, flags.data() + i, sizeof four);
  return four;
}

template <class F>
PERILYMPH_IN_LANES void store(const F& value, std::vector<unsigned char>& flags,
                              std::size_t i) noexcept
{
  std::memcpy(flags.data() + i, &value, sizeof value);
}

/// Flags as a condition of oneOf().
PERILYMPH_IN_LANES bool whereSet(unsigned char flag) noexcept { return flag != 0; }
PERILYMPH_IN_LANES auto whereSet(const Flags& flags) noexcept
{
  using Wide [[gnu::vector_size(32)]] = long long;
  return __builtin_convertvector(flags, Wide) != 0;
}

/// Calls a function for each node whose flag is `value`, 0 or 1.
template <class Function>
void forEachNode(const std::vector<unsigned char>& flags, unsigned char value,
                 const Function& function) noexcept
{
  const std::uint32_t none = value != 0 ? 0 : 0x01010101;
  const unsigned char* at = flags.data();
  for (std::size_t first = 0; first < flags.size(); first += 4) {
    const std::size_t end = std::min(first + 4, flags.size());
    std::uint32_t four = ~none;
    if (end == first + 4) std::memcpy(&four, at + first, sizeof four);
    if (four == none) continue;
    for (std::size_t i = first; i < end; ++i)
      if (at[i] == value) function(i);
  }
}

}  // namespace perilymph::mechanics
