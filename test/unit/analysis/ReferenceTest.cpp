// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/analysis/Reference.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "perilymph/foundation/Resources.h"
#include "perilymph/foundation/Units.h"
#include "perilymph/test/TemporaryFolder.h"

namespace perilymph::analysis {
namespace {

using testing::HasSubstr;

TEST(ShippedReferences, AllReadAndSayWhereTheyComeFrom)
{
  const auto names = shippedNames("resources/reference");
  EXPECT_GE(names.size(), 5u);
  for (const std::string& name : names) {
    const auto reference = shippedReference(name);
    ASSERT_TRUE(reference) << reference.error().message;
    EXPECT_FALSE(reference->source.empty()) << name;
  }
}

TEST(PublishedExperiment, HasTheRawRecordOfThePaper)
{
  // 0.095 ± 0.0132, 0.113 ± 0.0133 and 0.194 ± 0.0287 N (Todd and Naghdy, section III)
  const auto experiment = shippedReference("todd-naghdy-experiment");
  ASSERT_TRUE(experiment);
  const double printed[3][2] = {{0.095, 0.0132}, {0.113, 0.0133}, {0.194, 0.0287}};
  ASSERT_EQ(experiment->ranges.size(), 3u);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(experiment->ranges[i].low, printed[i][0] - printed[i][1], 1e-12);
    EXPECT_NEAR(experiment->ranges[i].high, printed[i][0] + printed[i][1], 1e-12);
  }
  ASSERT_NE(experiment->find("dip"), nullptr);
  EXPECT_DOUBLE_EQ(inMillimeters(meters(experiment->find("dip")->travel)), 11.8);
}

TEST(PublishedDifference, IsSimulatorMinusExperiment)
{
  // Both curves are printed at the end, so their difference shows the sign.
  const auto experiment = shippedReference("todd-naghdy-experiment");
  const auto simulator = shippedReference("todd-naghdy-simulator");
  const auto difference = shippedReference("todd-naghdy-difference");
  ASSERT_TRUE(experiment && simulator && difference);
  EXPECT_NEAR(difference->differences.back().mean,
              simulator->find("end")->mean - experiment->find("end")->mean, 1e-12);
}

TEST(ForceFeltBySurgeons, IsKratchmansMedian)
{
  // Kratchman et al. 2016: 20.4 mN
  const auto felt = forceFeltBySurgeons();
  ASSERT_TRUE(felt) << felt.error().message;
  EXPECT_NEAR(inMillinewtons(*felt), 20.4, 1e-12);
  EXPECT_THAT(shippedReference("surgeons")->values.front().source, HasSubstr("Kratchman"));
}

TEST(ReferenceFile, WithoutAnyValueIsRefused)
{
  const test::TemporaryFolder folder;
  std::ofstream(folder / "r.toml") << "label = \"l\"\nsource = \"s\"\n";
  const auto reference = loadReference(folder / "r.toml");
  ASSERT_FALSE(reference);
  EXPECT_THAT(reference.error().message, HasSubstr("at least one"));
}

TEST(ReferenceFile, WithAnIntervalThatDoesNotHoldItsMeanIsRefused)
{
  const test::TemporaryFolder folder;
  std::ofstream(folder / "r.toml")
      << "label = \"l\"\nsource = \"s\"\n[[difference]]\ntravel_mm = 1.0\nmean_N = 0.1\n"
         "ci95_low_N = 0.2\nci95_high_N = 0.3\nsource = \"s\"\n";
  const auto reference = loadReference(folder / "r.toml");
  ASSERT_FALSE(reference);
  EXPECT_THAT(reference.error().message, HasSubstr("ci95_low_N"));
}

}  // namespace
}  // namespace perilymph::analysis
