// SPDX-License-Identifier: BSD-3-Clause

// A change of the setup updates what depends on it and nothing else; a modified preset no longer
// has the preset's name.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "gui/run/ScenarioDifference.h"
#include "gui/run/UserSettings.h"
#include "gui/setup/PatientSetup.h"
#include "gui/setup/Setup.h"
#include "gui/setup/StopTravel.h"
#include "perilymph/foundation/Resources.h"
#include "perilymph/session/InsertionParameters.h"

namespace perilymph::gui {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

SetupOrigin originOf(const char* scenario)
{
  const auto loaded = session::loadScenario(scenario);
  EXPECT_TRUE(loaded) << loaded.error().message;
  return {{*loaded, {}}, SetupOrigin::Kind::preset};
}

Setup after(const Setup& now, const SetupOrigin& origin, SetupField field,
            session::Overrides values)
{
  const auto made = changed(now, origin, {field, std::move(values), {}, ValueSource::typed});
  EXPECT_TRUE(made) << made.error().message;
  return made ? *made : now;
}

TEST(SetupChange, EveryArrayOfTheCatalogCanReplaceThePublishedOne)
{
  const SetupOrigin origin = originOf("contour-published");
  for (const std::string& name : shippedNames("plugins/electrodes")) {
    const auto made = after(origin.setup, origin, SetupField::array, {{"array", '"' + name + '"'}});
    EXPECT_EQ(made.scenario.arrayName(), name);
    if (name == origin.setup.scenario.arrayName()) {  // as the preset inserts it
      EXPECT_EQ(made.scenario.stopTravel(), millimeters(16.5));
      continue;
    }
    // inserted fully, but for the 2.0 mm that are inside at the start
    EXPECT_GE(made.scenario.stopTravel() + millimeters(0.002),
              made.scenario.array().insertable - millimeters(2));
    EXPECT_EQ(outsideAtStop(made.scenario), Length());
    EXPECT_LE(made.scenario.startInside() + made.scenario.stopTravel(),
              made.scenario.array().insertable + millimeters(1e-9));
  }
}

TEST(SetupChange, AnotherArrayIsAsItsFileSaysAndNotCalibrated)
{
  const SetupOrigin origin = originOf("contour-published");
  ASSERT_FALSE(origin.setup.scenario.calibrationName().empty());
  const auto made =
      after(origin.setup, origin, SetupField::array, {{"array", "\"contour-advance\""}});
  const auto file = findByName("array", "plugins/electrodes", "contour-advance");
  const auto plain = electrode::loadArray(*file);
  ASSERT_TRUE(plain);
  EXPECT_EQ(made.scenario.calibrationName(), "");
  EXPECT_EQ(made.scenario.array().bending.value, plain->bending.value);
  EXPECT_EQ(made.scenario.array().stylet.bending, plain->stylet.bending);
  EXPECT_EQ(made.scenario.array().stylet.residualCurvature, plain->stylet.residualCurvature);
}

TEST(SetupChange, TheFirstArrayChosenAgainIsTheFirstSetupAgain)
{
  const SetupOrigin origin = originOf("contour-published");
  const auto other =
      after(origin.setup, origin, SetupField::array, {{"array", "\"medel-compressed\""}});
  EXPECT_LT(other.scenario.stopTravel(), origin.setup.scenario.stopTravel());
  const auto back = after(other, origin, SetupField::array, {{"array", "\"contour\""}});
  EXPECT_EQ(back.scenario.text(), origin.setup.scenario.text());
  EXPECT_EQ(back.scenario.name(), "contour-published");
}

TEST(SetupChange, AnArrayWithoutAStyletIsNotAdvancedOffOne)
{
  const SetupOrigin origin = originOf("contour-published");
  const auto held = after(origin.setup, origin, SetupField::technique, {{"technique", "\"aos\""}});
  EXPECT_EQ(held.scenario.technique(), session::Technique::advanceOffStylet);
  const auto straight = after(held, origin, SetupField::array, {{"array", "\"flex28\""}});
  EXPECT_EQ(straight.scenario.technique(), session::Technique::standard);
}

TEST(SetupChange, ADepthThatWasChosenStaysWhereTheArrayAllowsIt)
{
  const SetupOrigin origin = originOf("contour-published");
  const auto shallow =
      after(origin.setup, origin, SetupField::stopTravel, {{"stop_travel_mm", "9.5"}});
  const auto other = after(shallow, origin, SetupField::array, {{"array", "\"flex28\""}});
  EXPECT_EQ(other.scenario.stopTravel(), millimeters(9.5));
}

TEST(SetupChange, FullDepthFollowsTheArrayAndTheMessageSaysSo)
{
  const SetupOrigin origin = originOf("contour-published");
  const auto longer = after(origin.setup, origin, SetupField::array, {{"array", "\"flex28\""}});
  EXPECT_EQ(longer.scenario.stopTravel(), millimeters(26));  // 28 mm, of which 2 mm are inside
  EXPECT_EQ(stopChangeText(origin.setup.scenario, longer.scenario).toStdString(),
            "FLEX28: stop at 26.0 mm, full insertion of this array.");
  const auto partial = after(longer, origin, SetupField::stopTravel, {{"stop_travel_mm", "16.5"}});
  EXPECT_EQ(stopText(partial.scenario).toStdString(),
            "partial insertion: 9.5 mm of the array outside");
  EXPECT_TRUE(stopChangeText(longer.scenario, partial.scenario).isEmpty());
}

TEST(SetupChange, AnotherFrictionBringsItsOwnCoefficients)
{
  const SetupOrigin origin = originOf("contour-published");
  const auto made = after(origin.setup, origin, SetupField::friction, {{"friction", "\"tissue\""}});
  // Dohr et al. 2021: 0.24 at the slowest speed
  EXPECT_DOUBLE_EQ(made.scenario.friction().staticCoefficient, 0.24);
  EXPECT_FALSE(made.scenario.friction().bySpeed.isEmpty());
  const auto back = after(made, origin, SetupField::friction, {{"friction", "\"paper\""}});
  EXPECT_DOUBLE_EQ(back.scenario.friction().staticCoefficient, 0.0605);
  EXPECT_TRUE(back.scenario.friction().bySpeed.isEmpty());
}

TEST(SetupChange, ThePointSetHasThePublishedTwelvePoints)
{
  const SetupOrigin origin = originOf("contour-published");
  const auto made = after(origin.setup, origin, SetupField::model, {{"model", "\"points\""}});
  EXPECT_EQ(made.scenario.model(), mechanics::ModelKind::points);
  EXPECT_EQ(made.scenario.nodes(), 12);
  const auto back = after(made, origin, SetupField::model, {{"model", "\"rod\""}});
  EXPECT_EQ(back.scenario.nodes(), 100);
}

TEST(SetupChange, AModifiedPresetDoesNotClaimToBeThePreset)
{
  const SetupOrigin origin = originOf("contour-published");
  const auto made = after(origin.setup, origin, SetupField::speed, {{"speed_mm_s", "1.0"}});
  EXPECT_EQ(made.scenario.name(), "contour-published-modified");
  EXPECT_THAT(made.scenario.title(), HasSubstr("Modified (speed)"));
  EXPECT_THAT(made.scenario.text(), HasSubstr("speed_mm_s = 1.0"));
  EXPECT_THAT(differingText(origin.setup.scenario, made.scenario), ElementsAre("speed"));
  // the text in a recording gives the same scenario
  const auto read = session::parseScenario(made.scenario.text(), "recording");
  ASSERT_TRUE(read) << read.error().message;
  EXPECT_EQ(read->text(), made.scenario.text());
}

TEST(SetupChange, TheSameValueAgainIsNoDifference)
{
  const SetupOrigin origin = originOf("contour-published");
  const auto slow = after(origin.setup, origin, SetupField::speed, {{"speed_mm_s", "1.0"}});
  const auto back = after(slow, origin, SetupField::speed, {{"speed_mm_s", "2.0"}});
  EXPECT_THAT(differingKeys(origin.setup.scenario, back.scenario), IsEmpty());
  EXPECT_EQ(back.scenario.title(), origin.setup.scenario.title());
}

TEST(SetupChange, EditedMeasuresLoseThePublishedName)
{
  const SetupOrigin origin = originOf("contour-published");
  const auto made = after(origin.setup, origin, SetupField::scalaLength,
                          {{"patient_numbers.st_length_mm", "33.2"}});
  EXPECT_EQ(made.scenario.patient().scalaTympaniLength, millimeters(33.2));
  EXPECT_EQ(made.scenario.patient().label, "unnamed");
  EXPECT_EQ(made.sourceOf(SetupField::scalaLength), ValueSource::typed);
  EXPECT_EQ(made.sourceOf(SetupField::windowWidth), ValueSource::standard);
  const auto back =
      after(made, origin, SetupField::scalaLength, {{"patient_numbers.st_length_mm", "35.58"}});
  EXPECT_EQ(back.scenario.patient().label, "published");
}

TEST(SetupChange, AAndBBuildTheMeanCochleaAndThreeLengthsThePublishedOneAgain)
{
  const SetupOrigin origin = originOf("contour-published");
  const auto mean = after(origin.setup, origin, SetupField::anatomy,
                          {{"anatomy", "\"mean\""},
                           {"patient", "\"\""},
                           {"patient_numbers.a_mm", "9.1"},
                           {"patient_numbers.b_mm", "6.8"}});
  ASSERT_TRUE(mean.scenario.patient().basalTurn);
  EXPECT_EQ(mean.scenario.patient().basalTurn->a, millimeters(9.1));
  const auto taller = after(mean, origin, SetupField::heightH, {{"patient_numbers.h_mm", "3.9"}});
  EXPECT_EQ(*taller.scenario.patient().basalTurn->h, millimeters(3.9));
  const auto without = after(taller, origin, SetupField::heightH, {{"patient_numbers.h_mm", ""}});
  EXPECT_FALSE(without.scenario.patient().basalTurn->h);
  const auto clark =
      after(mean, origin, SetupField::anatomy, {{"anatomy", "\"clark\""}, {"patient", "\"\""}});
  EXPECT_EQ(clark.scenario.anatomy(), anatomy::AnatomySource::clark);
}

TEST(SetupChange, WhatIsOutOfRangeIsRefusedWithTheRange)
{
  const SetupOrigin origin = originOf("contour-published");
  const auto made =
      changed(origin.setup, origin, {SetupField::speed, {{"speed_mm_s", "900.0"}}, {}, {}});
  ASSERT_FALSE(made);
  EXPECT_THAT(made.error().message, HasSubstr("200"));
}

TEST(SetupChange, ANameKeepsItsQuotesAndBackslashes)
{
  const SetupOrigin origin = originOf("contour-published");
  const QString name = QStringLiteral("P \"7\" \\ é\n");
  const auto made = after(origin.setup, origin, SetupField::patientLabel,
                          {{"patient_numbers.label", tomlQuoted(name)}});
  EXPECT_EQ(made.scenario.patient().label, "P \"7\" \\ é");
}

TEST(SetupChange, APatientsOwnScenarioIsNamedAfterThePatientAndTheArray)
{
  const auto preset = session::loadScenario("contour-published");
  ASSERT_TRUE(preset);
  session::Overrides label{{"patient_numbers.label", "P-014"}};
  const auto patient = session::parseScenario(preset->text(), "x", label);
  ASSERT_TRUE(patient) << patient.error().message;
  const auto own = asOwn(*patient);
  ASSERT_TRUE(own) << own.error().message;
  EXPECT_EQ(own->name(), "P-014");
  EXPECT_EQ(own->title(), "P-014: Nucleus 24 Contour");
  const SetupOrigin origin{{*own, {}}, SetupOrigin::Kind::own};
  const auto other = after(origin.setup, origin, SetupField::array, {{"array", "\"flex28\""}});
  EXPECT_EQ(other.scenario.title(), "P-014: FLEX28");
}

TEST(PatientsFile, IsNamedWithoutRepeatedDashes)
{
  EXPECT_EQ(fileNameOf("P-017"), "P-017.toml");
  EXPECT_EQ(fileNameOf("P-017 / Müller"), "P-017-M-ller.toml");
  EXPECT_EQ(fileNameOf("/"), "patient.toml");
}

TEST(SetupOfAPatient, KeepsArrayAndTechniqueAndNamesNoFile)
{
  const SetupOrigin origin = originOf("contour-published");
  const auto base = after(origin.setup, origin, SetupField::array, {{"array", "\"flex28\""}});
  anatomy::Patient patient;
  patient.label = "P-017";
  patient.side = anatomy::Side::left;
  patient.basalTurn = {millimeters(9.1), millimeters(6.7), millimeters(3.9)};
  const auto setup = setupOfPatient(patient, &base.scenario);
  ASSERT_TRUE(setup) << setup.error().message;
  EXPECT_EQ(setup->scenario.arrayName(), "flex28");
  EXPECT_EQ(setup->scenario.anatomy(), anatomy::AnatomySource::mean);
  EXPECT_EQ(setup->scenario.patient().basalTurn->h, millimeters(3.9));
  EXPECT_EQ(setup->scenario.patient().side, anatomy::Side::left);
  EXPECT_EQ(setup->scenario.name(), "P-017");
  EXPECT_EQ(setup->scenario.title(), "P-017: FLEX28");
  EXPECT_EQ(setup->scenario.patientName(), "");
  EXPECT_EQ(setup->sourceOf(SetupField::lengthA), ValueSource::typed) << "no CT is named";
  patient.origin.seriesKey = std::string(64, 'a');
  EXPECT_EQ(setupOfPatient(patient, &base.scenario)->sourceOf(SetupField::lengthA),
            ValueSource::ct);
  patient.seal = Seal::changed;
  EXPECT_EQ(setupOfPatient(patient, &base.scenario)->sourceOf(SetupField::lengthA),
            ValueSource::typed);
}

TEST(SetupOfAPatient, IsThatOfAPlanWithTheLastArrayFullyInserted)
{
  anatomy::Patient patient;
  patient.label = "P-017";
  patient.basalTurn = {millimeters(9.1), millimeters(6.7), millimeters(3.9)};
  UserSettings().remove("insertion/array");
  const auto first = setupOfPatient(patient);
  ASSERT_TRUE(first) << first.error().message;
  const auto usual = session::loadScenario(planning::PlanRequest().scenario);
  ASSERT_TRUE(usual);
  EXPECT_EQ(first->scenario.arrayName(), usual->arrayName());

  auto scenario =
      session::loadScenario("surgery-flex28", {{"array", "flex24"}, {"stop_travel_mm", "9"}});
  ASSERT_TRUE(scenario) << scenario.error().message;
  auto own = withPatient(*scenario, patient);
  ASSERT_TRUE(own);
  rememberArray(*own);
  const auto next = setupOfPatient(patient);
  ASSERT_TRUE(next) << next.error().message;
  EXPECT_EQ(next->scenario.arrayName(), "flex24");
  // not the stop of that insertion: the last contact passes the opening by as much as a plan's
  EXPECT_EQ(next->scenario.stopTravel(),
            session::fullTravel(next->scenario.array(), next->scenario.startInside()));
  EXPECT_EQ(next->scenario.speed(), usual->speed());

  // a demonstration is no patient's insertion
  rememberArray(*session::loadScenario("contour-published"));
  EXPECT_EQ(lastArray(), "flex24");
  UserSettings().setValue("insertion/array", "/nowhere/gone.toml");
  EXPECT_EQ(lastArray(), usual->arrayName());
  UserSettings().remove("insertion/array");
}

}  // namespace
}  // namespace perilymph::gui
