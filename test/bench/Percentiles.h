// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <benchmark/benchmark.h>

#include <chrono>
#include <vector>

namespace perilymph::bench {

/// Times each iteration of a benchmark and adds median, 99th and 99.9th percentile and maximum to
/// its row as p50_us, p99_us, p999_us, max_us, because the mean says little about a 1 kHz loop. In
/// rows with several threads each thread has its own, and the row shows their mean.
class Percentiles {
public:
  /// @param most  Number of iterations to reserve, so that adding one does not allocate.
  explicit Percentiles(std::size_t capacity) { seconds_.reserve(capacity); }

  /// Runs one iteration and times it.
  template <class Work>
  void time(const Work& work)
  {
    const auto before = std::chrono::steady_clock::now();
    work();
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - before;
    seconds_.push_back(taken.count());
  }

  void report(benchmark::State& state);

private:
  std::vector<double> seconds_;
};

}  // namespace perilymph::bench
