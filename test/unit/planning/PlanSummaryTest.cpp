// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "perilymph/analysis/Tonotopy.h"
#include "perilymph/planning/ForceCourse.h"
#include "perilymph/planning/PlanSummary.h"
#include "perilymph/test/SyntheticPlan.h"

namespace perilymph::test {
namespace {

using planning::ArrayPlan;

TEST(PlanSummary, GivesTheQuantilesOfEachArraysDraws)
{
  const auto arrays = syntheticPlan(101).arrays;
  ASSERT_EQ(arrays.size(), 2u);
  EXPECT_EQ(arrays[0].draws, 101u);
  EXPECT_NEAR(arrays[0].angle_deg.median, 351.0, 1e-9);
  // the quantile i / (n + 1) is the i-th of 101: 5.1 of 301 ... 401, and 25.5 of 1 ... 101
  EXPECT_NEAR(arrays[0].angle_deg.low, 305.1, 1e-9);
  EXPECT_NEAR(arrays[0].angle_deg.high, 396.9, 1e-9);
  EXPECT_NEAR(arrays[1].angle_deg.low, 500.0, 1e-9);
  EXPECT_NEAR(arrays[0].peak_mN.lowerQuartile, 25.5, 1e-9);
  EXPECT_NEAR(arrays[0].end_mN.upperQuartile, 38.25, 1e-9);
  EXPECT_NEAR(arrays[0].after1s_mN.median, 0.25 * 51.0, 1e-9);
  EXPECT_EQ(arrays[0].after10s_mN.high, 0.0);  // not computed
  EXPECT_NEAR(arrays[0].coverage_percent.median, 50.0, 1e-9);
}

TEST(Band, HoldsNineInTenOfValuesToComeFromNineteenOn)
{
  // expected fraction of a distribution between the i-th and the k-th of n: (k - i) / (n + 1)
  std::vector<double> values;
  for (int i = 1; i <= 19; ++i) values.push_back(i);
  const planning::Band band = planning::bandOf(values);
  EXPECT_NEAR(band.low, 1.0, 1e-12);
  EXPECT_NEAR(band.high, 19.0, 1e-12);
  EXPECT_NEAR((band.high - band.low) / 20.0, 0.9, 1e-12);
  EXPECT_NEAR(band.median, 10.0, 1e-12);
  EXPECT_EQ(planning::bandOf({7.0}).low, 7.0);
  EXPECT_EQ(planning::bandOf({7.0}).high, 7.0);
  EXPECT_EQ(planning::bandOf({}).high, 0.0);
}

TEST(PlanSummary, CountsEveryEnd)
{
  const ArrayPlan array = syntheticPlan(100).arrays[0];
  EXPECT_NEAR(array.full.value, 0.75, 1e-12);
  EXPECT_NEAR(array.resisted.value, 0.25, 1e-12);
  EXPECT_NEAR(array.buckled.value, 0.0, 1e-12);
  EXPECT_GT(array.buckled.high, 0.03);  // none in a hundred is no proof of none
  EXPECT_NEAR(array.ruptured.value, 0.1, 1e-12);
  EXPECT_NEAR(array.allInside.value, 0.5, 1e-12);  // both contacts in every second draw
}

TEST(PlanSummary, LeavesAnInsertionThatCouldNotBePreparedOutOfTheBandsButNotOutOfTheCount)
{
  auto insertions = syntheticInsertions(100);
  insertions[0].insertion = {};  // refused, without values
  const auto arrays = planning::summarize(syntheticPlan(1).request, plannedArrays(),
                                          publishedThresholds(), insertions);
  EXPECT_NEAR(arrays[0].other.value, 0.01, 1e-12);
  EXPECT_GT(arrays[0].angle_deg.low, 304.0);  // not the 0 of the first
}

TEST(PlanSummary, GivesTheForceAsDeepAsAnySimulationWent)
{
  const auto arrays = syntheticPlan(101).arrays;
  ASSERT_EQ(arrays[0].force.size(), 4u);
  EXPECT_EQ(arrays[0].force[3].draws, 10u);
  EXPECT_NEAR(arrays[0].force[3].depth_mm, 1.5, 1e-12);
  EXPECT_NEAR(arrays[0].force[3].force_mN.median, 5.5, 1e-9);
  EXPECT_EQ(arrays[1].force.size(), 3u);
  // two simulations have a curve, and it is of two
  const ArrayPlan few = syntheticPlan(2).arrays[0];
  ASSERT_EQ(few.force.size(), 4u);
  EXPECT_EQ(few.force[3].draws, 2u);
  EXPECT_NEAR(few.force[3].force_mN.median, 1.5, 1e-9);
  auto insertions = syntheticInsertions(16);
  insertions[6].insertion.profile.push_back({millimeters(2.0), millinewtons(9.0)});
  const auto alone = planning::summarize(syntheticPlan(1).request, plannedArrays(),
                                         publishedThresholds(), insertions)[0];
  ASSERT_EQ(alone.force.size(), 5u);
  EXPECT_EQ(alone.force[4].draws, 1u);
  EXPECT_NEAR(alone.force[4].force_mN.high, 9.0, 1e-9);
}

TEST(ForceCourse, SaysWhereSimulationsEndedAndHowManyGoOn)
{
  ArrayPlan plan;
  plan.draws = 16;
  for (const auto& [depth_mm, draws] : {std::pair{1.0, 15u},
                                        {1.5, 16u},
                                        {2.0, 16u},
                                        {2.5, 14u},
                                        {3.0, 12u},
                                        {3.5, 5u},
                                        {4.0, 5u},
                                        {4.5, 1u}})
    plan.force.push_back({depth_mm, draws, {0.0, 1.0, depth_mm, 3.0, 9.0}});
  const planning::ForceCourse course = planning::courseOf(plan);
  EXPECT_EQ(course.whole, 3u);  // to 2.0 mm; the first row is before the start of one of them
  const auto depths = [](const std::vector<planning::ForceCourse::Mark>& marks) {
    std::vector<double> all;
    for (const auto& each : marks) all.push_back(each.depth_mm);
    return all;
  };
  EXPECT_EQ(depths(course.ends), (std::vector<double>{2.0, 2.5, 3.0, 4.0, 4.5}));
  // 12 of 16 go on behind 2.5 mm, 5 behind 3.0, 1 behind 4.0, none behind 4.5
  EXPECT_EQ(depths(course.counts), (std::vector<double>{2.5, 3.0, 4.0, 4.5}));
  EXPECT_EQ(course.counts.back().draws, 1u);
  EXPECT_TRUE(planning::courseOf({}).ends.empty());
}

TEST(PlanSummary, CountsAContactWhereItIsInserted)
{
  const ArrayPlan array = syntheticPlan(101).arrays[0];
  ASSERT_EQ(array.contacts.size(), 2u);
  EXPECT_EQ(array.contacts[0].draws, 101u);
  EXPECT_EQ(array.contacts[1].draws, 51u);
  EXPECT_NEAR(array.contacts[0].toModiolus_mm.median, 1.0, 1e-12);
  EXPECT_NEAR(array.contacts[0].greenwood_Hz, analysis::greenwoodFrequency(0.5), 1e-9);
}

TEST(PlanSummary, LeavesOutDistancesWhereNoLumenLiesTowardTheModiolus)
{
  auto insertions = syntheticInsertions(20);
  for (std::size_t i = 0; i < 10; ++i)
    insertions[i].insertion.contacts.at(0).toModiolus = millimeters(-1000.0);
  const auto arrays = planning::summarize(syntheticPlan(1).request, plannedArrays(),
                                          publishedThresholds(), insertions);
  EXPECT_EQ(arrays[0].contacts[0].draws, 20u);
  EXPECT_GT(arrays[0].contacts[0].toModiolus_mm.low, 0.0);
}

TEST(PlanSummary, GivesTheMismatchOfPlaceAndFilterInSemitones)
{
  const auto arrays = syntheticPlan(101).arrays;
  const planning::ContactBand& apical = arrays[0].contacts[0];
  EXPECT_EQ(apical.filter_Hz, 100.0);
  // the median draw: 351 degrees
  const double octaves = std::log2(analysis::spiralGanglionFrequency(degrees(351.0)) / 100.0);
  EXPECT_NEAR(apical.mismatch_semitones.median, 12.0 * octaves, 1e-9);
  // a deeper contact has a lower place frequency
  EXPECT_LT(apical.mismatch_semitones.low, apical.mismatch_semitones.high);
  EXPECT_EQ(arrays[1].contacts[0].filter_Hz, 0.0);
  EXPECT_EQ(arrays[1].contacts[0].mismatch_semitones.high, 0.0);
}

TEST(PlanSummary, CountsTheDrawsThatReachThePublishedStrengthsOfThePartition)
{
  const ArrayPlan array = syntheticPlan(200).arrays[0];
  EXPECT_NEAR(array.reachesWeakest.value, 159.0 / 200.0, 1e-12);   // 42 to 200 mN
  EXPECT_NEAR(array.reachesStrongest.value, 79.0 / 200.0, 1e-12);  // 122 to 200 mN
}

TEST(PlanSummary, FindsTheFirstResistanceBetweenThePointsOfTheProfile)
{
  auto insertions = syntheticInsertions(10);
  for (auto& each : insertions) {
    each.insertion.profile.clear();
    for (const double depth_mm : {0.0, 0.5, 1.0})
      each.insertion.profile.push_back(
          {millimeters(depth_mm), millinewtons(each.draw % 2 == 0 ? 40.8 * depth_mm : 0.0)});
  }
  const auto arrays = planning::summarize(syntheticPlan(1).request, plannedArrays(),
                                          publishedThresholds(), insertions);
  EXPECT_NEAR(arrays[0].felt.value, 0.5, 1e-12);  // odd draws feel nothing
  EXPECT_NEAR(arrays[0].firstResistance_mm.low, 0.5, 1e-9);
  EXPECT_NEAR(arrays[0].firstResistance_mm.high, 0.5, 1e-9);
}

TEST(PlanSummary, RanksWhatExplainsTheAngle)
{
  const auto arrays = syntheticPlan(101).arrays;
  EXPECT_EQ(arrays[0].influences.front().input, "A");
  EXPECT_NEAR(arrays[0].influences.front().onAngle, 1.0, 1e-9);
  EXPECT_NEAR(arrays[0].influences.front().onPeak, 1.0, 1e-9);
  // an angle that does not vary is explained by nothing
  for (const auto& each : arrays[1].influences) EXPECT_EQ(each.onAngle, 0.0) << each.input;
}

TEST(PlanSummary, GivesNoInfluencesWhereChanceDecidesThemAndNeverMoreThanAllOfTheVariance)
{
  EXPECT_TRUE(syntheticPlan(63).arrays[0].influences.empty());
  // two inputs that were drawn alike by chance: each alone would explain all
  auto insertions = syntheticInsertions(64);
  for (auto& each : insertions) each.b_mm = each.a_mm;
  const auto arrays = planning::summarize(syntheticPlan(1).request, plannedArrays(),
                                          publishedThresholds(), insertions);
  ASSERT_FALSE(arrays[0].influences.empty());
  double angle = 0.0, peak = 0.0;
  for (const auto& each : arrays[0].influences) {
    angle += each.onAngle;
    peak += each.onPeak;
  }
  EXPECT_NEAR(angle, 1.0, 1e-12);
  EXPECT_NEAR(peak, 1.0, 1e-12);
}

TEST(PlanSummary, SaysHowWideABandWereWithAnInputKnownOrMeasuredBetter)
{
  // the angle is the sum of two independent, equally wide inputs: each explains half its variance
  auto insertions = syntheticInsertions(20 * 20);
  for (auto& each : insertions) {
    const auto a = static_cast<double>((each.draw - 1) % 20),
               b = static_cast<double>((each.draw - 1) / 20);
    each.a_mm = 9.0 + 0.01 * a;
    each.b_mm = 6.5 + 0.01 * b;
    each.insertion.apical = degrees(300.0 + a + b);
  }
  const auto arrays = planning::summarize(syntheticPlan(1).request, plannedArrays(),
                                          publishedThresholds(), insertions);
  const double width = arrays[0].angle_deg.high - arrays[0].angle_deg.low;
  const auto& influences = arrays[0].influences;
  const auto b = std::find_if(influences.begin(), influences.end(),
                              [](const auto& each) { return each.input == "B"; });
  ASSERT_NE(b, influences.end());
  EXPECT_NEAR(b->onAngle, 0.5, 0.03);  // of ranks, which are nearly linear here
  EXPECT_NEAR(b->angleWidth_deg, width * std::sqrt(0.5), 0.03 * width);
  // its error of 0.2 mm halved: a quarter of its half of the variance remains
  EXPECT_NEAR(b->finerAngleWidth_deg, width * std::sqrt(0.625), 0.03 * width);
  const auto a = std::find_if(influences.begin(), influences.end(),
                              [](const auto& each) { return each.input == "A"; });
  EXPECT_EQ(a->finerAngleWidth_deg, 0.0);  // known to 0.1 mm already
}

TEST(PlanSummary, FindsThatBandsStandWhereTheirEdgesAreKnown)
{
  // quantiles of a normal distribution in a mixed order, so that every part of them is like the whole
  const auto plan = [](std::size_t draws, double spread_deg, double last_deg) {
    planning::Plan made = syntheticPlan(draws);
    for (auto& each : made.insertions) {
      const double place = static_cast<double>(each.draw) / static_cast<double>(draws + 1);
      const double deviate = std::log(place / (1.0 - place)) / 1.7;  // logistic, nearly normal
      each.insertion.apical = degrees(400.0 + spread_deg * deviate);
      each.insertion.peak = millinewtons(80.0 + deviate);
      if (each.draw > draws - draws / 10) each.insertion.apical = degrees(last_deg);
    }
    planning::addSummary(made, plannedArrays());
    return made;
  };
  EXPECT_FALSE(planning::hasConverged(plan(63, 1.0, 403.0)));  // no band yet, however narrow
  EXPECT_TRUE(planning::hasConverged(plan(64, 1.0, 403.0)));
  // one in ten far above: the upper edge lies among them, the lower one at the end of a long tail
  EXPECT_TRUE(planning::hasConverged(plan(64, 40.0, 700.0)));
  EXPECT_FALSE(planning::hasConverged(syntheticPlan(16)));
}

TEST(PlanSummary, GoesOnWhereAnEdgeIsWideThoughTheMedianIsKnown)
{
  // three in 64 insertions end far below: the 5 % quantile may be on either side of the gap
  planning::Plan plan = syntheticPlan(64);
  for (auto& each : plan.insertions) {
    each.insertion.apical =
        degrees(each.draw <= 3 ? 100.0 : 400.0 + 0.1 * static_cast<double>(each.draw));
    each.insertion.peak = millinewtons(80.0);
  }
  planning::addSummary(plan, plannedArrays());
  EXPECT_FALSE(planning::hasConverged(plan));
}

}  // namespace
}  // namespace perilymph::test
