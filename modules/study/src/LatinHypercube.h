// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Latin hypercube sampling (McKay, Beckman and Conover, Technometrics 21, 239, 1979).

#include <cstdint>
#include <vector>

namespace perilymph::study {

/// A random permutation of 0 to count - 1 (Fisher and Yates): the stratum of each sample in one
/// dimension. The same for the same seed and dimension on every machine.
std::vector<std::uint32_t> strataOf(std::uint64_t seed, std::uint64_t dimension, std::size_t count);

/// A value within a sample's stratum of [low, high], uniform.
double sampleIn(double low, double high, std::uint32_t stratum, std::size_t count,
                std::uint64_t seed, std::uint64_t dimension, std::size_t sample);

}  // namespace perilymph::study
