#pragma once

// Random numbers that belong to a place, not to an order: the same seed, insertion and purpose give
// the same numbers whatever else is drawn, on every machine and in any number of threads.

#include <cstdint>

namespace perilymph::analysis {

/// A stream of random numbers, counted: number k is a hash of (seed, item, purpose, k). The hash is
/// the finalizer of SplitMix64 (Steele, Lea and Flood 2014).
class RandomStream {
public:
  /// @param seed     Of the whole study.
  /// @param item     Which of many alike: the number of an insertion.
  /// @param purpose  What the numbers are for; streams of two purposes are independent.
  RandomStream(std::uint64_t seed, std::uint64_t item, std::uint64_t purpose) noexcept;

  /// Uniform in (0, 1), an odd multiple of 2^-54.
  double uniform() noexcept;
  /// Uniform between two values.
  double between(double low, double high) noexcept { return low + (high - low) * uniform(); }
  /// Standard normal (Box and Muller 1958).
  double normal() noexcept;
  /// Normal, drawn again until it lies within low and high; the nearer limit after a thousand
  /// misses.
  double normal(double mean, double standardDeviation, double low, double high) noexcept;

private:
  std::uint64_t key_;
  std::uint64_t count_ = 0;
};

}  // namespace perilymph::analysis
