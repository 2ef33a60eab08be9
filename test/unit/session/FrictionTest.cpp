// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "perilymph/foundation/Resources.h"
#include "perilymph/session/Scenario.h"
#include "perilymph/test/TemporaryFolder.h"

// Friction, opening, membrane and technique by name: the shipped ones, and which of several
// settings applies.

namespace perilymph::session {
namespace {

using testing::HasSubstr;

Scenario with(const Overrides& overrides)
{
  const auto scenario = loadScenario("contour-published", overrides);
  EXPECT_TRUE(scenario) << scenario.error().message;
  return scenario ? *scenario : Scenario{};
}

std::string refusal(const Overrides& overrides)
{
  const auto scenario = loadScenario("contour-published", overrides);
  return scenario ? "accepted" : scenario.error().message;
}

double sliding(const std::string& preset, double speed_mm_s)
{
  return with({{"friction", preset}}).friction().sliding(speed_mm_s * 1e-3);
}

TEST(ShippedFriction, AllLoad)
{
  const auto names = shippedNames("resources/friction");
  EXPECT_THAT(names, testing::IsSupersetOf({"endosteum", "estimate-from-pig-tissue", "paper",
                                            "soap-10", "soap-50", "soap-90", "tissue"}));
  for (const std::string& name : names) EXPECT_EQ(refusal({{"friction", name}}), "accepted");
}

TEST(ShippedFriction, OfAnEarIsAnEstimateWithItsSpread)
{
  const Scenario estimate = with({{"friction", "estimate-from-pig-tissue"}});
  EXPECT_DOUBLE_EQ(estimate.friction().sliding(0.0), 0.165);
  EXPECT_DOUBLE_EQ(estimate.parameters().frictionSpread.shared, 0.283);
  EXPECT_DOUBLE_EQ(estimate.parameters().frictionSpread.ear, 0.2);
  // a recording keeps it without the file; the text of a friction without spread is as it was
  const auto again = parseScenario(estimate.text(), "recorded", {});
  ASSERT_TRUE(again) << again.error().message;
  EXPECT_DOUBLE_EQ(again->parameters().frictionSpread.shared, 0.283);
  EXPECT_EQ(again->text(), estimate.text());
  for (const char* other : {"endosteum", "paper", "tissue"}) {
    const Scenario without = with({{"friction", other}});
    EXPECT_FALSE(without.parameters().frictionSpread.isKnown()) << other;
    EXPECT_EQ(without.text().find("sd_log"), std::string::npos) << other;
  }
  EXPECT_THAT(refusal({{"friction_ear_sd_log", "1.5"}}), HasSubstr("friction_ear_sd_log"));
}

TEST(ShippedFriction, OfTheExperimentIsAsPublished)
{
  const mechanics::FrictionLaw law = with({{"friction", "paper"}}).friction();
  EXPECT_DOUBLE_EQ(law.staticCoefficient, 0.0605);
  EXPECT_DOUBLE_EQ(law.kineticCoefficient, 0.0395);
  EXPECT_DOUBLE_EQ(law.stoppingCoefficient, 0.0185);
  EXPECT_TRUE(law.bySpeed.isEmpty());
  // the defaults of the law are the same values
  EXPECT_EQ(law.staticCoefficient, mechanics::FrictionLaw{}.staticCoefficient);
  EXPECT_EQ(law.kineticCoefficient, mechanics::FrictionLaw{}.kineticCoefficient);
  EXPECT_EQ(law.stoppingCoefficient, mechanics::FrictionLaw{}.stoppingCoefficient);
}

TEST(ShippedFriction, OfSoapChangesWithSpeedAsItsStrengthHasIt)
{
  // Froehlich et al. 2024, 0.1 to 2.0 mm/s: flat at 10 %, falling at 50 %, rising at 90 %
  EXPECT_DOUBLE_EQ(sliding("soap-10", 0.1), sliding("soap-10", 2.0));
  EXPECT_GT(sliding("soap-50", 0.1), sliding("soap-50", 1.0));
  EXPECT_GT(sliding("soap-50", 1.0), sliding("soap-50", 2.0));
  EXPECT_LT(sliding("soap-90", 0.1), sliding("soap-90", 1.0));
  EXPECT_LT(sliding("soap-90", 1.0), sliding("soap-90", 2.0));
}

TEST(ShippedFriction, OfTissueIsWhatDohrMeasured)
{
  EXPECT_DOUBLE_EQ(sliding("tissue", 0.1), 0.24);
  EXPECT_DOUBLE_EQ(sliding("tissue", 1.5), 0.59);
  EXPECT_DOUBLE_EQ(sliding("tissue", 2.0), 0.45);
}

TEST(Friction, OfARecordedTextNeedsNoFile)
{
  const test::TemporaryFolder folder;
  const std::filesystem::path file = folder / "mine.toml";
  std::ofstream(file) << "title = 'Mine'\n[coefficients]\nstatic = 0.2\nsource = 'x'\n"
                         "confidence = 'low'\n[stopping]\ncoefficient = 0.05\nsource = 'x'\n"
                         "confidence = 'low'\n[by_speed]\nspeed_mm_s = [0.3, 7.7]\n"
                         "coefficient = [0.1, 0.33]\nsource = 'x'\nconfidence = 'low'\n";
  const Scenario first = with({{"friction", file.string()}});
  std::filesystem::remove(file);
  const auto second = parseScenario(first.text(), "recording");
  ASSERT_TRUE(second) << second.error().message;
  EXPECT_EQ(second->text(), first.text());
  for (const double speed : {0.0, 0.3e-3, 1e-3, 5e-3, 7.7e-3, 1.0})
    EXPECT_EQ(second->friction().sliding(speed), first.friction().sliding(speed)) << speed;
  EXPECT_DOUBLE_EQ(second->friction().sliding(7.7e-3), 0.33);
}

// Without a spread a factor of 25 % would be drawn silently.
TEST(Friction, WithASpreadOfZeroIsRefused)
{
  const test::TemporaryFolder folder;
  const std::filesystem::path file = folder / "mine.toml";
  std::ofstream(file)
      << "title = 'Mine'\n[coefficients]\nstatic = 0.2\ndynamic = 0.2\nsource = 'x'\n"
         "confidence = 'low'\n[stopping]\ncoefficient = 0.05\nsource = 'x'\n"
         "confidence = 'low'\n[spread]\nshared_sd_log = 0.0\near_sd_log = 0.0\n"
         "source = 'x'\nconfidence = 'low'\n";
  EXPECT_THAT(refusal({{"friction", file.string()}}),
              HasSubstr("shared_sd_log and ear_sd_log are 0: no spread."));
}

TEST(Friction, NamedAgainReplacesTheNumbersOfTheText)
{
  const std::string text = with({{"friction", "tissue"}}).text();
  const auto again = parseScenario(text, "recording", {{"friction", "paper"}});
  ASSERT_TRUE(again) << again.error().message;
  EXPECT_DOUBLE_EQ(again->friction().staticCoefficient, 0.0605);
  EXPECT_TRUE(again->friction().bySpeed.isEmpty());
}

TEST(Friction, GivenAsNumbersLeavesThePresetsTableOut)
{
  const mechanics::FrictionLaw law = with({{"friction", "tissue"},
                                           {"friction_static", "0.3"},
                                           {"friction_dynamic", "0.2"},
                                           {"friction_stopping", "0.1"}})
                                         .friction();
  EXPECT_TRUE(law.bySpeed.isEmpty());
  EXPECT_NEAR(law.sliding(1.0), 0.2, 1e-6);
}

TEST(Friction, ThatIsUnknownIsAnsweredWithTheNamesThereAre)
{
  EXPECT_THAT(refusal({{"friction", "butter"}}),
              testing::AllOf(HasSubstr("butter"), HasSubstr("paper"), HasSubstr("tissue"),
                             HasSubstr("friction_static")));
}

TEST(Friction, WithMoreSpeedsThanCoefficientsIsRefused)
{
  EXPECT_THAT(refusal({{"friction_speed_mm_s", "[0.1, 1.0]"}, {"friction_coefficient", "[0.1]"}}),
              HasSubstr("2 speeds and 1 coefficients"));
}

TEST(Friction, ThatStopsAboveItsMinimumKineticValueIsRefused)
{
  EXPECT_THAT(refusal({{"friction", "soap-90"}, {"friction_stopping", "0.04"}}),
              HasSubstr("friction_stopping is 0.04; it must not be above friction_dynamic"));
}

TEST(Opening, ThatIsTooNarrowForTheArraysBaseGivesAWarning)
{
  // FLEXSOFT: 0.5 mm at its tip, 1.3 mm 31.5 mm behind it, straight between: 1 mm at 19.7 mm.
  const Overrides narrow = {{"anatomy", "mean"},
                            {"array", "flexsoft"},
                            {"opening", "cochleostomy"},
                            {"cochleostomy_diameter_mm", "1.0"},
                            {"stop_travel_mm", "25"}};
  const Scenario scenario = with(narrow);
  ASSERT_EQ(scenario.notes().size(), 1u);
  EXPECT_THAT(scenario.notes()[0],
              testing::AllOf(HasSubstr("mm thick 19.7 mm behind its tip, the opening 1 mm wide"),
                             HasSubstr("stops there")));

  Overrides shallow = narrow;
  shallow.back().second = "10";
  EXPECT_TRUE(with(shallow).notes().empty());
  EXPECT_THAT(refusal({{"opening", "door"}}),
              HasSubstr("opening is 'door'; it must be one of none, round-window, cochleostomy."));
}

TEST(Membrane, HasTheGivenStiffness)
{
  EXPECT_FALSE(with({}).membrane());
  const Scenario soft = with({{"membrane", "soft"}, {"membrane_stiffness_N_m", "4.5"}});
  ASSERT_TRUE(soft.membrane());
  EXPECT_DOUBLE_EQ(soft.membrane()->perSamplePoint.si(), 4.5);
  EXPECT_THAT(refusal({{"membrane", "torn"}}), HasSubstr("it must be 'rigid' or 'soft'."));
}

TEST(Partition, RupturesOnlyIfItsStrengthIsGiven)
{
  const Scenario usual = with({});
  EXPECT_EQ(usual.parameters().partitionStrength.si(), 0.0);
  EXPECT_THAT(usual.text(), testing::Not(HasSubstr("partition_strength_N")));
  const Scenario weak = with({{"partition_strength_N", "0.088"}});
  EXPECT_DOUBLE_EQ(weak.parameters().partitionStrength.si(), 0.088);
  EXPECT_THAT(weak.text(), HasSubstr("partition_strength_N = 0.088"));
  EXPECT_THAT(refusal({{"partition_strength_N", "-0.1"}}), HasSubstr("partition_strength_N"));
}

TEST(Technique, AdvanceOffStyletTakesTheHoldDepthOfTheArray)
{
  const Scenario scenario = with({{"technique", "aos"}, {"array", "contour-advance"}});
  ASSERT_TRUE(scenario.engine().styletHoldDepth);
  EXPECT_DOUBLE_EQ(*scenario.engine().styletHoldDepth, scenario.array().stylet.holdDepth->si());
  EXPECT_FALSE(with({{"technique", "standard"}}).engine().styletHoldDepth);
}

TEST(Technique, AdvanceOffStyletNeedsAStylet)
{
  EXPECT_THAT(refusal({{"technique", "aos"}, {"array", "flex28"}}),
              HasSubstr("technique is 'aos', but the array FLEX28 has no stylet."));
  EXPECT_THAT(refusal({{"technique", "shove"}}), HasSubstr("it must be 'standard' or 'aos'"));
}

}  // namespace
}  // namespace perilymph::session
