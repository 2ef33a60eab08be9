// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Axis ranges that are fixed until a curve exceeds them, then extended by whole ticks.

#include <vector>

namespace perilymph::charts {

/// The range of an axis and the distance between its ticks.
struct AxisRange {
  double low = 0.0;
  double high = 1.0;
  double tick = 1.0;

  friend bool operator==(const AxisRange&, const AxisRange&) = default;
};

/// The range `start`, extended by whole ticks until it contains `low` and `high`. The tick spacing
/// follows the sequence 1, 2, 5 so that there are at most `maxTicks` steps.
AxisRange grown(const AxisRange& start, double low, double high, int maxTicks = 7);

/// The positions of the ticks within the range, multiples of the spacing.
std::vector<double> tickPlaces(const AxisRange& range);

/// The next larger number of the sequence ... 0.1, 0.2, 0.5, 1, 2, 5 ...
double nextNice(double value);

}  // namespace perilymph::charts
