// SPDX-License-Identifier: BSD-3-Clause
#include "Percentiles.h"

#include <algorithm>
#include <cmath>

namespace perilymph::bench {

void Percentiles::report(benchmark::State& state)
{
  if (seconds_.empty()) return;
  std::sort(seconds_.begin(), seconds_.end());
  // Quantile of the iteration times.
  const auto microseconds = [this](double fraction) {
    const double rank = std::ceil(fraction * static_cast<double>(seconds_.size()));
    return 1e6 * seconds_[static_cast<std::size_t>(std::max(rank, 1.0)) - 1];
  };
  const auto add = [&](const char* name, double fraction) {
    state.counters[name] =
        benchmark::Counter(microseconds(fraction), benchmark::Counter::kAvgThreads);
  };
  add("p50_us", 0.5);
  add("p99_us", 0.99);
  add("p999_us", 0.999);
  add("max_us", 1.0);
}

}  // namespace perilymph::bench
