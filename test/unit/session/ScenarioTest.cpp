// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/session/Scenario.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "perilymph/test/TemporaryFolder.h"

namespace perilymph::session {
namespace {

using testing::AllOf;
using testing::HasSubstr;

std::string refusal(const Overrides& overrides)
{
  const auto scenario = loadScenario("contour-published", overrides);
  return scenario ? "accepted" : scenario.error().message;
}

void write(const std::filesystem::path& file, const std::string& text)
{
  std::ofstream(file) << text;
}

// In binary, 0.002 + 0.0165 is one rounding error above 0.0185.
TEST(AnArrayOf18Point5Millimeters, MayStart2InsideAndTravel16Point5AndNoMore)
{
  const auto travels = [](const char* mm) {
    return refusal({{"array", "hifocus-mid-scala"}, {"stop_travel_mm", mm}});
  };
  EXPECT_EQ(travels("16.5"), "accepted");
  EXPECT_THAT(travels("16.501"), HasSubstr("18.5 mm at most"));
}

TEST(ContourPublished, IsThePublishedExperiment)
{
  const auto scenario = loadScenario("contour-published");
  ASSERT_TRUE(scenario) << scenario.error().message;
  // Todd and Naghdy, sections II.A, II.C, II.D and III
  EXPECT_DOUBLE_EQ(inMillimetersPerSecond(scenario->speed()), 120.0 / 60.0);
  EXPECT_DOUBLE_EQ(inMillimeters(scenario->stopTravel()), 16.5);
  EXPECT_DOUBLE_EQ(inMillimeters(scenario->startInside()), (1.0 + 3.0) / 2.0);
  EXPECT_DOUBLE_EQ(scenario->friction().staticCoefficient, 0.0605);
  EXPECT_DOUBLE_EQ(scenario->friction().kineticCoefficient, 0.0395);
  EXPECT_DOUBLE_EQ(scenario->friction().stoppingCoefficient, 0.0185);
  // silicone's own, not that of the published haptic wall (guide, constants)
  EXPECT_DOUBLE_EQ(scenario->wall().perSamplePoint.si(), 2700.0);
  EXPECT_DOUBLE_EQ(scenario->wall().tangentialPerSamplePoint.si(), 200.0);
  EXPECT_DOUBLE_EQ(inMillimeters(scenario->patient().scalaTympaniLength), 35.58);
  EXPECT_EQ(scenario->engine().coupling, mechanics::Coupling::rigid);
  EXPECT_EQ(scenario->array().name, "Nucleus 24 Contour");
}

TEST(ScenarioText, ReadAgainGivesTheSameModelToTheLastBit)
{
  const Overrides odd = {{"speed_mm_s", "0.3"},
                         {"nodes", "33"},
                         {"stop_travel_mm", "7.7"},
                         {"lead_in_mm", "1.7"},
                         {"start_inside_mm", "1.1"},
                         {"approach_tilt_deg", "3.3"},
                         {"wall_stiffness_N_m", "500.7"},
                         {"patient", "small"},
                         {"title", "\"a \\\"quoted\\\" title\""}};
  const auto first = loadScenario("contour-published", odd);
  ASSERT_TRUE(first) << first.error().message;
  const auto second = parseScenario(first->text(), "elsewhere");
  ASSERT_TRUE(second) << second.error().message;

  EXPECT_EQ(second->text(), first->text());
  EXPECT_EQ(second->patient().scalaTympaniLength, first->patient().scalaTympaniLength);
  EXPECT_EQ(second->patient().roundWindowWidth, first->patient().roundWindowWidth);
  EXPECT_EQ(second->title(), "a \"quoted\" title");
  const auto fingerprint = [](const Scenario& scenario) {
    const auto anatomy = buildAnatomy(scenario);
    EXPECT_TRUE(anatomy);
    const auto model = buildModel(scenario, *anatomy);
    EXPECT_TRUE(model);
    return (*model)->fingerprint;
  };
  EXPECT_EQ(fingerprint(*second), fingerprint(*first));
}

TEST(ScenarioText, CarriesThePatientsNumbersWhenTheFileIsGone)
{
  const test::TemporaryFolder folder;
  write(folder / "somebody.toml",
        "label = \"somebody\"\nside = \"left\"\nst_length_mm = 33.333\nrw_width_mm = 2.011\n"
        "rw_height_mm = 1.777\n");
  write(folder / "mine.toml", "patient = \"somebody.toml\"\n");
  const auto first = loadScenario((folder / "mine.toml").string());
  ASSERT_TRUE(first) << first.error().message;
  EXPECT_EQ(first->patient().side, anatomy::Side::left);

  std::filesystem::remove(folder / "somebody.toml");
  const auto second = parseScenario(first->text(), "recording");
  ASSERT_TRUE(second) << second.error().message;
  EXPECT_EQ(second->patient().scalaTympaniLength, millimeters(33.333));
  EXPECT_EQ(second->patient().roundWindowWidth, millimeters(2.011));
  EXPECT_EQ(second->patient().roundWindowHeight, millimeters(1.777));
  EXPECT_EQ(second->patient().side, anatomy::Side::left);
  EXPECT_EQ(second->patientName(), "somebody.toml");
}

TEST(ScenarioText, IsReplacedByANewlyNamedPatient)
{
  const auto first = loadScenario("contour-published", {{"patient", "small"}});
  ASSERT_TRUE(first) << first.error().message;
  const auto second = parseScenario(first->text(), "recording", {{"patient", "large"}});
  ASSERT_TRUE(second) << second.error().message;
  const auto large = loadScenario("contour-published", {{"patient", "large"}});
  ASSERT_TRUE(large);
  EXPECT_EQ(second->patient().scalaTympaniLength, large->patient().scalaTympaniLength);
}

TEST(ScenarioText, RemembersWhichArrayFileItWasRunWith)
{
  const auto first = loadScenario("contour-published");
  ASSERT_TRUE(first);
  EXPECT_EQ(first->expectedArrayFingerprint(), "");
  EXPECT_EQ(first->arrayFingerprint().size(), 16u);
  const auto second = parseScenario(first->text(), "recording");
  ASSERT_TRUE(second);
  EXPECT_EQ(second->expectedArrayFingerprint(), first->arrayFingerprint());
}

TEST(Scenario, TakesEveryKeyOfTheContract)
{
  // commands.md, "Scenario keys", each with a value other than the default
  const Overrides keys = {{"anatomy", "published"},
                          {"patient", "average"},
                          {"side", "left"},
                          {"array", "contour"},
                          {"technique", "standard"},
                          {"model", "rod"},
                          {"nodes", "64"},
                          {"dt_ms", "0.5"},
                          {"seed", "42"},
                          {"speed_mm_s", "0.9"},
                          {"start_inside_mm", "5"},
                          {"stop_travel_mm", "12"},
                          {"withdraw", "true"},
                          {"stylet_pull_mm_s", "3"},
                          {"lead_in_mm", "2"},
                          {"opening_outward_mm", "0.3"},
                          {"opening_vertical_mm", "-0.2"},
                          {"passage_mm", "1.5"},
                          {"passage_modulus_MPa", "3"},
                          {"passage_friction", "0.2"},
                          {"rib_exit_loss", "0.7"},
                          {"approach_tilt_deg", "-4"},
                          {"approach_turn_deg", "4"},
                          {"friction", "paper"},
                          {"friction_static", "0.3"},
                          {"friction_dynamic", "0.2"},
                          {"friction_stopping", "0.1"},
                          {"wall_stiffness_N_m", "2000"},
                          {"wall_tangential_stiffness_N_m", "900"},
                          {"coupling", "spring"},
                          {"coupling_stiffness_N_m", "300"},
                          {"coupling_damping_N_s_m", "2"},
                          {"force_scale", "3"}};
  const auto scenario = loadScenario("contour-published", keys);
  ASSERT_TRUE(scenario) << scenario.error().message;
  EXPECT_EQ(scenario->patient().side, anatomy::Side::left);
  EXPECT_EQ(scenario->nodes(), 64);
  EXPECT_EQ(scenario->timeStep(), milliseconds(0.5));
  EXPECT_EQ(scenario->seed(), 42);
  EXPECT_EQ(scenario->speed(), millimetersPerSecond(0.9));
  EXPECT_EQ(scenario->startInside(), millimeters(5));
  EXPECT_EQ(scenario->stopTravel(), millimeters(12));
  EXPECT_TRUE(scenario->withdraws());
  EXPECT_EQ(scenario->styletSpeed(), millimetersPerSecond(3));
  EXPECT_EQ(scenario->leadIn(), millimeters(2));
  EXPECT_EQ(scenario->parameters().opening->outward, millimeters(0.3));
  EXPECT_EQ(scenario->parameters().opening->vertical, millimeters(-0.2));
  EXPECT_EQ(scenario->parameters().opening->passage, millimeters(1.5));
  EXPECT_EQ(scenario->parameters().opening->passageModulus, megapascals(3));
  EXPECT_EQ(scenario->parameters().opening->passageFriction, 0.2);
  EXPECT_EQ(scenario->parameters().opening->ribExitLoss, 0.7);
  EXPECT_EQ(scenario->approachTilt(), degrees(-4));
  EXPECT_EQ(scenario->approachTurn(), degrees(4));
  EXPECT_EQ(scenario->friction().staticCoefficient, 0.3);
  EXPECT_EQ(scenario->friction().kineticCoefficient, 0.2);
  EXPECT_EQ(scenario->friction().stoppingCoefficient, 0.1);
  EXPECT_EQ(scenario->wall().perSamplePoint, newtonsPerMeter(2000));
  EXPECT_EQ(scenario->wall().tangentialPerSamplePoint, newtonsPerMeter(900));
  EXPECT_EQ(scenario->engine().coupling, mechanics::Coupling::spring);
  EXPECT_EQ(scenario->engine().couplingStiffness, 300.0);
  EXPECT_EQ(scenario->engine().couplingDamping, 2.0);
  EXPECT_EQ(scenario->engine().forceScale, 3.0);
  EXPECT_EQ(scenario->engine().stopTravel, 12e-3);
}

TEST(ScenarioModel, IsARodUnlessPointsAreNamed)
{
  const auto rod = loadScenario("contour-published");
  EXPECT_EQ(rod->model(), mechanics::ModelKind::rod);
  EXPECT_EQ(rod->nodes(), 100);
  EXPECT_THAT(refusal({{"model", "jelly"}}), AllOf(HasSubstr("jelly"), HasSubstr("points")));
}

TEST(ScenarioModel, OfPointsHasThePublishedTwelveUnlessToldOtherwise)
{
  // the file's 100 nodes are the rod's
  const auto points = loadScenario("contour-published", {{"model", "points"}});
  ASSERT_TRUE(points) << points.error().message;
  EXPECT_EQ(points->model(), mechanics::ModelKind::points);
  EXPECT_EQ(points->nodes(), 12);
  EXPECT_EQ(loadScenario("contour-published", {{"model", "points"}, {"nodes", "5"}})->nodes(), 5);
  EXPECT_EQ(loadScenario("contour-published", {{"model", "rod"}})->nodes(), 100);
  EXPECT_EQ(parseScenario("model = 'points'\n", "points")->nodes(), 12);
  EXPECT_EQ(parseScenario("model = 'points'\nnodes = 9\n", "points", {{"model", "rod"}})->nodes(),
            100);
  EXPECT_THAT(refusal({{"model", "points"}, {"nodes", "1"}}), HasSubstr("between 2 and 18"));
  EXPECT_THAT(refusal({{"model", "points"}, {"nodes", "19"}}),
              AllOf(HasSubstr("nodes"), HasSubstr("19"), HasSubstr("between 2 and 18")));
}

TEST(ScenarioModel, OfPointsReadAgainFromItsTextIsTheSameToTheLastBit)
{
  const auto first = loadScenario("contour-published", {{"model", "points"}, {"nodes", "10"}});
  ASSERT_TRUE(first) << first.error().message;
  const auto second = parseScenario(first->text(), "elsewhere");
  ASSERT_TRUE(second) << second.error().message;
  EXPECT_EQ(first->text(), second->text());
  const auto fingerprint = [](const Scenario& scenario) {
    return (*buildModel(scenario, *buildAnatomy(scenario)))->fingerprint;
  };
  EXPECT_EQ(fingerprint(*first), fingerprint(*second));
  EXPECT_NE(fingerprint(*first), fingerprint(*loadScenario("contour-published")));
}

TEST(Scenario, RefusesAnAnatomyThatItDoesNotKnow)
{
  EXPECT_THAT(refusal({{"anatomy", "banana"}}), AllOf(HasSubstr("banana"), HasSubstr("published")));
}

TEST(ScenarioAnatomy, IsThePublishedOneUnlessAnotherIsNamed)
{
  EXPECT_EQ(parseScenario("", "empty")->anatomy(), anatomy::AnatomySource::mean);
  EXPECT_EQ(loadScenario("contour-published", {{"anatomy", "mean"}})->anatomy(),
            anatomy::AnatomySource::mean);
}

TEST(ScenarioAnatomy, GivesTheLumenOfItsName)
{
  // 900 degrees for the mean and Clark's, 994 for the published one (35.58 mm of its spiral)
  for (const auto& [name, last_deg] :
       {std::pair{"mean", 900.0}, {"clark", 900.0}, {"published", 994.0}}) {
    const auto scenario = loadScenario("contour-published", {{"anatomy", name}});
    ASSERT_TRUE(scenario) << scenario.error().message;
    const auto scala = buildAnatomy(*scenario);
    ASSERT_TRUE(scala) << scala.error().message;
    EXPECT_NEAR(inDegrees((*scala)->lastAngle()), last_deg, 1.0) << name;
  }
}

class PatientOfTheBasalTurn : public testing::Test {
protected:
  void SetUp() override { write(file, "label = \"ab\"\na_mm = 8.9\nb_mm = 6.6\nh_mm = 3.9\n"); }

