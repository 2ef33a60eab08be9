#include "Percentiles.h"

#include <algorithm>
#include <cmath>

namespace perilymph::bench {

void Percentiles::report(benchmark::State& state)
{
  if (seconds_.empty()) return;
  std::sort(seconds_.begin(), seconds_.end());
  // The least time that the share of all iterations did not exceed.
  const auto microseconds = [this](double share) {
    const double rank = std::ceil(share * static_cast<double>(seconds_.size()));
    return 1e6 * seconds_[static_cast<std::size_t>(std::max(rank, 1.0)) - 1];
  };
  state.counters["p50_us"] = microseconds(0.5);
  state.counters["p99_us"] = microseconds(0.99);
  state.counters["p999_us"] = microseconds(0.999);
  state.counters["max_us"] = microseconds(1.0);
}

}  // namespace perilymph::bench
