// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/analysis/StopForce.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace perilymph::analysis {
namespace {

/// The end force of a second of motion with a force over time, and the greatest force in it.
struct EndAndPeak {
  double end = 0.0, peak = 0.0;
};
EndAndPeak ofSecond(const std::function<double(double)>& force)
{
  StopForce stop(seconds(0.5));
  EndAndPeak found;
  for (int i = 0; i <= 1000; ++i) {
    haptics::TickOutput now{};
    now.workflow = haptics::Workflow::inserting;
    now.time = 1e-3 * i;
    now.travel = 1e-6 * i;
    now.axialForce = force(now.time);
    found.peak = std::max(found.peak, now.axialForce);
    stop.add(now);
  }
  found.end = stop.value();
  return found;
}

TEST(StopForce, IsTheEndOfARise)
{
  EXPECT_NEAR(ofSecond([](double time) { return 0.05 * time; }).end, 0.05, 1e-9);
}

TEST(StopForce, IsTheMeanUnderTremor)
{
  // 8 Hz have whole periods in 0.5 s; the line through a sine has a small slope
  const double end =
      ofSecond([](double time) { return 0.03 + 0.01 * std::sin(50.2655 * time); }).end;
  EXPECT_NEAR(end, 0.03, 0.005);
}

TEST(StopForce, IsNeverAboveThePeak)
{
  // rises to a plateau at the end: the line through the last half second ends above it
  const EndAndPeak found = ofSecond([](double time) { return 0.06 * std::min(time, 0.75); });
  EXPECT_LE(found.end, found.peak);
  EXPECT_NEAR(found.end, found.peak, 1e-9);
  const EndAndPeak jagged = ofSecond([](double time) { return time > 0.9 ? 0.04 : 0.06 * time; });
  EXPECT_LE(jagged.end, jagged.peak);
}

}  // namespace
}  // namespace perilymph::analysis
