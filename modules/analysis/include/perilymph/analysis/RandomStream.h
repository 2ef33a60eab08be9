// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Counter-based random numbers: the same seed, item and purpose give the same numbers, independent
// of order, number of threads and machine.

#include <cstdint>

namespace perilymph::analysis {

/// A counter-based random stream: number k is a hash of (seed, item, purpose, k). The hash is the
/// finalizer of SplitMix64 (Steele, Lea and Flood 2014).
class RandomStream {
public:
  /// @param seed     Seed of the whole study.
  /// @param item     Index of the item, such as an insertion.
  /// @param purpose  Use of the numbers; streams of different purposes are independent.
  RandomStream(std::uint64_t seed, std::uint64_t item, std::uint64_t purpose) noexcept;

  /// Uniform in (0, 1), an odd multiple of 2^-54.
  double uniform() noexcept;
  /// Uniform between two limits.
  double between(double low, double high) noexcept { return low + (high - low) * uniform(); }
  /// Standard normal (Box and Muller 1958).
  double normal() noexcept;
  /// Normal, redrawn until it is between low and high; the nearer limit after a thousand attempts.
  double normal(double mean, double standardDeviation, double low, double high) noexcept;

private:
  std::uint64_t key_;
  std::uint64_t count_ = 0;
};

}  // namespace perilymph::analysis
