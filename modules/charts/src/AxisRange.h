#pragma once

// Ranges that stand still until a curve leaves them, then grow by whole ticks.

#include <vector>

namespace perilymph::charts {

/// The range of an axis and the distance between its ticks.
struct AxisRange {
  double low = 0.0;
  double high = 1.0;
  double tick = 1.0;

  friend bool operator==(const AxisRange&, const AxisRange&) = default;
};

/// The range `start`, grown by whole ticks until it holds `low` and `high`. The ticks grow with it
/// in the sequence 1, 2, 5 so that there are never more than `maxTicks` steps.
AxisRange grown(const AxisRange& start, double low, double high, int maxTicks = 7);

/// The places of the ticks within the range, multiples of the tick.
std::vector<double> tickPlaces(const AxisRange& range);

/// The next greater number of the sequence ... 0.1, 0.2, 0.5, 1, 2, 5 ...
double nextNice(double value);

}  // namespace perilymph::charts
