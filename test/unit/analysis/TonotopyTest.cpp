// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/analysis/Tonotopy.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <utility>

namespace perilymph::analysis {
namespace {

TEST(GreenwoodFrequency, SpansHumanHearing)
{
  // Greenwood 1990: 20 Hz at the apex, 20,677 Hz at the base
  EXPECT_NEAR(greenwoodFrequency(0.0), 19.85, 0.01);
  EXPECT_NEAR(greenwoodFrequency(1.0), 20'677.0, 1.0);
  EXPECT_EQ(greenwoodFrequency(1.2), greenwoodFrequency(1.0));
}

TEST(SpiralGanglionFrequency, IsThatOfItsTable)
{
  // Stakhovskaya et al. 2007
  for (const auto& [angle_deg, frequency_Hz] :
       {std::pair{0.0, 17225.0}, {90.0, 6193.0}, {270.0, 1539.0}, {360.0, 785.0}, {720.0, 58.0}})
    EXPECT_NEAR(spiralGanglionFrequency(degrees(angle_deg)), frequency_Hz, 1e-9 * frequency_Hz);
}

TEST(SpiralGanglionFrequency, FallsAllTheWayToTheApex)
{
  double last = std::numeric_limits<double>::infinity();
  for (double angle_deg = 0; angle_deg <= 720; angle_deg += 1) {
    const double now = spiralGanglionFrequency(degrees(angle_deg));
    EXPECT_LT(now, last) << angle_deg;
    last = now;
  }
}

TEST(SpiralGanglionFrequency, HasNoCornerInItsTable)
{
  const auto slope = [](double from_deg, double to_deg) {
    return std::log(spiralGanglionFrequency(degrees(to_deg)) /
                    spiralGanglionFrequency(degrees(from_deg))) /
           (to_deg - from_deg);
  };
  for (double angle_deg = 90; angle_deg < 720; angle_deg += 90)
    EXPECT_NEAR(slope(angle_deg - 0.01, angle_deg), slope(angle_deg, angle_deg + 0.01), 1e-5)
        << angle_deg;
}

TEST(SpiralGanglionFrequency, StaysAtItsEnds)
{
  EXPECT_EQ(spiralGanglionFrequency(degrees(-20)), spiralGanglionFrequency(degrees(0)));
  EXPECT_EQ(spiralGanglionFrequency(degrees(900)), spiralGanglionFrequency(degrees(720)));
}

TEST(Semitones, AreTwelveInAnOctave)
{
  EXPECT_NEAR(semitones(100.0, 200.0), 12.0, 1e-12);
  EXPECT_NEAR(semitones(440.0, 220.0), -12.0, 1e-12);
}

}  // namespace
}  // namespace perilymph::analysis
