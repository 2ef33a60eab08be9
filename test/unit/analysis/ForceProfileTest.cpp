// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/analysis/ForceProfile.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace perilymph::analysis {
namespace {

/// An insertion along x at 2 mm/s whose axial force is a function of travel [m -> N].
haptics::TickRecord tickAt(double travel, double force)
{
  haptics::TickRecord record;
  record.output.workflow = haptics::Workflow::inserting;
  record.output.travel = travel;
  record.output.depth = travel + 2e-3;
  record.output.time = travel / 2e-3;
  record.output.axialForce = force;
  record.output.proxy_W = {travel, 0.0, 0.0};
  record.output.force_W = {-force, 0.0, 0.0};  // the array pushes back
  return record;
}

ForceProfile profileOf(const std::function<double(double)>& force, double stop = 16.5e-3)
{
  ForceProfiler profiler;
  const int ticks = static_cast<int>(std::lround(stop / 2e-6));
  for (int i = 0; i <= ticks; ++i) profiler.add(tickAt(2e-6 * i, force(2e-6 * i)));
  return profiler.profile();
}

/// The tick before it, a time later, after the insertion has ended.
haptics::TickRecord restAfter(haptics::TickRecord record, double time, double force)
{
  record.output.workflow = haptics::Workflow::finished;
  record.output.time += time;
  record.output.axialForce = force;
  return record;
}

TEST(ForceAtTheStop, IsWhereAStraightRampEnds)
{
  ForceProfiler profiler;
  haptics::TickRecord last;
  for (int i = 0; i <= 8000; ++i) profiler.add(last = tickAt(2e-6 * i, 1e-5 * i));
  last.output.time += 1e-3;
  profiler.add(last = restAfter(last, 0.0, 0.08));
  // a mean over the half second would be 2.5 mN less, below the force at rest
  EXPECT_NEAR(profiler.profile().endForce, 0.08, 1e-12);
  EXPECT_FALSE(profiler.profile().forceAfter1s);
  for (int i = 1; i <= 500; ++i) profiler.add(restAfter(last, 1e-3 * i, 0.079));
  for (int i = 501; i < 1000; ++i) profiler.add(restAfter(last, 1e-3 * i, 0.078));
  EXPECT_FALSE(profiler.profile().forceAfter1s);
  profiler.add(restAfter(last, 1.0, 0.078));
  ASSERT_TRUE(profiler.profile().forceAfter1s);
  EXPECT_NEAR(*profiler.profile().forceAfter1s, 0.078, 1e-12);
  for (int i = 1001; i < 3000; ++i) profiler.add(restAfter(last, 1e-3 * i, 0.01));
  EXPECT_NEAR(*profiler.profile().forceAfter1s, 0.078, 1e-12);
  EXPECT_NEAR(profiler.profile().endForce, 0.08, 1e-12);
}

TEST(ForceAtTheStop, IsTheMeanOfASteadyForceWithTremor)
{
  // four periods of 8 Hz in the half second: the sum over them is 0, and a line through a sine ends
  // within 12 / (2 pi 4) of half its amplitude
  ForceProfiler profiler;
  constexpr double amplitude = 0.005;
  for (int i = 0; i <= 8000; ++i)
    profiler.add(tickAt(2e-6 * i, 0.04 + amplitude * std::sin(2.0 * M_PI * 8.0 * 1e-3 * i)));
  EXPECT_NEAR(profiler.profile().endForce, 0.04, 0.5 * amplitude * 12.0 / (2.0 * M_PI * 4.0));
}

TEST(ForceAtTheStop, IsOfTheMotionHoweverLongTheHandPausedBeforeItsEnd)
{
  const auto withPause = [](int pause) {
    ForceProfiler profiler;
    haptics::TickRecord last;
    for (int i = 0; i <= 7900; ++i) profiler.add(last = tickAt(2e-6 * i, 1e-5 * i));
    for (int i = 1; i <= pause; ++i) {
      haptics::TickRecord held = last;
      held.output.workflow = haptics::Workflow::paused;
      held.output.time += 1e-3 * i;
      held.output.axialForce = 0.0;
      profiler.add(held);
    }
    for (int i = 7901; i <= 8000; ++i) {
      haptics::TickRecord on = tickAt(2e-6 * i, 1e-5 * i);
      on.output.time += 1e-3 * pause;
      profiler.add(on);
    }
    return profiler.profile().endForce;
  };
  EXPECT_NEAR(withPause(0), 0.08, 1e-12);
  EXPECT_NEAR(withPause(3000), 0.08, 2e-5);  // the first tick after the pause is none of the motion
}

TEST(ForcesOfARest, AreThoseAtTheMaximumDepthWhereTheInsertionHasNotEnded)
{
  ForceProfiler profiler;
  for (int i = 0; i <= 8000; ++i) profiler.add(tickAt(2e-6 * i, 0.04));
  for (int i = 8000; i >= 4000; --i) profiler.add(tickAt(2e-6 * i, -0.02));
  EXPECT_NEAR(profiler.profile().endForce, 0.04, 1e-12);
  EXPECT_FALSE(profiler.profile().forceAfter1s);
}

TEST(ForcesOfARest, AreNotThoseOfAWithdrawal)
{
  ForceProfiler profiler;
  haptics::TickRecord last;
  for (int i = 0; i <= 8000; ++i) profiler.add(last = tickAt(2e-6 * i, 0.04));
  for (int i = 1; i <= 500; ++i) profiler.add(restAfter(last, 1e-3 * i, 0.03));
  for (int i = 501; i <= 2000; ++i) {
    haptics::TickRecord back = restAfter(last, 1e-3 * i, -0.02);
    back.output.workflow = haptics::Workflow::inserting;
    profiler.add(back);
  }
  for (int i = 2001; i <= 4000; ++i) profiler.add(restAfter(last, 1e-3 * i, 0.0));
  EXPECT_NEAR(profiler.profile().endForce, 0.04, 1e-4);
  EXPECT_FALSE(profiler.profile().forceAfter1s);
}

TEST(WorkOfTheHand, IsHalfTheStiffnessTimesTheDistanceSquaredForASpring)
{
  constexpr double stiffness = 10.0;  // [N/m]
  const ForceProfile profile = profileOf([](double x) { return stiffness * x; });
  // The trapezoidal rule is exact for a straight line; the rest is rounding.
  EXPECT_NEAR(profile.work, 0.5 * stiffness * 16.5e-3 * 16.5e-3, 1e-12);
}

TEST(WorkOfTheHand, IsReturnedWhenASpringIsReleased)
{
  ForceProfiler profiler;
  for (int i = 0; i <= 1000; ++i) profiler.add(tickAt(1e-5 * i, 1e-4 * i));
  for (int i = 1000; i >= 0; --i) profiler.add(tickAt(1e-5 * i, 1e-4 * i));
  EXPECT_NEAR(profiler.profile().work, 0.0, 1e-15);
}

TEST(WorkOfTheHand, ExcludesTheResetOfTheArray)
{
  ForceProfiler profiler;
  for (int i = 0; i <= 100; ++i) profiler.add(tickAt(1e-5 * i, 0.1));
  haptics::TickRecord idle = tickAt(0.0, 0.0);
  idle.output.workflow = haptics::Workflow::idle;
  profiler.add(idle);
  profiler.add(tickAt(0.0, 0.1));
  EXPECT_NEAR(profiler.profile().work, 0.1 * 1e-3, 1e-15);
}

TEST(ForceCurve, HasAPointEveryTenthOfAMillimeter)
{
  const ForceProfile profile = profileOf([](double x) { return 3.0 * x; });
  ASSERT_EQ(profile.curve.size(), 166u);  // 0 to 16.5 mm, ends included
  for (std::size_t i = 0; i < profile.curve.size(); ++i) {
    EXPECT_NEAR(profile.curve[i].travel, 1e-4 * static_cast<double>(i), 1e-12);
    EXPECT_NEAR(profile.curve[i].force, 3.0 * profile.curve[i].travel, 1e-9);
  }
}

TEST(ForceCurve, JoinsTicksThatAreFarApartByStraightLines)
{
  ForceProfiler profiler;
  profiler.add(tickAt(0.0, 0.0));
  profiler.add(tickAt(1e-3, 0.1));
  const ForceProfile profile = profiler.profile();
  ASSERT_EQ(profile.curve.size(), 11u);
  EXPECT_NEAR(profile.curve[3].force, 0.03, 1e-12);
}

TEST(ForceCurve, KeepsTheFirstPassWhenTheHandGoesBackAndForth)
{
  ForceProfiler profiler;
  for (int i = 0; i <= 100; ++i) profiler.add(tickAt(1e-5 * i, 0.1));
  for (int i = 100; i >= 0; --i) profiler.add(tickAt(1e-5 * i, -0.5));
  for (int i = 0; i <= 200; ++i) profiler.add(tickAt(1e-5 * i, 0.2));
  const ForceProfile profile = profiler.profile();
  ASSERT_EQ(profile.curve.size(), 21u);
  EXPECT_DOUBLE_EQ(profile.curve[5].force, 0.1);
  EXPECT_DOUBLE_EQ(profile.curve[15].force, 0.2);
}

TEST(Peak, IsTheGreatestForceOfAnyTick)
{
  const ForceProfile profile =
      profileOf([](double x) { return 0.1 - 1e3 * (x - 7e-3) * (x - 7e-3); });
  EXPECT_NEAR(profile.peak.travel, 7e-3, 2e-6);
  EXPECT_NEAR(profile.peak.force, 0.1, 1e-9);
  EXPECT_NEAR(profile.peakDepth, 9e-3, 2e-6);
}

/// The published curve as three straight lines: up to 0.088 N at 10.6 mm, down to 0.0807 N at
/// 11.8 mm, up to 0.1509 N at 15.4 mm and beyond.
double publishedLike(double x)
{
  if (x < 10.6e-3) return 0.0880 * x / 10.6e-3;
  if (x < 11.8e-3) return 0.0880 + (x - 10.6e-3) * (0.0807 - 0.0880) / 1.2e-3;
  return 0.0807 + (x - 11.8e-3) * (0.1509 - 0.0807) / 3.6e-3;
}

TEST(BasalTurn, IsFoundWhereThePublishedCurveHasIt)
{
  const ForceProfile profile = profileOf(publishedLike);
  ASSERT_TRUE(profile.basalTurnPeak);
  ASSERT_TRUE(profile.basalTurnDip);
  // The mean over 0.5 mm rounds a corner: at most one grid point, 5 % of the force.
  EXPECT_NEAR(profile.basalTurnPeak->travel, 10.6e-3, 0.11e-3);
  EXPECT_NEAR(profile.basalTurnPeak->force, 0.0880, 0.05 * 0.0880);
  EXPECT_NEAR(profile.basalTurnDip->travel, 11.8e-3, 0.11e-3);
  EXPECT_NEAR(profile.basalTurnDip->force, 0.0807, 0.05 * 0.0807);
}

TEST(BasalTurn, IsNotInventedOnACurveThatOnlyRises)
{
  const ForceProfile profile = profileOf([](double x) { return 8.0 * x; });
  EXPECT_FALSE(profile.basalTurnPeak);
  EXPECT_FALSE(profile.basalTurnDip);
}

TEST(BasalTurn, IsNotLookedForOutsideItsWindow)
{
  // maxima at 5 and 15 mm only
  const ForceProfile profile = profileOf([](double x) {
    return 0.1 * std::exp(-std::pow((x - 5e-3) / 1e-3, 2)) +
           0.1 * std::exp(-std::pow((x - 15e-3) / 1e-3, 2));
  });
  EXPECT_FALSE(profile.basalTurnPeak);
}

TEST(BasalTurn, IsNotMadeByTheNoiseOfSingleTicks)
{
  // a slope of 8 N/m with 1 mN of noise at every grid point: smoothing over 0.5 mm removes it
  std::vector<CurvePoint> curve;
  for (int i = 0; i <= 165; ++i)
    curve.push_back({1e-4 * i, 8e-4 * i + (i % 2 == 0 ? 1e-3 : -1e-3)});
  EXPECT_FALSE(findBasalTurn(curve).peak);
}

TEST(BasalTurn, TakesAnEmptyCurve) { EXPECT_FALSE(findBasalTurn({}).peak); }

}  // namespace
}  // namespace perilymph::analysis
