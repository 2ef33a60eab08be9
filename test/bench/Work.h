// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <benchmark/benchmark.h>

#include <algorithm>

#include "perilymph/mechanics/InsertionState.h"

namespace perilymph::bench {

/// Adds to a row what its ticks computed: `evaluations` of all forces in the mean, and the maximum of
/// evaluations and factorizations in one tick.
class Work {
public:
  void add(const mechanics::Readings& readings)
  {
    evaluations_ += readings.evaluations;
    ++ticks_;
    maxEvaluations_ = std::max(maxEvaluations_, readings.evaluations);
    maxFactorizations_ = std::max(maxFactorizations_, readings.factorizations);
  }

  void report(benchmark::State& state) const
  {
    const auto mean = benchmark::Counter::kAvgThreads;
    state.counters["evaluations"] = benchmark::Counter(
        static_cast<double>(evaluations_) / static_cast<double>(std::max(1L, ticks_)), mean);
    state.counters["max_evaluations"] = benchmark::Counter(maxEvaluations_, mean);
    state.counters["max_factorizations"] = benchmark::Counter(maxFactorizations_, mean);
  }

private:
  long evaluations_ = 0, ticks_ = 0;
  int maxEvaluations_ = 0, maxFactorizations_ = 0;
};

}  // namespace perilymph::bench
