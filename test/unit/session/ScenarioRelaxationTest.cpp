// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include "perilymph/session/Scenario.h"

// Keys of relaxation: absent in all earlier texts, and then nothing relaxes.

namespace perilymph::session {
namespace {

using testing::HasSubstr;
using testing::Not;

const Overrides bending = {{"relaxation_fraction", "[0.13, 0.28]"},
                           {"relaxation_time_s", "[0.3, 6]"}};

Result<Scenario> with(Overrides overrides, const Overrides& more = {})
{
  overrides.insert(overrides.end(), more.begin(), more.end());
  return loadScenario("contour-published", overrides);
}

std::string refusalOfRelaxation(const Overrides& overrides, const Overrides& more = {})
{
  const auto scenario = with(overrides, more);
  return scenario ? "accepted" : scenario.error().message;
}

TEST(ScenarioRelaxation, IsOffInShippedScenariosAndNotMentioned)
{
  const auto scenario = with({});
  ASSERT_TRUE(scenario);
  EXPECT_EQ(scenario->relaxation(), mechanics::RelaxationLaw{});
  EXPECT_THAT(scenario->text(), Not(HasSubstr("relaxation")));
}

TEST(ScenarioRelaxation, OfATextIsReadAgainAsItWas)
{
  const auto scenario =
      with(bending, {{"film_relaxation_fraction", "0.4"}, {"film_relaxation_time_s", "1.1"}});
  ASSERT_TRUE(scenario) << scenario.error().message;
  const mechanics::RelaxationLaw& law = scenario->relaxation();
  EXPECT_EQ(law.bending[0].fraction, 0.13);
  EXPECT_EQ(law.bending[1].time, seconds(6));
  EXPECT_EQ(law.film.fraction, 0.4);
  const auto again = parseScenario(scenario->text(), "recording");
  ASSERT_TRUE(again) << again.error().message;
  EXPECT_EQ(again->text(), scenario->text());
  EXPECT_EQ(again->relaxation(), law);
}

TEST(ScenarioRelaxation, ReachesTheModel)
{
  const auto off = with({}), on = with(bending);
  ASSERT_TRUE(off && on);
  const auto anatomy = buildAnatomy(*off);
  ASSERT_TRUE(anatomy);
  EXPECT_NE((*buildModel(*on, *anatomy))->fingerprint, (*buildModel(*off, *anatomy))->fingerprint);
  EXPECT_EQ((*buildModel(*on, *anatomy))->parts.relaxation, on->relaxation());
}

TEST(ScenarioRelaxation, OutOfRangeIsRefused)
{
  EXPECT_THAT(refusalOfRelaxation({{"relaxation_fraction", "[0.13]"}}),
              HasSubstr("relaxation_time_s"));
  EXPECT_THAT(
      refusalOfRelaxation(bending, {{"relaxation_time_s", "[0.3]"}}),
      HasSubstr("relaxation_fraction has 2 numbers and relaxation_time_s has 1; give as many "
                "of both, at most 2."));
  EXPECT_THAT(refusalOfRelaxation(
                  {{"relaxation_fraction", "[0.1, 0.1, 0.1]"}, {"relaxation_time_s", "[1, 2, 3]"}}),
              HasSubstr("at most 2"));
  EXPECT_THAT(refusalOfRelaxation(bending, {{"relaxation_fraction", "[0.5, 0.6]"}}),
              HasSubstr("relaxation_fraction adds up to 1.1; it must be 0.95 at most"));
  EXPECT_THAT(refusalOfRelaxation(bending, {{"relaxation_time_s", "[0.3, 0.001]"}}),
              HasSubstr("0.01"));
  EXPECT_THAT(refusalOfRelaxation({{"film_relaxation_fraction", "1.5"}}),
              HasSubstr("film_relaxation_fraction"));
  EXPECT_THAT(refusalOfRelaxation(bending, {{"model", "points"}}),
              HasSubstr("the published model of points does not relax"));
}

}  // namespace
}  // namespace perilymph::session
