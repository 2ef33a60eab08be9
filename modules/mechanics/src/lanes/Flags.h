// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Flags of nodes for kernels: numbers, 1 or 0, so that a comparison of four lanes is stored at once.

#include <algorithm>
#include <cstddef>
#include <vector>

#include "lanes/Lanes.h"

namespace perilymph::mechanics {

using Flags = std::vector<double>;

constexpr double yes = 1.0, no = 0.0;

/// The flag of a comparison, or those of the comparisons in four lanes.
template <class T, class Condition>
PERILYMPH_IN_LANES T flagsOf(const Condition& condition) noexcept
{
  return oneOf(condition, T(T{} + yes), T{});
}

/// The flags of a node, or of four, from bytes.
template <class T>
PERILYMPH_IN_LANES T loadBytes(const std::vector<unsigned char>& from, std::size_t i) noexcept
{
  if constexpr (sizeof(T) == sizeof(double)) {
    return from[i];
  } else {
    using Bytes [[gnu::vector_size(4)]] = unsigned char;
    Bytes bytes;
    std::memcpy(&bytes, from.data() + i, sizeof bytes);
    return __builtin_convertvector(bytes, Four);
  }
}

/// Stores the flag of a node, or of four, as bytes.
PERILYMPH_IN_LANES void storeBytes(double flag, std::vector<unsigned char>& to,
                                   std::size_t i) noexcept
{
  to[i] = flag == yes ? 1 : 0;
}
PERILYMPH_IN_LANES void storeBytes(const Four& flags, std::vector<unsigned char>& to,
                                   std::size_t i) noexcept
{
  using Bytes [[gnu::vector_size(4)]] = unsigned char;
  const Bytes bytes = __builtin_convertvector(flags, Bytes);
  std::memcpy(to.data() + i, &bytes, sizeof bytes);
}

/// Calls a function for each node whose flag is `value`.
template <class Function>
void forEachNode(const Flags& flags, double value, const Function& function) noexcept
{
  const double* at = flags.data();
  std::size_t first = 0;
  for (; first + 4 <= flags.size(); first += 4) {
    const bool isAny = (at[first] == value) | (at[first + 1] == value) | (at[first + 2] == value) |
                       (at[first + 3] == value);
    if (!isAny) continue;
    for (std::size_t i = first; i < first + 4; ++i)
      if (at[i] == value) function(i);
  }
  for (; first < flags.size(); ++first)
    if (at[first] == value) function(first);
}

}  // namespace perilymph::mechanics
