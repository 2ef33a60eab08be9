// SPDX-License-Identifier: BSD-3-Clause

// A scenario's text and its model agree after every change.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "perilymph/session/Scenario.h"

namespace perilymph::session {
namespace {

using testing::HasSubstr;

std::string refusal(const Overrides& overrides)
{
  const auto scenario = loadScenario("contour-published", overrides);
  return scenario ? "accepted" : scenario.error().message;
}

std::string valueIn(const Scenario& scenario, const std::string& wanted)
{
  for (const auto& [key, value] : scenario.values())
    if (key == wanted) return value;
  return "none";
}

// One value for every kind of key: numbers, counts, flags, names of choices and of files.
TEST(ScenarioWithOtherValues, SaysEachOfThemInItsTextAndRunsWhatItSays)
{
  const auto first = loadScenario("mean-contour");
  ASSERT_TRUE(first) << first.error().message;
  const Overrides changes = {{"anatomy", "\"clark\""},
                             {"array", "\"contour-advance\""},
                             {"technique", "\"aos\""},
                             {"opening", "\"cochleostomy\""},
                             {"membrane", "\"rigid\""},
                             {"coupling", "\"spring\""},
                             {"side", "\"left\""},
                             {"nodes", "33"},
                             {"dt_ms", "0.5"},
                             {"seed", "42"},
                             {"speed_mm_s", "0.3"},
                             {"start_inside_mm", "1.1"},
                             {"stop_travel_mm", "7.7"},
                             {"withdraw", "true"},
                             {"stylet_pull_mm_s", "3.3"},
                             {"lead_in_mm", "1.7"},
                             {"approach_tilt_deg", "3.3"},
                             {"friction_static", "0.3"},
                             {"wall_stiffness_N_m", "500.7"},
                             {"force_scale", "2.5"}};
  const auto changed = first->with(changes);
  ASSERT_TRUE(changed) << changed.error().message;
  for (const auto& [key, value] : changes) {
    EXPECT_NE(valueIn(*first, key), value) << key << " is not changed";
    EXPECT_EQ(valueIn(*changed, key), value);
    EXPECT_THAT(changed->text(), HasSubstr(key + " = " + value + "\n"));
  }
  EXPECT_EQ(changed->anatomy(), anatomy::AnatomySource::clark);
  EXPECT_EQ(changed->technique(), Technique::advanceOffStylet);
  EXPECT_EQ(changed->openingKind(), OpeningKind::cochleostomy);
  EXPECT_EQ(changed->membraneKind(), MembraneKind::rigid);
  EXPECT_EQ(changed->engine().stopTravel, millimeters(7.7).si());
  EXPECT_EQ(changed->name(), first->name());
  EXPECT_THAT(changed->files(), testing::IsSupersetOf(std::vector{first->files().back()}));

  const auto again = parseScenario(changed->text(), "elsewhere");
  ASSERT_TRUE(again) << again.error().message;
  EXPECT_EQ(again->text(), changed->text());
  const auto fingerprint = [](const Scenario& scenario) {
    return (*buildModel(scenario, *buildAnatomy(scenario)))->fingerprint;
  };
  EXPECT_EQ(fingerprint(*again), fingerprint(*changed));
  EXPECT_NE(fingerprint(*again), fingerprint(*first));
}

TEST(ScenarioWithOtherValues, RefusesWhatAFileMayNotSay)
{
  const auto first = loadScenario("contour-published");
  ASSERT_TRUE(first);
  const auto deeper = first->with({{"stop_travel_mm", "30"}});
  ASSERT_FALSE(deeper);
  EXPECT_THAT(deeper.error().message, HasSubstr("22 mm at most"));
  EXPECT_FALSE(first->with({{"speed", "3"}}));
}

TEST(ScenarioWithOtherValues, KnowsTheArrayFileOfTheTextButNotThatOfAnotherArray)
{
  const auto recorded = parseScenario(loadScenario("contour-published")->text(), "recording");
  ASSERT_TRUE(recorded);
  const auto slower = recorded->with({{"speed_mm_s", "1.0"}});
  ASSERT_TRUE(slower);
  EXPECT_EQ(slower->expectedArrayFingerprint(), recorded->arrayFingerprint());
  const auto other = recorded->with({{"array", "contour-advance"}});
  ASSERT_TRUE(other) << other.error().message;
  EXPECT_EQ(other->expectedArrayFingerprint(), "");
}

TEST(ScenarioChoices, AreRefusedWithTheNamesAllowed)
{
  EXPECT_THAT(refusal({{"technique", "shove"}}),
              HasSubstr("technique is 'shove'; it must be 'standard' or 'aos' (advance off "
                        "stylet)."));
  EXPECT_THAT(refusal({{"opening", "door"}}),
              HasSubstr("opening is 'door'; it must be one of none, round-window, cochleostomy."));
  EXPECT_THAT(refusal({{"membrane", "steel"}}),
              HasSubstr("membrane is 'steel'; it must be 'rigid' or 'soft'."));
  EXPECT_THAT(refusal({{"model", "jelly"}}),
              HasSubstr("model is 'jelly'; it must be 'rod' or 'points'."));
  EXPECT_THAT(refusal({{"coupling", "glue"}}),
              HasSubstr("coupling is 'glue'; it must be 'rigid' or 'spring'."));
  EXPECT_THAT(refusal({{"side", "top"}}),
              HasSubstr("side is 'top'; it must be 'right' or 'left'."));
}

}  // namespace
}  // namespace perilymph::session
