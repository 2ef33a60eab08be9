// SPDX-License-Identifier: BSD-3-Clause
#include "AxisRange.h"

#include <cmath>

namespace perilymph::charts {
namespace {

/// A curve that only touches a tick must not extend the range to the next one.
constexpr double tolerance = 1e-9;

}  // namespace

double nextNice(double value)
{
  const double power = std::pow(10.0, std::floor(std::log10(value) + tolerance));
  for (const double step : {1.0, 2.0, 5.0, 10.0})
    if (step * power > value * (1.0 + 1e-6)) return step * power;
  return 20.0 * power;
}

AxisRange grown(const AxisRange& start, double low, double high, int maxTicks)
{
  AxisRange range = start;
  const bool growsUp = high > start.high;
  const bool growsDown = low < start.low;
  if (!growsUp && !growsDown) return range;

  const double span = (growsUp ? high : start.high) - (growsDown ? low : start.low);
  while (span / range.tick > maxTicks) range.tick = nextNice(range.tick);
  if (growsUp) range.high = std::ceil(high / range.tick - tolerance) * range.tick;
  if (growsDown) range.low = std::floor(low / range.tick + tolerance) * range.tick;
  return range;
}

std::vector<double> tickPlaces(const AxisRange& range)
{
  std::vector<double> places;
  const double first = std::ceil(range.low / range.tick - tolerance);
  const double last = std::floor(range.high / range.tick + tolerance);
  for (double index = first; index <= last; index += 1.0) places.push_back(index * range.tick);
  return places;
}

}  // namespace perilymph::charts
