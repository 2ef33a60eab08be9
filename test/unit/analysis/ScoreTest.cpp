// SPDX-License-Identifier: BSD-3-Clause

// The score of insertions whose motion and force are known in closed form.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "perilymph/analysis/Score.h"
#include "perilymph/device/ScriptedDevice.h"
#include "perilymph/session/Insertion.h"
#include "perilymph/session/Scenario.h"

namespace perilymph::analysis {
namespace {

using testing::HasSubstr;

constexpr double tick = 1e-3;  // [s]
constexpr double oneStretch = 0.05 + tick;

/// A motion as pieces of constant speed.
class Course {
public:
  Course& go(double speed_mm_s, double time_s)
  {
    const long ticks = std::lround(time_s / tick);
    for (long i = 0; i < ticks; ++i) {
      now_.time += tick;
      now_.travel += 1e-3 * speed_mm_s * tick;
      now_.device_W[2] -= 1e-3 * speed_mm_s * tick;
      now_.proxy_W[2] = now_.device_W[2] + lag_;
      counter_.add(now_);
    }
    return *this;
  }
  /// The base falls behind the hand, or catches up with it, by this much at once.
  Course& lag(double by_mm)
  {
    lag_ += 1e-3 * by_mm;
    now_.travel -= 1e-3 * by_mm;
    return *this;
  }
  Course& be(haptics::Workflow workflow)
  {
    now_.workflow = workflow;
    return *this;
  }
  Motion motion() const { return counter_.motion(); }

private:
  MotionCounter counter_;
  double lag_ = 0.0;  // [m]
  haptics::TickOutput now_ = [] {
    haptics::TickOutput output;
    output.workflow = haptics::Workflow::inserting;
    return output;
  }();
};

PrintedRange patients() { return {"peak", 0.0448, 0.1024, "Rau et al. 2024"}; }

ComparedInsertion insertion(const Motion& motion, double peak)
{
  ComparedInsertion made;
  made.motion = motion;
  made.arrayPeak.force = peak;
  return made;
}

TEST(TheMotionOfAnInsertion, AtTheSpeedOfTheExperimentIsWithinTheBandAllTheWay)
{
  const Motion motion = Course().go(2.0, 8.0).motion();
  EXPECT_NEAR(motion.wayIn, 16e-3, 2e-3 * oneStretch);
  EXPECT_DOUBLE_EQ(motion.wayInBand, motion.wayIn);
  EXPECT_EQ(motion.timeStill, 0.0);
  EXPECT_EQ(motion.reversals, 0);
}

TEST(TheMotionOfAnInsertion, WeightsExcessiveSpeedByDistanceNotByTime)
{
  // 4 mm at 1 mm/s and 4 mm at 4 mm/s: half of the distance, a fifth of the time
  const Motion motion = Course().go(1.0, 4.0).go(4.0, 1.0).motion();
  EXPECT_NEAR(motion.wayInBand / motion.wayIn, 0.5, 4.0 * oneStretch / 8.0);
}

TEST(TheMotionOfAnInsertion, RestsInAPause)
{
  const Motion motion = Course().go(1.0, 3.0).go(0.0, 1.0).go(1.0, 4.0).motion();
  EXPECT_NEAR(motion.timeStill / motion.time, 1.0 / 8.0, 2.0 * oneStretch / 8.0);
}

TEST(TheMotionOfAnInsertion, DoesNotRestBeforeItsStartOrAfterItsMaximumDepth)
{
  const Motion motion = Course().go(0.0, 2.0).go(1.0, 3.0).go(0.0, 2.0).go(-1.0, 1.0).motion();
  EXPECT_NEAR(motion.timeStill, 0.0, oneStretch);
  EXPECT_NEAR(motion.time, 3.0, 2.0 * oneStretch);
  EXPECT_EQ(motion.reversals, 0);
}

TEST(TheMotionOfAnInsertion, AtFullDepthIsOverHoweverLongItWaitsThere)
{
  Course course;
  course.go(1.0, 10.0);
  const Motion arrived = course.motion();
  course.be(haptics::Workflow::finished).go(0.0, 60.0);
  // withdrawn a little, pushed in again and deeper
  course.be(haptics::Workflow::inserting).go(-1.0, 1.0).go(1.0, 2.0);
  EXPECT_EQ(arrived.timeStill, 0.0);
  EXPECT_NEAR(course.motion().timeStill, 0.0, 2.0 * oneStretch);
  EXPECT_NEAR(course.motion().time, 13.0, 5.0 * oneStretch);
}

TEST(TheMotionOfAnInsertion, GoesAtTheSpeedOfTheHandThoughTheArrayHesitatesAndSpringsOn)
{
  // 0.3 mm late, then at once in its place again: 8 mm/s for one stretch.
  const Motion motion = Course().go(2.0, 2.0).lag(0.3).go(2.0, 2.0).lag(-0.3).go(2.0, 2.0).motion();
  EXPECT_DOUBLE_EQ(motion.wayInBand, motion.wayIn);
  EXPECT_EQ(motion.timeStill, 0.0);
}

/// A scripted insertion of a shipped scenario; its motion.
Motion scripted(const char* name, const session::Overrides& overrides)
{
  MotionCounter counter;
  const auto scenario = session::loadScenario(name, overrides);
  EXPECT_TRUE(scenario) << scenario.error().message;
  if (!scenario) return {};
  auto insertion = session::Insertion::prepare(
      *scenario,
      std::make_unique<device::ScriptedDevice>(scenario->speed().si(), scenario->timeStep().si()),
      std::nullopt);
  EXPECT_TRUE(insertion) << insertion.error().message;
  if (!insertion) return {};
  const auto ran = (*insertion)->runToEnd([&](const haptics::TickRecord& record) {
    counter.add(record.output);
    return true;
  });
  EXPECT_TRUE(ran) << ran.error().message;
  return counter.motion();
}

TEST(AScriptAtTwoMillimetersASecond, IsWithinTheBandAllTheWayWithEveryKindOfArray)
{
  const std::pair<const char*, session::Overrides> runs[] = {
      {"contour-published", {}},
      {"contour-published", {{"technique", "aos"}}},
      {"contour-published", {{"coupling", "spring"}}},
      {"mean-flex28", {{"coupling", "spring"}}},
      {"mean-contour", {{"array", "slim-straight"}, {"technique", "standard"}}}};
  for (const auto& [name, changes] : runs) {
    session::Overrides overrides = changes;
    overrides.push_back({"speed_mm_s", "2.0"});
    overrides.push_back({"nodes", "40"});
    const Motion motion = scripted(name, overrides);
    std::string label = name;
    for (const auto& [key, value] : changes) label += " " + key + "=" + value;
    EXPECT_GT(motion.wayIn, 5e-3) << label;
    EXPECT_DOUBLE_EQ(motion.wayInBand, motion.wayIn) << label;
    EXPECT_EQ(motion.timeStill, 0.0) << label;
    EXPECT_EQ(motion.reversals, 0) << label;
  }
}

TEST(AScriptAtThreeMillimetersASecond, IsAboveTheBandAllTheWay)
{
  const Motion motion = scripted("contour-published", {{"speed_mm_s", "3.0"}, {"nodes", "40"}});
  EXPECT_LT(motion.wayInBand, 0.05 * motion.wayIn);
}

TEST(TheMotionOfAnInsertion, ReversesOnceForOneStepBack)
{
  const Motion motion = Course().go(1.0, 3.0).go(-1.0, 0.5).go(1.0, 3.0).motion();
  EXPECT_EQ(motion.reversals, 1);
}

TEST(AScore, GivesEverythingForSpeedAndMotionOfASteadyInsertion)
{
  const InsertionScore score = scoreOf(insertion(Course().go(1.0, 16.0).motion(), 0.0), patients());
  EXPECT_DOUBLE_EQ(score.total, 100.0);
}

TEST(AScore, GivesHalfThePointsInTheMiddleOfThePeaksInPatients)
{
  const Motion steady = Course().go(1.0, 16.0).motion();
  const double middle = 0.5 * (0.0448 + 0.1024);
  const InsertionScore score = scoreOf(insertion(steady, middle), patients());
  EXPECT_NEAR(score.criteria[2].fraction, 0.5, 1e-12);
  EXPECT_NEAR(score.total, 50.0, 1e-9);
  EXPECT_NEAR(scoreOf(insertion(steady, 2.0 * middle), patients()).criteria[2].fraction, 1.0 / 3.0,
              1e-12);
}

TEST(AScore, IsHigherForTheGentlerOfTwoInsertionsBeyondThePeaksInPatients)
{
  const Motion steady = Course().go(1.0, 16.0).motion();
  EXPECT_GT(scoreOf(insertion(steady, 0.166), patients()).total,
            scoreOf(insertion(steady, 0.200), patients()).total + 0.5);
  EXPECT_GT(scoreOf(insertion(steady, 0.010), patients()).total,
            scoreOf(insertion(steady, 0.030), patients()).total + 0.5);
}

TEST(AScore, IsLowBeyondTheStrengthOfTheMembraneHoweverSteadyTheHand)
{
  // 424 mN: 5.76 times the middle of the peaks in patients, so 1 / (1 + 5.76) of the points
  const Motion steady = Course().go(1.0, 16.0).motion();
  EXPECT_NEAR(scoreOf(insertion(steady, 0.424), patients()).total, 100.0 / 6.7609, 1e-3);
}

TEST(AScore, IsOfAPoorMotionLowThoughTheForceIsNone)
{
  Motion motion = Course().go(1.0, 16.0).motion();
  motion.reversals = 186;          // 1/11 of the points
  motion.timeStill = motion.time;  // 0.157 / 1.157 of them
  EXPECT_NEAR(scoreOf(insertion(motion, 0.0), patients()).total,
              100.0 * std::cbrt(0.157 / (11.0 * 1.157)), 1e-9);
}

TEST(AScore, OfPublishedHandsAndPeaksInPatientsIs31)
{
  Motion motion = Course().go(1.0, 16.0).motion();
  motion.wayBySpeed = motion.wayIn;
  motion.timeStill = 0.157 * motion.time;
  ComparedInsertion made = insertion(motion, 0.0736);
  EXPECT_NEAR(scoreOf(made, patients()).criteria[3].fraction, 0.5, 1e-12);
  made.motion.reversals = 19;
  EXPECT_NEAR(scoreOf(made, patients()).total, 50.0 * std::cbrt(0.5 * 18.6 / 37.6), 1e-9);
  EXPECT_NEAR(scoreOf(made, patients()).total, 31.0, 0.5);
}

TEST(AScore, FallsWithEverySpeedAboveTheRange)
{
  const auto totalAt = [](double speed_mm_s) {
    const Motion motion = Course().go(speed_mm_s, 16.0 / speed_mm_s).motion();
    return scoreOf(insertion(motion, 0.0), patients()).total;
  };
  EXPECT_NEAR(totalAt(4.0), 100.0 * std::cbrt(0.5), 1.0);
  EXPECT_NEAR(totalAt(8.0), 100.0 * std::cbrt(0.25), 1.0);
  EXPECT_GT(totalAt(8.0), totalAt(12.0) + 1.0);
}

TEST(TheMotionOfAnInsertion, HasAMeanSpeedWithItsPauses)
{
  // 6 mm in 3 s, a pause of 1 s, 2 mm in 2 s
  const Motion motion = Course().go(2.0, 3.0).go(0.0, 1.0).go(1.0, 2.0).motion();
  EXPECT_NEAR(motion.meanSpeed(), 8e-3 / 6.0, 0.02 * 8e-3 / 6.0);
  EXPECT_EQ(Motion{}.meanSpeed(), 0.0);
}

TEST(AScore, GivesHalfThePointsAt18Point6Reversals)
{
  Motion motion = Course().go(1.0, 16.0).motion();
  motion.reversals = 2;
  EXPECT_NEAR(scoreOf(insertion(motion, 0.0), patients()).criteria[1].fraction, 18.6 / 20.6, 1e-12);
}

TEST(AScore, NamesNumberBandAndSourceOfEveryCriterion)
{
  const auto score = scoreOf(insertion(Course().go(1.0, 16.0).motion(), 0.06));
  ASSERT_TRUE(score) << score.error().message;
  ASSERT_EQ(score->criteria.size(), 5u);
  for (const ScoreCriterion& criterion : score->criteria) {
    EXPECT_FALSE(criterion.found.empty()) << criterion.name;
    EXPECT_FALSE(criterion.band.empty()) << criterion.name;
    EXPECT_FALSE(criterion.source.empty()) << criterion.name;
    EXPECT_THAT(score->sentence(), HasSubstr(criterion.name));
  }
  EXPECT_THAT(score->criteria[2].source, HasSubstr("Rau"));
}

TEST(AScore, CountsByTheFractionOfTheInsertionThatWasDone)
{
  const Motion steady = Course().go(1.0, 5.0).motion();
  const auto totalAt = [&steady](double travel_mm) {
    ComparedInsertion made = insertion(steady, 0.0);
    made.stopTravel = 20e-3;
    made.profile.curve = {{0.0, 0.0}, {1e-3 * travel_mm, 0.0}};
    return scoreOf(made, patients()).total;
  };
  EXPECT_NEAR(totalAt(5.0), 25.0, 1e-9);
  EXPECT_NEAR(totalAt(19.4), 97.0, 1e-9);
  EXPECT_EQ(totalAt(19.6), 100.0);  // there, as reports say it
  EXPECT_EQ(totalAt(20.0), 100.0);
}

TEST(AScore, WithoutMotionGivesNoPoints)
{
  EXPECT_EQ(scoreOf(insertion({}, 0.0), patients()).criteria[0].fraction, 0.0);
}

}  // namespace
}  // namespace perilymph::analysis
