// SPDX-License-Identifier: BSD-3-Clause

// Cochlea and model are built in the background: meanwhile the window stays responsive, shows what
// is built, and accepts other requests.

#include <gtest/gtest.h>

#include <QLabel>
#include <QLineEdit>
#include <QProgressBar>
#include <QTest>

#include "WindowRig.h"
#include "gui/pages/insert/BuildingNote.h"
#include "gui/run/ModelBuilder.h"
#include "gui/run/ScenarioDifference.h"
#include "gui/setup/PatientSetup.h"
#include "gui/setup/SetupHistory.h"

namespace perilymph::test {
namespace {

class BuildingACochlea : public testing::Test {
protected:
  const session::Scenario& scenario() { return rig_.window().control().scenario(); }
  bool isBuilding() { return !rig_.button("startButton").isEnabled(); }
  bool ends()
  {
    return WindowRig::waitUntil([&] { return rig_.button("startButton").isEnabled(); });
  }
  QString field(const char* name)
  {
    return rig_.window().findChild<QLineEdit*>(QLatin1String(name))->text();
  }

  /// With cochleae of its own, none of which is built yet.
  WindowRig rig_{{}, std::nullopt, std::make_shared<gui::CochleaStore>()};
};

// Between a key press and the next iteration of the event loop no result can arrive.

TEST_F(BuildingACochlea, GreysStartAndSaysWhy)
{
  rig_.type("panelScalaLength", "31.5");
  EXPECT_TRUE(isBuilding());
  EXPECT_TRUE(rig_.button("startButton").toolTip().contains("being built"));
  EXPECT_TRUE(rig_.label("hintLabel").contains("Building the cochlea"));
  EXPECT_EQ(scenario().patient().scalaTympaniLength, millimeters(35.58));
  ASSERT_TRUE(ends());
  EXPECT_EQ(scenario().patient().scalaTympaniLength, millimeters(31.5));
  EXPECT_TRUE(rig_.button("startButton").toolTip().contains("Space"));
}

TEST_F(BuildingACochlea, HappensForAnotherArrayInTheSameOneToo)
{
  const auto before = rig_.window().control().sharedAnatomy();
  rig_.type("panelNodes", "60");
  EXPECT_TRUE(isBuilding());
  EXPECT_EQ(scenario().nodes(), 100);
  ASSERT_TRUE(ends());
  EXPECT_EQ(scenario().nodes(), 60);
  EXPECT_EQ(rig_.now().nodes, 60u);
  EXPECT_EQ(rig_.window().control().sharedAnatomy(), before);
}

TEST_F(BuildingACochlea, IsCanceledWithEscapeAndThePanelIsRestored)
{
  rig_.type("panelScalaLength", "31.5");
  rig_.type("panelWindowWidth", "2.1");
  ASSERT_TRUE(isBuilding());
  rig_.window().setFocus();
  rig_.pressKey(Qt::Key_Escape);
  EXPECT_FALSE(isBuilding());
  EXPECT_EQ(field("panelScalaLength"), "35.58");
  EXPECT_EQ(rig_.window().setup().now().scenario.text(), scenario().text());
  // the canceled model appears neither now nor with the next change
  rig_.type("panelScalaLength", "33.0");
  ASSERT_TRUE(ends());
  EXPECT_EQ(scenario().patient().scalaTympaniLength, millimeters(33.0));
  EXPECT_EQ(scenario().patient().roundWindowWidth, session::Scenario().patient().roundWindowWidth);
}

TEST_F(BuildingACochlea, CanceledAfterAnUndoGoesForwardAgain)
{
  rig_.type("panelScalaLength", "31.5");
  ASSERT_TRUE(ends());
  rig_.click("undoButton");
  ASSERT_TRUE(isBuilding());
  rig_.pressKey(Qt::Key_Escape);
  EXPECT_EQ(field("panelScalaLength"), "31.50");
  EXPECT_TRUE(rig_.button("undoButton").isEnabled());
}

TEST_F(BuildingACochlea, AnswersOnlyTheNewestRequest)
{
  int prepared = 0;
  QObject::connect(&rig_.window(), &gui::MainWindow::recordingChanged, &rig_.window(),
                   [&prepared] { ++prepared; });
  for (const char* length : {"28", "29", "30", "33.1"}) rig_.type("panelScalaLength", length);
  ASSERT_TRUE(ends());
  EXPECT_EQ(scenario().patient().scalaTympaniLength, millimeters(33.1));
  EXPECT_EQ(prepared, 1);
}

TEST_F(BuildingACochlea, StartsTheInsertionIfStartWasPressed)
{
  rig_.type("panelScalaLength", "31.5");
  rig_.window().setFocus();
  rig_.pressKey(Qt::Key_Space);
  EXPECT_TRUE(rig_.label("hintLabel").contains("the insertion then starts"));
  EXPECT_TRUE(WindowRig::waitUntil([&] { return rig_.travel_mm() > 0.2; }));
  EXPECT_EQ(scenario().patient().scalaTympaniLength, millimeters(31.5));
}

TEST_F(BuildingACochlea, OfAPatientShowsNothingOfTheOneBefore)
{
  anatomy::Patient patient;
  patient.label = "P-301";
  patient.side = anatomy::Side::left;
  patient.basalTurn = {millimeters(8.9), millimeters(6.5), millimeters(3.9)};
  const auto setup = gui::setupOfPatient(patient);
  ASSERT_TRUE(setup) << setup.error().message;
  const auto* stage = rig_.window().findChild<QFrame*>("loadingStage");
  const auto load = [&] {
    rig_.window().load({*setup});
    EXPECT_TRUE(stage->isVisible());
    EXPECT_EQ(stage->geometry(), stage->parentWidget()->rect());
    EXPECT_TRUE(rig_.label("loadingText").contains("P-301"));
    EXPECT_TRUE(rig_.label("patientLabel").contains("P-301"));
    EXPECT_TRUE(rig_.window().windowTitle().contains("P-301"));
  };
  load();
  rig_.pressKey(Qt::Key_Escape);
  EXPECT_FALSE(stage->isVisible());
  EXPECT_FALSE(rig_.label("patientLabel").contains("P-301"));
  EXPECT_FALSE(rig_.window().windowTitle().contains("P-301"));
  load();
  ASSERT_TRUE(WindowRig::waitUntil([&] { return !stage->isVisible(); }));
  EXPECT_EQ(scenario().patient().label, "P-301");
  EXPECT_TRUE(rig_.label("patientLabel").contains("P-301"));
}

TEST_F(BuildingACochlea, IsSkippedForChangesThatDoNotAffectTheModel)
{
  rig_.type("panelSpeed", "3.0");
  EXPECT_FALSE(isBuilding());
  EXPECT_EQ(scenario().speed(), millimetersPerSecond(3));
}

TEST(ANoteOfWhatIsBuilt, ComesAfterASecondAndCanBeCanceled)
{
  QWidget page;
  page.resize(600, 400);
  gui::BuildingNote note(&page);
  page.show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&page));
  note.show(0);
  EXPECT_FALSE(note.isVisible());
  note.show(999);
  EXPECT_FALSE(note.isVisible());
  note.show(2100);
  ASSERT_TRUE(note.isVisible());
  EXPECT_EQ(note.findChild<QLabel*>("buildingText")->text(), QString("Building the cochlea… 2 s"));
  EXPECT_TRUE(page.rect().contains(note.geometry()));
  int canceled = 0;
  QObject::connect(&note, &gui::BuildingNote::cancelRequested, &note, [&canceled] { ++canceled; });
  QTest::mouseClick(note.findChild<QAbstractButton*>("cancelBuildButton"), Qt::LeftButton);
  EXPECT_EQ(canceled, 1);
  note.show(0);
  EXPECT_FALSE(note.isVisible());
}

