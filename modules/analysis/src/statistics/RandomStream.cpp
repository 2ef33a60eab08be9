// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/analysis/RandomStream.h"

#include <algorithm>
#include <cmath>

#include "perilymph/foundation/Math.h"
#include "perilymph/foundation/Units.h"

namespace perilymph::analysis {

namespace {

constexpr std::uint64_t goldenStep = 0x9e3779b97f4a7c15u;

std::uint64_t shuffled(std::uint64_t bits) noexcept
{
  bits = (bits ^ (bits >> 30)) * 0xbf58476d1ce4e5b9u;
  bits = (bits ^ (bits >> 27)) * 0x94d049bb133111ebu;
  return bits ^ (bits >> 31);
}

}  // namespace

RandomStream::RandomStream(std::uint64_t seed, std::uint64_t item, std::uint64_t purpose) noexcept
    : key_(shuffled(shuffled(shuffled(seed + goldenStep) + goldenStep * (item + 1)) +
                    goldenStep * (purpose + 1)))
{
}

double RandomStream::uniform() noexcept
{
  ++count_;
  const std::uint64_t bits = shuffled(key_ + goldenStep * count_) >> 11;
  return (static_cast<double>(bits) + 0.5) * 0x1p-53;
}

double RandomStream::normal() noexcept
{
  const double length = std::sqrt(-2.0 * logarithm(uniform()));
  return length * sineCosine(2.0 * pi * uniform()).cosine;
}

double RandomStream::normal(double mean, double standardDeviation, double low, double high) noexcept
{
  double value = mean;
  for (int tries = 0; tries < 1000; ++tries) {
    value = mean + standardDeviation * normal();
    if (value >= low && value <= high) return value;
  }
  return std::clamp(value, low, high);
}

}  // namespace perilymph::analysis
