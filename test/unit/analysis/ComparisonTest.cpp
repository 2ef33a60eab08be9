// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/analysis/Comparison.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

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
  EXPECT_EQ(reversalsOf({0, 2, 1, 3}), 2);
  EXPECT_EQ(reversalsOf({0, -1, 0}), 1);
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
  EXPECT_THAT(csv, testing::HasSubstr("final_angle_deg,rupture_angle_deg,rupture_N,above_mm\na,"));
  EXPECT_THAT(csv, testing::HasSubstr(",0,,,\n"));
  EXPECT_THAT(csv, testing::EndsWith(",180,0.0425,3.5\n"));
}

TEST(ACurve, IsStraightBetweenItsPointsAndEndsWithThem)
{
  const std::vector<CurvePoint> curve = {{1e-3, 0.1}, {2e-3, 0.3}};
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

}  // namespace
}  // namespace perilymph::analysis
