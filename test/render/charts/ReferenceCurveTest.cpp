// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/charts/ReferenceCurve.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "perilymph/test/TemporaryFolder.h"

namespace perilymph::charts {
namespace {

std::filesystem::path written(const test::TemporaryFolder& folder, const std::string& text)
{
  const std::filesystem::path file = folder / "reference.toml";
  std::ofstream(file) << text;
  return file;
}

TEST(ReferenceCurve, ShippedExperimentHasTheValuesThatThePaperPrints)
{
  const Result<ReferenceCurve> curve = publishedExperiment();
  ASSERT_TRUE(curve) << curve.error().message;
  ASSERT_EQ(curve->points.size(), 4u);
  const double printed[4][3] = {{10.6, 0.0880, 0.0186},
                                {11.8, 0.0807, 0.0219},
                                {15.4, 0.1509, 0.0189},
                                {16.5, 0.1254, 0.0385}};
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_DOUBLE_EQ(curve->points[i].travel_mm, printed[i][0]);
    EXPECT_DOUBLE_EQ(curve->points[i].mean_mN, 1e3 * printed[i][1]);
    EXPECT_DOUBLE_EQ(curve->points[i].sd_mN, 1e3 * printed[i][2]);
  }
}

TEST(ReferenceCurve, RefusesPointsOutOfOrderWithASentence)
{
  const test::TemporaryFolder folder;
  const Result<ReferenceCurve> curve = loadReference(
      written(folder,
              "label = \"l\"\nsource = \"s\"\n"
              "[[point]]\ntravel_mm = 5.0\nmean_N = 0.1\nsd_N = 0.01\nsource = \"a\"\n"
              "[[point]]\ntravel_mm = 4.0\nmean_N = 0.1\nsd_N = 0.01\nsource = \"b\"\n"));
  ASSERT_FALSE(curve);
  EXPECT_THAT(curve.error().message, testing::HasSubstr("order of travel"));
}

TEST(ReferenceCurve, RefusesANegativeDeviation)
{
  const test::TemporaryFolder folder;
  const Result<ReferenceCurve> curve = loadReference(
      written(folder,
              "label = \"l\"\nsource = \"s\"\n"
              "[[point]]\ntravel_mm = 5.0\nmean_N = 0.1\nsd_N = -0.01\nsource = \"a\"\n"));
  ASSERT_FALSE(curve);
  EXPECT_THAT(curve.error().message, testing::HasSubstr("sd_N"));
}

TEST(ReferenceCurve, RefusesAFileWithoutPoints)
{
  const test::TemporaryFolder folder;
  EXPECT_FALSE(loadReference(written(folder, "label = \"l\"\nsource = \"s\"\n")));
}

TEST(ReferenceCurve, SaysWhichFileIsMissing)
{
  const Result<ReferenceCurve> curve = loadReference("no-such-reference.toml");
  ASSERT_FALSE(curve);
  EXPECT_THAT(curve.error().message, testing::HasSubstr("no-such-reference.toml"));
}

}  // namespace
}  // namespace perilymph::charts
