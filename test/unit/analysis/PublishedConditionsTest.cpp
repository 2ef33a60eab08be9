// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/analysis/PublishedConditions.h"

#include <gtest/gtest.h>

namespace perilymph::analysis {
namespace {

bool isComparable(const session::Overrides& changes, const char* scenario = "contour-published")
{
  const auto loaded = session::loadScenario(scenario, changes);
  EXPECT_TRUE(loaded) << loaded.error().message;
  return loaded && hasPublishedConditions(*loaded);
}

TEST(PublishedConditions, AreThoseOfThePublishedScenario)
{
  EXPECT_TRUE(isComparable({}));
  EXPECT_TRUE(isComparable({{"side", "\"left\""}}));
  EXPECT_TRUE(isComparable({{"nodes", "200"}}));
  EXPECT_TRUE(isComparable({{"force_scale", "5.0"}}));
}

TEST(PublishedConditions, AreNotThoseOfAnotherArrayCochleaFrictionOrSpeed)
{
  EXPECT_FALSE(isComparable({{"array", "\"flex28\""}, {"calibration", "\"\""}}));
  EXPECT_FALSE(isComparable({{"technique", "\"aos\""}}));
  EXPECT_FALSE(isComparable({{"anatomy", "\"mean\""}}));
  EXPECT_FALSE(isComparable({{"patient_numbers.label", "\"other\""},
                             {"patient_numbers.st_length_mm", "33.1"},
                             {"patient_numbers.rw_width_mm", "1.94"},
                             {"patient_numbers.rw_height_mm", "1.85"}}));
  EXPECT_FALSE(isComparable({{"friction", "\"tissue\""}}));
  EXPECT_FALSE(isComparable({{"speed_mm_s", "1.0"}}));
  EXPECT_FALSE(isComparable({}, "mean-contour"));
}

TEST(TheBasalTurnOfTheExperiment, IsThatOfItsArrayTechniqueAndCochlea)
{
  const auto has = [](const session::Overrides& changes, const char* scenario) {
    const auto loaded = session::loadScenario(scenario, changes);
    EXPECT_TRUE(loaded) << loaded.error().message;
    return loaded && hasPublishedBasalTurn(*loaded);
  };
  EXPECT_TRUE(has({{"friction", "\"tissue\""}, {"speed_mm_s", "1.0"}}, "contour-published"));
  EXPECT_FALSE(has({}, "surgery-flex28"));
  EXPECT_FALSE(has({{"technique", "\"aos\""}}, "contour-published"));
  EXPECT_FALSE(has({{"anatomy", "\"mean\""}}, "contour-published"));
}

}  // namespace
}  // namespace perilymph::analysis
