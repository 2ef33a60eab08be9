// SPDX-License-Identifier: BSD-3-Clause
#include "FrequencyAllocation.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "perilymph/session/Scenario.h"

namespace perilymph::test {
namespace {

using planning::FrequencyAllocation;

std::vector<FrequencyAllocation> shipped()
{
  const auto allocations = planning::shippedAllocations();
  return allocations ? *allocations : std::vector<FrequencyAllocation>{};
}

TEST(FrequencyAllocation, RisesFromTheTipAndNamesItsSource)
{
  const auto allocations = shipped();
  ASSERT_EQ(allocations.size(), 3u);
  for (const FrequencyAllocation& each : allocations) {
    EXPECT_TRUE(std::is_sorted(each.center_Hz.begin(), each.center_Hz.end())) << each.maker;
    EXPECT_FALSE(each.source.empty()) << each.maker;
  }
}

TEST(FrequencyAllocation, IsTheMakersForItsNumberOfContacts)
{
  electrode::ArrayDesign array;
  array.maker = "MED-EL";
  array.contactsFromTip.resize(12);
  const auto filter_Hz = planning::filtersOf(array, shipped());
  ASSERT_EQ(filter_Hz.size(), 12u);
  EXPECT_EQ(filter_Hz.back(), 7410.0);
  array.contactsFromTip.resize(20);
  EXPECT_TRUE(planning::filtersOf(array, shipped()).empty());
}

TEST(FrequencyAllocation, ServesEveryShippedArrayOfItsMakers)
{
  for (const char* name : {"flex28", "slim-straight", "hybrid-l24", "hifocus-slimj"}) {
    const auto scenario =
        session::loadScenario("surgery-flex28", {{"array", name}, {"stop_travel_mm", "0.1"}});
    ASSERT_TRUE(scenario) << scenario.error().message;
    EXPECT_FALSE(planning::filtersOf(scenario->array(), shipped()).empty()) << name;
  }
}

}  // namespace
}  // namespace perilymph::test
