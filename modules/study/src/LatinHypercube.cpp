// SPDX-License-Identifier: BSD-3-Clause
#include "LatinHypercube.h"

#include <algorithm>
#include <numeric>

#include "perilymph/analysis/RandomStream.h"

namespace perilymph::study {

namespace {

// Purposes of random streams; those of the validation are below 100.
constexpr std::uint64_t permuting = 100, placing = 101;

}  // namespace

std::vector<std::uint32_t> strataOf(std::uint64_t seed, std::uint64_t dimension, std::size_t count)
{
  std::vector<std::uint32_t> strata(count);
  std::iota(strata.begin(), strata.end(), 0u);
  analysis::RandomStream random(seed, dimension, permuting);
  for (std::size_t i = count; i > 1; --i) {
    const auto other = static_cast<std::size_t>(random.uniform() * static_cast<double>(i));
    std::swap(strata[i - 1], strata[std::min(other, i - 1)]);
  }
  return strata;
}

double sampleIn(double low, double high, std::uint32_t stratum, std::size_t count,
                std::uint64_t seed, std::uint64_t dimension, std::size_t sample)
{
  analysis::RandomStream random(seed, dimension * 0x1'0000'0000u + sample, placing);
  const double place = (stratum + random.uniform()) / static_cast<double>(count);
  return low + place * (high - low);
}

}  // namespace perilymph::study