  const test::TemporaryFolder folder;
  const std::string file = folder / "ab.toml";
};

TEST_F(PatientOfTheBasalTurn, BuildsTheMeanAnatomy)
{
  const auto scenario = parseScenario("", "empty", {{"patient", file}});
  ASSERT_TRUE(scenario) << scenario.error().message;
  EXPECT_EQ(scenario->anatomy(), anatomy::AnatomySource::mean);
  const auto scala = buildAnatomy(*scenario);
  ASSERT_TRUE(scala);
  const double a =
      (*scala)->section(0.0).outerRadius + (*scala)->section(degrees(180).si()).outerRadius;
  EXPECT_NEAR(a, 8.9e-3, 0.02e-3);
}

TEST_F(PatientOfTheBasalTurn, IsCarriedByTheTextToTheLastBit)
{
  const auto first = parseScenario("", "empty", {{"patient", file}});
  ASSERT_TRUE(first) << first.error().message;
  const auto second = parseScenario(first->text(), "recording");
  ASSERT_TRUE(second) << second.error().message;
  EXPECT_EQ(second->text(), first->text());
  EXPECT_EQ(second->patient().basalTurn->a, first->patient().basalTurn->a);
  EXPECT_EQ(*second->patient().basalTurn->h, millimeters(3.9));
}

TEST_F(PatientOfTheBasalTurn, IsRefusedInAnotherAnatomy)
{
  EXPECT_THAT(refusal({{"patient", file}}), AllOf(HasSubstr("'published'"), HasSubstr("'mean'")));
  EXPECT_THAT(refusal({{"patient", file}, {"anatomy", "clark"}}), HasSubstr("clark"));
  EXPECT_THAT(refusal({{"patient", "small"}, {"anatomy", "mean"}}),
              AllOf(HasSubstr("st_length_mm"), HasSubstr("a_mm")));
}

TEST(ScenarioText, OfTheMeanAnatomyReadAgainIsTheSame)
{
  for (const char* anatomy : {"mean", "clark"}) {
    const auto first = loadScenario("contour-published", {{"anatomy", anatomy}});
    ASSERT_TRUE(first) << first.error().message;
    const auto second = parseScenario(first->text(), "recording");
    ASSERT_TRUE(second) << second.error().message;
    EXPECT_EQ(second->text(), first->text());
    EXPECT_STREQ(nameOf(second->anatomy()), anatomy);
  }
}

TEST(Scenario, AnswersAnUnknownFrictionWithTheKnownOnes)
{
  EXPECT_THAT(refusal({{"friction", "soap"}}), AllOf(HasSubstr("'soap'"), HasSubstr("paper")));
}

TEST(Scenario, RefusesFrictionThatGrowsWithSliding)
{
  EXPECT_THAT(refusal({{"friction_dynamic", "0.5"}}),
              AllOf(HasSubstr("friction_dynamic is 0.5"), HasSubstr("0.0605")));
  EXPECT_THAT(refusal({{"friction_stopping", "0.05"}}),
              AllOf(HasSubstr("friction_stopping is 0.05"), HasSubstr("0.0395")));
}

TEST(Scenario, RefusesImpossibleNumbersWithTheRange)
{
  EXPECT_THAT(refusal({{"speed_mm_s", "-3"}}),
              AllOf(HasSubstr("speed_mm_s"), HasSubstr("-3"), HasSubstr("0.01"), HasSubstr("200")));
  EXPECT_THAT(refusal({{"nodes", "1025"}}), AllOf(HasSubstr("1025"), HasSubstr("1024")));
  EXPECT_THAT(refusal({{"dt_ms", "0"}}), HasSubstr("dt_ms"));
  EXPECT_THAT(refusal({{"start_inside_mm", "-1"}}),
              AllOf(HasSubstr("start_inside_mm"), HasSubstr("-1"), HasSubstr("between 0 and 10")));
  EXPECT_THAT(refusal({{"nodes", "many"}}), HasSubstr("nodes"));
}

TEST(Scenario, RefusesUnknownKeysAndNamesTheLikelyOne)
{
  EXPECT_THAT(refusal({{"speed_mms", "2"}}),
              AllOf(HasSubstr("speed_mms"), HasSubstr("speed_mm_s")));
}

TEST(Scenario, RefusesToPushAnArrayDeeperThanItMayGo)
{
  // The insertable length of the Contour is 22 mm; the tip starts 2 mm inside.
  EXPECT_THAT(refusal({{"stop_travel_mm", "20.5"}}), AllOf(HasSubstr("22.5"), HasSubstr("22 mm")));
  EXPECT_EQ(refusal({{"stop_travel_mm", "20"}}), "accepted");
}

TEST(Scenario, LooksForAPatientBesideItsFileFirst)
{
  const test::TemporaryFolder folder;
  write(folder / "small.toml",
        "label = \"my own small one\"\nst_length_mm = 30.0\nrw_width_mm = 1.8\n"
        "rw_height_mm = 1.7\n");
  write(folder / "mine.toml", "patient = \"small\"\n");
  const auto scenario = loadScenario((folder / "mine.toml").string());
  ASSERT_TRUE(scenario) << scenario.error().message;
  EXPECT_EQ(scenario->patient().label, "my own small one");
}

TEST(Scenario, SaysWhichFileAndLineIsWrong)
{
  const test::TemporaryFolder folder;
  write(folder / "bad.toml", "nodes = 50\ndt_ms = 99\n");
  const auto scenario = loadScenario((folder / "bad.toml").string());
  ASSERT_FALSE(scenario);
  EXPECT_THAT(scenario.error().message, AllOf(HasSubstr("bad.toml:2"), HasSubstr("dt_ms is 99")));
}

TEST(Scenario, RefusesPatientNumbersNoCochleaHas)
{
  const auto first = loadScenario("contour-published");
  ASSERT_TRUE(first);
  const auto scenario =
      parseScenario(first->text(), "text", {{"patient_numbers.st_length_mm", "80"}});
  ASSERT_FALSE(scenario);
  EXPECT_THAT(scenario.error().message, AllOf(HasSubstr("st_length_mm"), HasSubstr("80")));
}

}  // namespace
}  // namespace perilymph::session
