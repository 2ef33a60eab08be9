// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/session/Calibration.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "perilymph/session/Scenario.h"
#include "perilymph/test/TemporaryFolder.h"

namespace perilymph::session {
namespace {

using testing::HasSubstr;

TEST(Calibration, StaysWithinAPlatinumStyletAndACarrier)
{
  // 0.82 to 4.2e-6 N.m^2 for a platinum wire of 0.10 to 0.15 mm, 0.1 to 3e-6 for the carrier
  const auto scenario = loadScenario("contour-published");
  ASSERT_TRUE(scenario) << scenario.error().message;
  const FittedValue scale = uncalibrated(scenario->array()).stiffnessScale;
  for (const double factor : {scale.low, scale.high}) {
    const auto array = calibrated(scenario->array(), factor, 0.0);
    EXPECT_GE(array.stylet.bending.si(), 0.82e-6 * (1.0 - 1e-12));
    EXPECT_LE(array.stylet.bending.si(), 4.2e-6 * (1.0 + 1e-12));
    for (const BendingStiffness bending : array.bending.value) {
      EXPECT_GE(bending.si(), 0.1e-6 * (1.0 - 1e-12));
      EXPECT_LE(bending.si(), 3e-6 * (1.0 + 1e-12));
    }
  }
}

TEST(Calibration, ReadsBackFromItsOwnText)
{
  Calibration calibration;
  calibration.label = "a \"quoted\" label";
  calibration.array = "Nucleus 24 Contour";
  calibration.source = "somewhere";
  calibration.stiffnessScale = {1.25, 0.125, 1.0, 1.5};
  calibration.residualCurvature = {0.0625, 0.0, 0.0, 0.25};
  calibration.forces = {{10.6e-3, 0.088, 0.0875}};
  const test::TemporaryFolder folder;
  std::ofstream(folder / "c.toml") << calibrationText(calibration);
  const auto read = loadCalibration(folder / "c.toml");
  ASSERT_TRUE(read) << read.error().message;
  EXPECT_EQ(read->label, calibration.label);
  EXPECT_EQ(read->stiffnessScale.value, 1.25);
  EXPECT_EQ(read->residualCurvature.high, 0.25);
  EXPECT_EQ(read->forces.at(0).wanted, 0.088);
}

TEST(ScenarioCalibration, ScalesTheArrayAndStandsInTheScenariosText)
{
  const auto plain = loadScenario("contour-published", {{"calibration", ""}});
  const auto scaled = loadScenario(
      "contour-published",
      {{"calibration", ""}, {"stiffness_scale", "1.5"}, {"residual_curvature_fraction", "0.1"}});
  ASSERT_TRUE(plain && scaled);
  EXPECT_DOUBLE_EQ(scaled->array().stylet.bending.si(), 1.5 * plain->array().stylet.bending.si());
  EXPECT_EQ(scaled->array().stylet.residualCurvature, 0.1);
  const auto again = parseScenario(scaled->text(), "text");
  ASSERT_TRUE(again) << again.error().message;
  EXPECT_EQ(again->array().stylet.bending, scaled->array().stylet.bending);
  EXPECT_EQ(again->array().stylet.residualCurvature, 0.1);
}

TEST(ScenarioCalibration, DoesNotApplyToANewlyNamedArray)
{
  const auto named = loadScenario("contour-published", {{"array", "contour-advance"}});
  const auto plain =
      loadScenario("contour-published", {{"array", "contour-advance"}, {"calibration", ""}});
  ASSERT_TRUE(named) << named.error().message;
  ASSERT_TRUE(plain) << plain.error().message;
  EXPECT_EQ(named->array().stylet.bending, plain->array().stylet.bending);
  // the same array keeps it
  const auto same = loadScenario("contour-published", {{"array", "contour"}});
  const auto shipped = loadScenario("contour-published");
  ASSERT_TRUE(same && shipped);
  EXPECT_EQ(same->array().stylet.bending, shipped->array().stylet.bending);
}

// A recorded text contains the fitted numbers; they belong to the previous array.
TEST(ScenarioCalibration, OfARecordedTextDoesNotApplyToANewlyNamedArray)
{
  const auto recorded = loadScenario("contour-published");
  const auto plain =
      loadScenario("contour-published", {{"array", "contour-advance"}, {"calibration", ""}});
  ASSERT_TRUE(recorded && plain);
  ASSERT_THAT(recorded->text(), HasSubstr("stiffness_scale"));
  const auto other = parseScenario(recorded->text(), "text", {{"array", "contour-advance"}});
  ASSERT_TRUE(other) << other.error().message;
  EXPECT_EQ(other->array().stylet.bending, plain->array().stylet.bending);
  EXPECT_EQ(other->array().stylet.residualCurvature, plain->array().stylet.residualCurvature);
  EXPECT_EQ(other->calibrationName(), "");
  // unless they are given with the new array
  const auto scaled = parseScenario(recorded->text(), "text",
                                    {{"array", "contour-advance"}, {"stiffness_scale", "2.0"}});
  ASSERT_TRUE(scaled) << scaled.error().message;
  EXPECT_DOUBLE_EQ(scaled->array().stylet.bending.si(), 2.0 * plain->array().stylet.bending.si());
}

TEST(ScenarioCalibration, OfAnotherArrayIsRefused)
{
  const test::TemporaryFolder folder;
  Calibration calibration;
  calibration.array = "another array";
  std::ofstream(folder / "c.toml") << calibrationText(calibration);
  const auto scenario = loadScenario("contour-published", {{"calibration", folder / "c.toml"}});
  ASSERT_FALSE(scenario);
  EXPECT_THAT(scenario.error().message, HasSubstr("another array"));
  EXPECT_THAT(loadScenario("contour-published", {{"calibration", "nowhere"}}).error().message,
              HasSubstr("nowhere"));
}

}  // namespace
}  // namespace perilymph::session
