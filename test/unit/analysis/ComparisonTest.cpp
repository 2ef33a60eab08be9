// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/analysis/ComparisonGroups.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <sstream>

namespace perilymph::analysis {
namespace {

int reversalsOf(const std::vector<double>& travels_mm)
{
  ReversalCounter counter;
  for (const double travel_mm : travels_mm) counter.add(travel_mm * 1e-3);
  return counter.reversals();
}

TEST(Reversals, CountChangesOfDirection)
{
  EXPECT_EQ(reversalsOf({0, 1, 2, 3}), 0);
  EXPECT_EQ(reversalsOf({0, 2, 1, 3}), 1);  // one withdrawal, from 2 to 1 mm
  EXPECT_EQ(reversalsOf({0, 2, 1, 3, 2, 4, 1}), 3);
  EXPECT_EQ(reversalsOf({0, -1, 0}), 0);  // nothing had been inserted
}

TEST(Reversals, DoNotCountTremor)
{
  // The tremor of a resting hand, 49 um rms, is below a tenth of a millimeter.
  EXPECT_EQ(reversalsOf({0, 1.0, 0.95, 1.0, 0.94, 1.02, 2.0}), 0);
  // A slow withdrawal counts, however small its steps.
  EXPECT_EQ(reversalsOf({0, 1.0, 0.97, 0.94, 0.91, 0.88}), 1);
}

ComparedInsertion insertion(const std::string& name, std::vector<CurvePoint> curve)
{
  ComparedInsertion compared;
  compared.name = name;
  compared.profile.curve = std::move(curve);
  return compared;
}

TEST(CurvesOfRecordings, ShareOneAxisAndKeepGaps)
{
  const std::string csv = curvesCsv(
      {insertion("a", {{0.1e-3, 0.5}, {0.2e-3, 0.25}}), insertion("b, c", {{0.2e-3, 1}})});
  EXPECT_EQ(csv, "travel_mm,a_N,\"b, c_N\"\n0.1,0.5,\n0.2,0.25,1\n");
}

TEST(ComparedRecordings, StateTheRuptureOfThePartition)
{
  auto whole = insertion("a", {}), torn = whole;
  torn.translocation = haptics::Translocation{
      .angle = degrees(180.0).si(), .force = 0.0425, .depth = 12e-3, .lengthAbove = 3.5e-3};
  const std::string csv = comparisonCsv({whole, torn});
  EXPECT_THAT(csv, testing::HasSubstr("final_angle_deg,rupture_angle_deg,rupture_N,above_mm,"));
  EXPECT_THAT(csv, testing::HasSubstr("\na,,0,0,0,0,0,0,0,0,,,,"));
  EXPECT_THAT(csv, testing::HasSubstr("\na,,0,0,0,0,0,0,0,0,180,0.0425,3.5,"));
}

TEST(ACurve, IsStraightBetweenItsPointsAndEndsWithThem)
{
  const std::vector<AxisPoint> curve = {{1e-3, 0.1}, {2e-3, 0.3}};
  EXPECT_DOUBLE_EQ(*forceAt(curve, 1e-3), 0.1);
  EXPECT_DOUBLE_EQ(*forceAt(curve, 1.25e-3), 0.15);
  EXPECT_DOUBLE_EQ(*forceAt(curve, 2e-3), 0.3);
  EXPECT_FALSE(forceAt(curve, 0.99e-3));
  EXPECT_FALSE(forceAt(curve, 2.01e-3));
  EXPECT_FALSE(forceAt({}, 1e-3));
}

TEST(InsertionsOfOneName, GetDistinctLabels)
{
  std::vector<ComparedInsertion> insertions(3);
  insertions[0].name = insertions[2].name = "a";
  insertions[1].name = "b";
  tellApart(insertions);
  EXPECT_EQ(insertions[0].name, "a");
  EXPECT_EQ(insertions[1].name, "b");
  EXPECT_EQ(insertions[2].name, "a (3)");
}

TEST(InsertionsOfOneName, GetNoLabelThatAnotherHas)
{
  std::vector<ComparedInsertion> insertions(4);
  insertions[0].name = "a (3)";
  insertions[1].name = insertions[2].name = insertions[3].name = "a";
  tellApart(insertions);
  std::set<std::string> labels;
  for (const ComparedInsertion& each : insertions) labels.insert(labelOf(each));
  EXPECT_EQ(labels.size(), 4u);
}

TEST(ColumnsOfAComparison, AreExplainedAndFilled)
{
  auto one = insertion("a", {});
  one.recording = "2026-11-28-a.insertion";
  one.settings = {"soap-50",         "0.12 to 0.3", 0.66e-3, "round-window",
                  degrees(3.0).si(), 0.0,           0.1,     7};
  one.stopTravel = 24e-3;
  one.end = haptics::InsertionEnd::stoppedByResistance;
  std::istringstream table(comparisonCsv({one})), dictionary(comparisonDictionaryCsv());
  std::string header, row, line;
  std::getline(std::getline(table, header), row);
  EXPECT_THAT(row, testing::EndsWith(
                       ",2026-11-28-a.insertion,soap-50,0.12 to 0.3,0.66,round-window,3,0,7,24,0.1,"
                       "stopped_by_resistance"));
  EXPECT_EQ(std::ranges::count(row, ','), std::ranges::count(header, ','));
  std::getline(dictionary, line);
  std::string columns;
  while (std::getline(dictionary, line))
    columns += (columns.empty() ? "" : ",") + line.substr(0, line.find(','));
  EXPECT_EQ(columns, header);
}

TEST(PublishedPoints, StandBehindInsertionsOfTheirArrayOnly)
{
  std::vector<ComparedInsertion> insertions(2);
  insertions[0].subject.array = insertions[1].subject.array = "Nucleus 24 Contour";
  EXPECT_FALSE(areComparableWithPublished(insertions));
  insertions[0].hasPublishedConditions = true;
  EXPECT_TRUE(areComparableWithPublished(insertions));
  insertions[1].subject.array = "FLEX24";
  EXPECT_FALSE(areComparableWithPublished(insertions));
}

/// Insertions of two techniques with the given peaks [N].
std::vector<ComparedInsertion> twoTechniques(const std::vector<double>& standard,
                                             const std::vector<double>& aos)
{
  std::vector<ComparedInsertion> insertions;
  for (const auto* peaks : {&standard, &aos})
    for (const double peak : *peaks) {
      auto& each = insertions.emplace_back();
      each.subject.array = "Contour";
      each.subject.technique = peaks == &aos ? "aos" : "standard";
      each.profile.peak.force = peak;
    }
  return insertions;
}

TEST(Groups, HoldInsertionsWithEqualValuesInOrderOfTheirNames)
{
  const auto insertions = twoTechniques({0.1, 0.2}, {0.3});
  EXPECT_TRUE(groupsOf(insertions, {}).empty());
  const auto groups = groupsOf(insertions, {GroupKey::array, GroupKey::technique});
  ASSERT_EQ(groups.size(), 2u);
  EXPECT_EQ(groups[0].name(), "Contour · aos");
  EXPECT_THAT(groups[0].members, testing::ElementsAre(2u));
  EXPECT_THAT(groups[1].members, testing::ElementsAre(0u, 1u));
}

std::vector<std::string> differing(const std::vector<ComparedInsertion>& insertions,
                                   const InsertionGroup& group)
{
  std::vector<std::string> names;
  for (const Phrase& each : differingIn(insertions, group)) names.emplace_back(each.english());
  return names;
}

TEST(Groups, AreOfOneFrictionAndOneSetSpeedAndSaySoWhereTheyMix)
{
  using testing::ElementsAre;
  auto insertions = twoTechniques({0.1, 0.2, 0.3}, {});
  for (auto& each : insertions) {
    each.settings.friction = "tissue";
    each.settings.coefficient = "0.165";
    each.settings.speed = 2e-3;
  }
  EXPECT_THAT(differing(insertions, groupsOf(insertions, {GroupKey::array})[0]), ElementsAre());
  insertions[1].settings.coefficient = "0.3";
  insertions[2].settings.speed = {};  // by hand
  const auto byArray = groupsOf(insertions, {GroupKey::array});
  ASSERT_EQ(byArray.size(), 1u);
  EXPECT_THAT(differing(insertions, byArray[0]), ElementsAre("friction", "set speed"));
  const auto divided = groupsOf(insertions, {GroupKey::friction, GroupKey::speed});
  ASSERT_EQ(divided.size(), 3u);
  EXPECT_EQ(divided[0].name(), "0.165 (tissue) · 2 mm/s");
  EXPECT_EQ(divided[1].name(), "0.165 (tissue) · by hand");
  EXPECT_EQ(divided[2].name(), "0.3 (tissue) · 2 mm/s");
  for (const InsertionGroup& group : divided)
    EXPECT_THAT(differing(insertions, group), ElementsAre());
  insertions[1].settings.approachTilt = insertions[1].stopTravel = 0.01;
  insertions[1].subject.cochlea = "another";
  insertions[1].subject.array = "FLEX28";
  insertions[1].subject.technique = "aos";
  insertions[1].end = haptics::InsertionEnd::buckled;
  EXPECT_THAT(
      differing(insertions, {{"all"}, {0, 1}}),
      ElementsAre("friction", "approach", "stop", "cochlea", "array", "technique", "ending"));
}

TEST(Groups, NameTechniquesInWordsWhereTheyAreShown)
{
  const auto insertions = twoTechniques({0.1}, {0.2});
  const auto groups = groupsOf(insertions, {GroupKey::array, GroupKey::technique});
  EXPECT_EQ(groups[0].title(), "Contour · advance off-stylet");
  EXPECT_EQ(groups[1].title(), "Contour · standard");
}

TEST(Groups, HaveMeanDeviationAndDifferenceOfATextbook)
{
  // SciPy, [.2, .24, .19, .21] and [.1, .12, .14] with unequal variances: difference 0.09,
  // standard error 0.0158114, 4.65517 degrees of freedom, 95 % interval 0.0484331 to 0.131567
  const auto insertions = twoTechniques({0.10, 0.12, 0.14}, {0.20, 0.24, 0.19, 0.21});
  const auto groups = groupsOf(insertions, {GroupKey::technique});
  const std::string means = groupsCsv(insertions, groups);
  EXPECT_THAT(means, testing::HasSubstr("\nstandard,peak_N,3,0.12"));
  const ComparedQuantity& peak = comparedQuantities().front();
  ASSERT_STREQ(peak.key, "peak_N");
  const auto welch =
      welchDifference(valuesOf(insertions, groups[0], peak), valuesOf(insertions, groups[1], peak));
  ASSERT_TRUE(welch);
  EXPECT_NEAR(welch->difference.value, 0.09, 1e-12);
  EXPECT_NEAR(welch->degreesOfFreedom, 4.65517, 1e-4);
  EXPECT_NEAR(welch->difference.low, 0.0484331, 1e-6);
  EXPECT_NEAR(welch->difference.high, 0.131567, 1e-6);
  EXPECT_THAT(differencesCsv(insertions, groups),
              testing::HasSubstr("\naos,standard,peak_N,4,3,0.0"));
}

TEST(TheMeanCurveOfAGroup, GoesAsFarAsHalfOfTheInsertionsDo)
{
  std::vector<ComparedInsertion> insertions(3);
  for (std::size_t i = 0; i < 3; ++i)
    for (int step = 1; step <= 2 + static_cast<int>(i); ++step)
      insertions[i].profile.curve.push_back({step * 1e-4, 0.1 * static_cast<double>(i)});
  const MeanCurve curve = meanCurve(insertions, {{"all"}, {0, 1, 2}}, CurveAxis::travel);
  ASSERT_THAT(curve.count, testing::ElementsAre(3u, 3u, 2u));  // the last step of one is left out
  EXPECT_NEAR(curve.mean[0], 0.1, 1e-12);
  EXPECT_NEAR(curve.sd[0], 0.1, 1e-12);
  EXPECT_NEAR(curve.mean[2], 0.15, 1e-12);
  EXPECT_NEAR(curve.place[2], 3e-4, 1e-12);
}

TEST(CurvesOfRecordings, CanRunOverTheAngle)
{
  ComparedInsertion one = insertion("a", {});
  one.overAngle = {{degrees(1.0).si(), 0.5}, {degrees(2.0).si(), 0.25}};
  EXPECT_EQ(curvesCsv({one}, CurveAxis::angle), "angle_deg,a_N\n1,0.5\n2,0.25\n");
}

/// A tick while the array is pushed in.
haptics::TickOutput pushed(double depth_mm, double force)
{
  haptics::TickOutput now;
  now.workflow = haptics::Workflow::inserting;
  now.depth = depth_mm * 1e-3;
  now.travel = (depth_mm - 2.0) * 1e-3;
  now.time = depth_mm;
  now.axialForce = force;
  return now;
}

TEST(TheForceOfARib, IsToldFromThatOfTheArray)
{
  electrode::ArrayDesign array;
  array.ribsFromTip = {millimeters(17), millimeters(19)};
  RibPeaks peaks(array, millimeters(1));
  // 17.8 mm: the first rib is in the passage of 1 mm; 18.5 and more is near the second
  for (const auto& [depth_mm, force] : {std::pair{16.0, 0.10},
                                        {16.4, 0.11},
                                        {17.0, 0.20},
                                        {17.8, 0.15},
                                        {18.2, 0.06},
                                        {18.6, 0.14}})
    peaks.add(pushed(depth_mm, force));
  EXPECT_EQ(peaks.array().force, 0.11);
  EXPECT_NEAR(peaks.array().depth, 16.4e-3, 1e-12);
  ASSERT_TRUE(peaks.rib());
  EXPECT_EQ(peaks.rib()->force, 0.20);
  EXPECT_EQ(peaks.ribNumber(), 1);
}

TEST(TheEventsOfAnInsertion, AreInOrderOfTimeAndEachOnce)
{
  electrode::ArrayDesign array;
  array.ribsFromTip = {millimeters(5)};
  EventFinder finder(array, 0.02);
  std::vector<haptics::TickOutput> ticks = {pushed(3, 0.01), pushed(4, 0.03), pushed(5, 0.09),
                                            pushed(6, 0.05), pushed(6, 0.05)};
  ticks[3].status = ticks[4].status = haptics::partitionRuptured | haptics::translocated;
  haptics::TickOutput end = pushed(6, 0.04);
  end.workflow = haptics::Workflow::finished;
  end.status = ticks[4].status | haptics::endedBuckled;
  ticks.insert(ticks.end(), {end, end});
  haptics::PeakForce peak;
  for (std::size_t i = 0; i < ticks.size(); ++i) {
    peak.follow(ticks[i]);
    finder.add(i, ticks[i], peak);
  }
  std::vector<std::string> names;
  std::vector<std::uint64_t> places;
  for (const InsertionEvent& event : finder.events()) {
    names.emplace_back(nameOf(event.kind));
    places.push_back(event.place);
  }
  EXPECT_THAT(names, testing::ElementsAre("first_resistance", "rib_at_opening", "peak", "rupture",
                                          "translocation", "buckled"));
  EXPECT_THAT(places, testing::ElementsAre(1u, 2u, 2u, 3u, 3u, 5u));
}

}  // namespace
}  // namespace perilymph::analysis
