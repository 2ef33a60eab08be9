// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/validation/ClinicalPrediction.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "perilymph/test/TemporaryFolder.h"
#include "perilymph/validation/Prediction.h"

namespace perilymph::validation {
namespace {

/// Insertions of an array to the given angles.
std::vector<analysis::ClinicalInsertion> insertionsTo(const char* array,
                                                      std::initializer_list<double> angles_deg)
{
  std::vector<analysis::ClinicalInsertion> all;
  for (const double angle : angles_deg) {
    analysis::ClinicalInsertion one;
    one.array = array;
    one.apical = degrees(angle);
    one.end = angle > 0.0 ? haptics::InsertionEnd::finished : haptics::InsertionEnd::refused;
    all.push_back(one);
  }
  return all;
}

ClinicalRow rowOf(const std::vector<analysis::ClinicalInsertion>& insertions,
                  const std::string& quantity)
{
  const auto rows = clinicalRows(insertions);
  EXPECT_TRUE(rows) << rows.error().message;
  for (const ClinicalRow& row : *rows)
    if (row.quantity == quantity) return row;
  ADD_FAILURE() << "no row " << quantity;
  return {};
}

TEST(ClinicalPrediction, RefusesASeedThatIsGivenTwice)
{
  ClinicalRequest request;
  request.seeds = {1, 2, 1};
  const auto result = predictClinic(request, {});
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().message,
            "Seed 1 is given twice: its cochleae would count double. Give it once.");
}

// O'Connell 2017: FLEX24 median 408, interquartile range 373 to 449 degrees, here of 16 patients
TEST(ClinicalRow, ComparesTheMedianWithThatOfThePatients)
{
  const auto row = [](std::initializer_list<double> angles_deg) {
    return rowOf(insertionsTo("flex24", angles_deg), "angular depth of flex24");
  };
  // the published part of the error alone: 1.96 times the root of 0.863 76^2 / 16 + 35^2
  const ClinicalRow near = row({450, 450, 450, 450});
  EXPECT_NEAR(near.tolerance, 1.96 * std::sqrt(0.863 * 76.0 * 76.0 / 16.0 + 35.0 * 35.0), 1e-6);
  EXPECT_EQ(near.published, 408.0);
  EXPECT_EQ(near.patients, 16);
  EXPECT_EQ(near.verdict, RowVerdict::hit);
  EXPECT_EQ(near.spread, RowVerdict::miss);  // all the same
  EXPECT_EQ(row({495, 495, 495, 495}).verdict, RowVerdict::miss);
  EXPECT_EQ(row({370, 400, 420, 450}).spread, RowVerdict::hit);
}

TEST(ClinicalRow, CountsInsertionsThatFailed)
{
  const ClinicalRow row =
      rowOf(insertionsTo("flex24", {0, 0, 0, 400, 410}), "angular depth of flex24");
  EXPECT_EQ(row.runs, 5);
  EXPECT_EQ(row.median, 0.0);
}

/// A FLEX28 whose contacts lie every 2.1 mm, the most apical one at a depth, with 20 degrees each mm.
analysis::ClinicalInsertion flex28At(double depth_mm)
{
  analysis::ClinicalInsertion one;
  one.array = "flex28";
  one.apical = degrees(20.0 * depth_mm);
  for (int number = 1; number <= 12; ++number) {
    analysis::ContactPosition contact;
    contact.number = number;
    const double deep = depth_mm - 2.1 * (number - 1);
    contact.isInserted = deep > 0.0;
    contact.depth = millimeters(deep);
    contact.angle = degrees(std::max(0.0, 20.0 * deep));
    one.contacts.push_back(contact);
  }
  return one;
}

TEST(ClinicalRow, ComparesTheAngleAtThePublishedLength)
{
  const ClinicalRow row =
      rowOf({flex28At(24.0), flex28At(25.0), flex28At(20.0)}, "angular depth of flex28");
  ASSERT_TRUE(row.contactsInside && row.angleAtLength);
  EXPECT_DOUBLE_EQ(row.contactsInside->found, (12.0 + 12.0 + 10.0) / 3.0);
  EXPECT_DOUBLE_EQ(row.contactsInside->published, 11.33);
  // 11.33 contacts inside: the most apical one is 10.33 pitches deep; the third never came so far
  EXPECT_EQ(row.angleAtLength->runs, 2);
  EXPECT_NEAR(row.angleAtLength->found, 20.0 * 2.1 * 10.33, 1e-6);
  EXPECT_EQ(row.angleAtLength->published, 525.0);
}

TEST(ClinicalRow, SaysThatAnAngleIsHitForAnotherReason)
{
  // five contacts inside instead of 11.3, and yet the angle
  std::vector<analysis::ClinicalInsertion> few = {flex28At(9.0), flex28At(9.1), flex28At(9.2)};
  for (analysis::ClinicalInsertion& each : few) each.apical = degrees(550.0);
  const ClinicalRow row = rowOf(few, "angular depth of flex28");
  EXPECT_EQ(row.verdict, RowVerdict::hit);
  EXPECT_EQ(row.note, "hit for another reason");
}

// Canfarotta 2021: 49 of 51, by Wilson's formula 86.8 to 98.9 %
TEST(ClinicalRow, ComparesARateWithThePublishedCount)
{
  const auto row = [](std::size_t complete, std::size_t all) {
    std::vector<analysis::ClinicalInsertion> some;
    for (std::size_t i = 0; i < all; ++i)
      some.push_back(insertionsTo("flexsoft", {i < complete ? 600.0 : 0.0}).front());
    return rowOf(some, "complete insertion of flexsoft");
  };
  const ClinicalRow half = row(20, 40);
  EXPECT_NEAR(half.low, 86.8, 0.05);
  EXPECT_NEAR(half.high, 98.9, 0.05);
  EXPECT_DOUBLE_EQ(half.median, 50.0);
  EXPECT_EQ(half.verdict, RowVerdict::miss);
  EXPECT_EQ(row(38, 40).verdict, RowVerdict::hit);
}

TEST(ClinicalRow, ShowsForcesWithoutAVerdict)
{
  for (const char* force : {"peak force, all arrays", "force at the end, all arrays"}) {
    const ClinicalRow row = rowOf(insertionsTo("flex24", {400, 400}), force);
    EXPECT_EQ(row.verdict, RowVerdict::notJudged) << force;
    EXPECT_GT(row.high, row.low) << force;
    EXPECT_FALSE(row.note.empty()) << force;
  }
}

TEST(ClinicalRow, GivesNoVerdictOnArraysThatAreNotInserted)
{
  const ClinicalRow row =
      rowOf(insertionsTo("flex24", {400, 400}), "translocation of perimodiolar arrays");
  EXPECT_EQ(row.patients, 1324);
  EXPECT_EQ(row.runs, 0);
  EXPECT_EQ(row.verdict, RowVerdict::notJudged);
}

TEST(PerfectModel, MeetsNinetyFivePercentOfItsRows)
{
  std::vector<analysis::ClinicalInsertion> insertions;
  for (int i = 0; i < 80; ++i) {
    // two patients as deep as each of 40 quantiles of a normal distribution
    const double z = std::sqrt(2.0) * 1.2 * std::sin(0.1 * i) + 0.02 * (i % 7);
    for (const char* array : {"flex24", "hifocus-slimj"}) {
      analysis::ClinicalInsertion one = insertionsTo(array, {400.0 + 40.0 * z}).front();
      one.sharedFriction = 0.28 * std::cos(2.0 * i);
      one.isTranslocated = i % 12 == 0;
      insertions.push_back(one);
    }
  }
  const auto perfect = perfectModel(insertions);
  ASSERT_TRUE(perfect) << perfect.error().message;
  EXPECT_EQ(perfect->rows, 3);  // two angles and the translocations
  EXPECT_NEAR(perfect->expected, 0.95 * 3.0, 0.12);
  EXPECT_GT(perfect->all, 0.75);
  double sum = 0.0;
  for (const double each : perfect->exactly) sum += each;
  EXPECT_NEAR(sum, 1.0, 1e-9);
}

TEST(ClinicalAngles, HoldTheirMediansWithinTheirRanges)
{
  const auto angles = clinicalAngles();
  ASSERT_TRUE(angles) << angles.error().message;
  ASSERT_EQ(angles->size(), 7u);
  for (const ClinicalAngle& angle : *angles) {
    EXPECT_LE(angle.low, angle.median) << angle.array;
    EXPECT_LE(angle.median, angle.high) << angle.array;
    EXPECT_EQ(angle.spread == PublishedSpread::none, !(angle.low < angle.high)) << angle.array;
    EXPECT_GE(angle.patients, 16) << angle.array;
  }
  // FLEX28: median 575, interquartile range 465 to 584 degrees (O'Connell 2017)
  EXPECT_NEAR(inDegrees(angles->at(1).median), 575.0, 1e-9);
}

TEST(Prediction, CountsPatientsWhoseInsertionStopsEarly)
{
  const test::TemporaryFolder folder;
  const std::string scenario = (folder / "weak.toml").string();
  const auto weak =
      session::loadScenario("surgery-flex28", {{"stop_force_N", "0.002"}, {"nodes", "30"}});
  ASSERT_TRUE(weak) << weak.error().message;
  std::ofstream(scenario) << weak->text();

  PredictionRequest request;
  request.arrays = {"flex28"};
  request.scenario = scenario;
  request.patients = 2;
  const auto result = predict(request, {});
  ASSERT_TRUE(result) << result.error().message;
  const ArraySummary& summary = result->arrays.front();
  EXPECT_EQ(summary.patients, 2);
  EXPECT_EQ(summary.complete, 0);
  EXPECT_FALSE(summary.mean);
  EXPECT_GT(summary.medianPeak, newtons(0.0019));
  EXPECT_LT(summary.medianPeak, newtons(0.004));
}

}  // namespace
}  // namespace perilymph::validation
