// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include <fstream>
#include <sstream>

#include "perilymph/electrode/WirePacking.h"
#include "perilymph/foundation/Resources.h"
#include "perilymph/session/Scenario.h"
#include "perilymph/test/TemporaryFolder.h"

// Keys of wires and taper: absent in all earlier texts, and then arrays are elastic and as in their files.

namespace perilymph::session {
namespace {

using testing::HasSubstr;
using testing::Not;

const Overrides elasticWires = {{"array", "slim-straight"}};
const Overrides yieldingWires = {{"array", "slim-straight"}, {"wire_yield_MPa", "250"}};
// 0.11 mm at 1500 MPa hold 333 uN m, and the carrier curls with 348
const Overrides yieldingStylet = {
    {"calibration", ""}, {"stiffness_scale", "0.8"}, {"stylet_yield_MPa", "1500"}};

Result<Scenario> with(Overrides overrides, const Overrides& more = {})
{
  overrides.insert(overrides.end(), more.begin(), more.end());
  return loadScenario("contour-published", overrides);
}

std::string refusalOfYield(const Overrides& overrides, const Overrides& more = {})
{
  const auto scenario = with(overrides, more);
  return scenario ? "accepted" : scenario.error().message;
}

std::shared_ptr<const mechanics::InsertionModel> modelOf(const Scenario& scenario)
{
  const auto anatomy = buildAnatomy(scenario);
  return *buildModel(scenario, *anatomy);
}

TEST(ScenarioYield, IsOffInShippedScenariosAndNotMentioned)
{
  for (const Overrides& shipped : {Overrides{}, elasticWires}) {
    const auto scenario = with(shipped);
    ASSERT_TRUE(scenario);
    EXPECT_FALSE(scenario->array().yields());
    EXPECT_THAT(scenario->text(), Not(HasSubstr("yield")));
  }
}

TEST(ScenarioYield, OfATextIsReadAgainAsItWas)
{
  for (const Overrides& yielding : {yieldingWires, yieldingStylet}) {
    const auto scenario = with(yielding);
    ASSERT_TRUE(scenario) << scenario.error().message;
    EXPECT_TRUE(scenario->array().yields());
    const auto again = parseScenario(scenario->text(), "recording");
    ASSERT_TRUE(again) << again.error().message;
    EXPECT_EQ(again->text(), scenario->text());
    EXPECT_EQ(modelOf(*again)->fingerprint, modelOf(*scenario)->fingerprint);
  }
}

TEST(ScenarioYield, ReachesTheModel)
{
  const auto wires = modelOf(*with(yieldingWires));
  EXPECT_NE(wires->fingerprint, modelOf(*with(elasticWires))->fingerprint);
  // the range of the file is what is known, not what is computed: 22 wires, s d^3 / 6 = 0.651 uN m each
  EXPECT_NEAR(wires->wires[0].moment.front(), 22 * 0.65104e-6, 1e-10);
  const auto stylet = modelOf(*with(yieldingStylet));
  // platinum of 168 GPa with EI = 1.21e-6 N m2 is 0.11006 mm thick, whatever the calibration scales
  EXPECT_NEAR(stylet->styletMoment, 1500e6 * std::pow(0.110059e-3, 3) / 6.0, 1e-7);
}

TEST(ScenarioYield, OfAnotherArrayIsForgotten)
{
  const auto other = with(yieldingWires)->with({{"array", "contour-advance"}});
  ASSERT_TRUE(other) << other.error().message;
  EXPECT_FALSE(other->array().yields());
}

TEST(ScenarioYield, OutOfPlaceIsRefused)
{
  EXPECT_THAT(refusalOfYield(elasticWires, {{"wire_yield_MPa", "10"}}), HasSubstr("20"));
  EXPECT_THAT(refusalOfYield(elasticWires, {{"wire_yield_MPa", "400"}}),
              HasSubstr("wire_yield_MPa is 400, and the file of the array Nucleus Slim Straight "
                        "(CI422, CI522, CI622) states 150 to 350. Set it within them."));
  EXPECT_THAT(refusalOfYield({{"calibration", ""}}, {{"wire_yield_MPa", "250"}}),
              HasSubstr("the file of the array Nucleus 24 Contour has no table [wires]"));
  EXPECT_THAT(refusalOfYield(elasticWires, {{"stylet_yield_MPa", "250"}}),
              HasSubstr("has no stylet"));
  EXPECT_THAT(refusalOfYield(yieldingWires, {{"model", "points"}}),
              HasSubstr("the published model of points does not yield"));
}

TEST(ScenarioYield, AndACalibrationOfTheElasticArrayAreRefused)
{
  EXPECT_THAT(refusalOfYield({{"stylet_yield_MPa", "1500"}}),
              HasSubstr("the calibration 'contour-published' was fitted with an elastic one: "
                        "together they count one softness twice"));
}

TEST(ScenarioYield, OfAStyletThatCannotHoldItsCarrierIsRefused)
{
  const auto scenario = with(yieldingStylet, {{"stylet_yield_MPa", "600"}});
  ASSERT_TRUE(scenario);
  const auto model = buildModel(*scenario, *buildAnatomy(*scenario));
  ASSERT_FALSE(model);
  // 600 MPa hold 133.3 uN m; EI kappa of the carrier is 0.8 x 0.87e-6 N m2 x 400 / m 16 mm from the tip
  EXPECT_THAT(model.error().message, HasSubstr("The stylet yields at 133.3 uN.m, and the carrier "
                                               "that it has to keep straight curls with 27"));
}

TEST(ScenarioWirePacking, IsThatOfTheFileWithoutTheKey)
{
  const auto scenario = with(elasticWires);
  ASSERT_TRUE(scenario);
  EXPECT_THAT(scenario->text(), Not(HasSubstr("wire_packing")));
  EXPECT_NEAR(*electrode::wirePacking(scenario->array()), 1.2, 0.012);
}

TEST(ScenarioWirePacking, IsThatOfTheKeyForEveryStraightArray)
{
  const auto scenario = with(elasticWires, {{"wire_packing", "0.3"}});
  ASSERT_TRUE(scenario) << scenario.error().message;
  EXPECT_NEAR(*electrode::wirePacking(scenario->array()), 0.3, 1e-9);
  const auto again = parseScenario(scenario->text(), "recording");
  ASSERT_TRUE(again) << again.error().message;
  EXPECT_EQ(again->array().bending.value, scenario->array().bending.value);
  EXPECT_EQ(again->text(), scenario->text());
  // chosen after a precurved one, whose stiffness the key leaves as it is
  const auto contour = again->with({{"array", "contour"}, {"stop_travel_mm", "10"}});
  ASSERT_TRUE(contour) << contour.error().message;
  EXPECT_EQ(contour->array().bending.value, with({{"calibration", ""}})->array().bending.value);
  const auto flex = contour->with({{"array", "flex28"}});
  ASSERT_TRUE(flex) << flex.error().message;
  EXPECT_NEAR(*electrode::wirePacking(flex->array()), 0.3, 1e-9);
}

TEST(ScenarioWirePacking, DoesNotSoftenWiresThatYieldOnceMore)
{
  const auto both = with(yieldingWires, {{"wire_packing", "0.3"}});
  ASSERT_TRUE(both) << both.error().message;
  EXPECT_EQ(both->array().bending.value, with(yieldingWires)->array().bending.value);
}

TEST(ScenarioTaper, IsAPlaceInTheRangeOfTheFile)
{
  // 0.8 to 1.3 mm at the most basal contact; the straight line of the file has 1.2
  const auto width_mm = [](const Overrides& more) {
    const auto scenario = with({{"array", "flexsoft"}}, more);
    EXPECT_TRUE(scenario) << scenario.error().message;
    const auto again = parseScenario(scenario->text(), "recording");
    EXPECT_TRUE(again) << again.error().message;
    const electrode::ArrayDesign& array = again->array();
    return inMillimeters(array.diameter.at(array.contactsFromTip.back()));
  };
  EXPECT_NEAR(width_mm({}), 1.196, 0.001);
  EXPECT_NEAR(width_mm({{"taper_fraction", "0"}}), 0.8, 1e-9);
  EXPECT_NEAR(width_mm({{"taper_fraction", "0.5"}}), 1.05, 1e-9);
  const auto none = with({{"array", "flex28"}}, {{"taper_fraction", "0.5"}});
  ASSERT_TRUE(none) << none.error().message;
  EXPECT_EQ(none->array().diameter.value, with({{"array", "flex28"}})->array().diameter.value);
  EXPECT_THAT(refusalOfYield({{"array", "flexsoft"}}, {{"taper_fraction", "1.1"}}),
              HasSubstr("taper_fraction"));
}

TEST(ScenarioWirePacking, IsRefusedBeyondItsRange)
{
  EXPECT_THAT(refusalOfYield(elasticWires, {{"wire_packing", "2.5"}}), HasSubstr("wire_packing"));
  EXPECT_THAT(refusalOfYield(elasticWires, {{"wire_packing", "-0.1"}}), HasSubstr("wire_packing"));
}

}  // namespace
}  // namespace perilymph::session