// A model reused from the previous scenario equals the one that would be built.
TEST(TwoScenariosOfTheSameModel, HaveTheSameFingerprint)
{
  const auto published = session::loadScenario("contour-published");
  ASSERT_TRUE(published);
  const auto anatomy = session::buildAnatomy(*published);
  ASSERT_TRUE(anatomy);
  const auto model = session::buildModel(*published, *anatomy);
  ASSERT_TRUE(model);
  int same = 0;
  const session::Overrides each{{"title", "another"},       {"speed_mm_s", "0.7"},
                                {"stop_travel_mm", "9.0"},  {"force_scale", "3.0"},
                                {"side", "left"},           {"nodes", "60"},
                                {"friction_static", "0.2"}, {"wall_stiffness_N_m", "2000.0"},
                                {"start_inside_mm", "1.0"}, {"opening", "round-window"},
                                {"membrane", "soft"},       {"dt_ms", "0.5"},
                                {"stiffness_scale", "1.5"}, {"approach_tilt_deg", "3.0"}};
  for (const auto& [key, value] : each) {
    const auto other = session::loadScenario("contour-published", {{key, value}});
    ASSERT_TRUE(other) << key;
    const auto built = session::buildModel(*other, *anatomy);
    ASSERT_TRUE(built) << key;
    const bool isSame = (*built)->fingerprint == (*model)->fingerprint;
    if (gui::haveSameModel(*published, *other)) {
      EXPECT_TRUE(isSame) << key;
      ++same;
    }
  }
  EXPECT_EQ(same, 5);
}

}  // namespace
}  // namespace perilymph::test
