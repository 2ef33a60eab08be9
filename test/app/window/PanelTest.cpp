// SPDX-License-Identifier: BSD-3-Clause

// The panel on the left: its values are those of the insertion, and every change can be undone.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QApplication>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTest>

#include "WindowRig.h"
#include "gui/pages/ct/CtNextSteps.h"
#include "gui/pages/insert/ForceCharts.h"
#include "gui/pages/insert/InsertionViews.h"
#include "gui/pages/insert/SidePanel.h"
#include "gui/setup/SetupHistory.h"
#include "gui/widgets/Notice.h"
#include "gui/widgets/Selector.h"
#include "perilymph/session/RecordedInsertion.h"
#include "perilymph/test/TemporaryFolder.h"

namespace perilymph::test {
namespace {

using ::testing::HasSubstr;

class Panel : public testing::Test {
protected:
  const session::Scenario& scenario() { return rig_.window().control().scenario(); }
  /// The window shows the panel's setup, and nothing is being built.
  bool settles()
  {
    return WindowRig::waitUntil([&] {
      return scenario().text() == rig_.window().setup().now().scenario.text() &&
             rig_.button("startButton").isEnabled();
    });
  }
  QString field(const char* name)
  {
    return rig_.window().findChild<QLineEdit*>(QLatin1String(name))->text();
  }
  QWidget& part(const char* name)
  {
    return *rig_.window().findChild<QWidget*>(QLatin1String(name));
  }

  WindowRig rig_;
};

TEST_F(Panel, ThreeNumbersAndAnArrayMakeTheInsertion)
{
  rig_.type("panelScalaLength", "33.1");
  rig_.type("panelWindowWidth", "2.1");
  rig_.type("panelWindowHeight", "1.8");
  rig_.choose("arraySelector", "slim-straight");
  rig_.type("panelSpeed", "5.0");
  ASSERT_TRUE(settles());
  EXPECT_EQ(scenario().patient().scalaTympaniLength, millimeters(33.1));
  EXPECT_EQ(scenario().patient().roundWindowWidth, millimeters(2.1));
  EXPECT_EQ(scenario().patient().roundWindowHeight, millimeters(1.8));
  EXPECT_EQ(scenario().arrayName(), "slim-straight");
  EXPECT_EQ(scenario().speed(), millimetersPerSecond(5));
  rig_.click("startButton");
  EXPECT_TRUE(WindowRig::waitUntil([&] { return rig_.travel_mm() > 0.5; }));
}

TEST_F(Panel, AnotherCochleaIsAnotherPicture)
{
  const QImage before = rig_.picture();
  rig_.type("panelScalaLength", "28");
  ASSERT_TRUE(settles());
  EXPECT_NE(rig_.picture(), before);
}

TEST_F(Panel, ChangesAreUndoneAndDoneAgainInTheirOrder)
{
  rig_.choose("arraySelector", "flex28");
  rig_.type("panelSpeed", "1.5");
  ASSERT_TRUE(settles());
  rig_.window().setFocus();
  rig_.pressKey(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(scenario().speed(), millimetersPerSecond(2));
  EXPECT_EQ(scenario().arrayName(), "flex28");
  rig_.pressKey(Qt::Key_Z, Qt::ControlModifier);
  ASSERT_TRUE(settles());
  EXPECT_EQ(scenario().arrayName(), "contour");
  EXPECT_EQ(scenario().name(), "contour-published");
  rig_.pressKey(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
  rig_.pressKey(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
  ASSERT_TRUE(settles());
  EXPECT_EQ(scenario().arrayName(), "flex28");
  EXPECT_EQ(scenario().speed(), millimetersPerSecond(1.5));
  EXPECT_EQ(field("panelSpeed"), "1.5");
}

TEST_F(Panel, EditsOfOneFieldAreUndoneTogetherAndNamed)
{
  rig_.type("panelSpeed", "1.5");
  rig_.type("panelSpeed", "1.0");
  EXPECT_EQ(rig_.window().setup().stack().count(), 1);
  EXPECT_TRUE(rig_.button("undoButton").toolTip().contains("speed 1.0 mm/s"));
  rig_.click("undoButton");
  EXPECT_EQ(scenario().speed(), millimetersPerSecond(2));
  EXPECT_FALSE(rig_.button("undoButton").isEnabled());
}

TEST_F(Panel, AnInsertionBetweenTwoEditsSeparatesThem)
{
  rig_.type("panelSpeed", "4.0");
  rig_.click("startButton");
  ASSERT_TRUE(WindowRig::waitUntil([&] { return rig_.travel_mm() > 0.2; }));
  rig_.click("resetButton");
  rig_.type("panelSpeed", "1.0");
  EXPECT_EQ(rig_.window().setup().stack().count(), 2);
}

TEST_F(Panel, UndoInAFieldGoesToTheWindowOnceNothingIsTyped)
{
  rig_.choose("frictionSelector", "tissue");
  auto& speed = static_cast<QLineEdit&>(part("panelSpeed"));
  speed.setFocus();
  QTest::keyClicks(&speed, "7");
  QTest::keyClick(&speed, Qt::Key_Escape);
  QTest::keyClick(&speed, Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(scenario().friction().staticCoefficient, 0.0605);
}

TEST_F(Panel, AnyChangeOfThePublishedScenarioIsMarkedAndTheWayBackIsOneClick)
{
  EXPECT_FALSE(part("modifiedLabel").isVisible());
  EXPECT_FALSE(part("restoreButton").isVisible());
  rig_.click("expertFold");
  rig_.choose("modelSelector", "points");
  EXPECT_TRUE(part("modifiedLabel").isVisible());
  EXPECT_TRUE(part("modifiedBadge").isVisible());
  EXPECT_TRUE(part("modifiedLabel").toolTip().contains("model"));
  EXPECT_EQ(rig_.button("restoreButton").text(), "Restore the published values");
  EXPECT_TRUE(part("scenarioTitle").toolTip().contains("Todd and Naghdy"));
  rig_.click("restoreButton");
  EXPECT_FALSE(part("modifiedLabel").isVisible());
  EXPECT_EQ(scenario().name(), "contour-published");
  // the reset to the published scenario can be undone like any change
  rig_.click("undoButton");
  ASSERT_TRUE(settles());
  EXPECT_EQ(scenario().model(), mechanics::ModelKind::points);
}

TEST_F(Panel, AnotherArrayIsInsertedFullyAndSaysSo)
{
  rig_.choose("arraySelector", "flex28");
  ASSERT_TRUE(settles());
  EXPECT_EQ(field("panelStop"), "26.0");
  EXPECT_EQ(rig_.label("stopNote"), "full insertion of this array");
  EXPECT_TRUE(rig_.window().notice().isVisible());
  EXPECT_TRUE(rig_.window().notice().sentence().contains("stop at 26.0 mm"));
  EXPECT_TRUE(rig_.label("scenarioTitle").startsWith("FLEX28 · modified from contour-published"))
      << rig_.label("scenarioTitle").toStdString();
}

TEST_F(Panel, PublishedMeasurementsAreShownUnderTheirOwnConditionsOnly)
{
  const auto picture = [&] {
    while (rig_.window().views().charts()->renderNext()) {
    }
    return part("travelPane").grab().toImage();
  };
  const auto showsMeasurements = [&] {
    const QImage on = picture();
    rig_.click("showExperiment");
    const QImage off = picture();
    rig_.click("showExperiment");
    return on != off;
  };
  EXPECT_TRUE(part("showExperiment").isEnabled());
  EXPECT_TRUE(showsMeasurements());
  rig_.type("panelSpeed", "1.0");
  ASSERT_TRUE(settles());
  EXPECT_FALSE(part("showExperiment").isEnabled());
  EXPECT_FALSE(showsMeasurements());
  EXPECT_TRUE(part("showExperiment").toolTip().contains("speed"));
  rig_.click("restoreButton");
  ASSERT_TRUE(settles());
  EXPECT_TRUE(showsMeasurements());
}

TEST_F(Panel, NumericalSettingsAndTimingAreFoldedAwayForExperts)
{
  for (const char* name : {"modelSelector", "panelNodes", "timingLabel"})
    EXPECT_FALSE(part(name).isVisible()) << name;
  EXPECT_FALSE(rig_.label("statusLabel").contains("fps"));
  rig_.click("expertFold");
  for (const char* name : {"modelSelector", "panelNodes", "timingLabel"})
    EXPECT_TRUE(part(name).isVisible()) << name;
  EXPECT_TRUE(WindowRig::waitUntil([&] { return rig_.label("timingLabel").contains("fps"); }));
}

TEST_F(Panel, WhatAnArrayCannotIsGreyedWithTheReason)
{
  auto& technique = static_cast<gui::Selector&>(part("techniqueSelector"));
  EXPECT_TRUE(technique.isPossible("aos"));
  rig_.choose("arraySelector", "flex28");
  EXPECT_FALSE(technique.isPossible("aos"));
  EXPECT_TRUE(technique.itemText(technique.findData("aos")).contains("no stylet"));
}

TEST_F(Panel, NothingCanBeChangedDuringAnInsertionButAfterIt)
{
  rig_.click("startButton");
  ASSERT_TRUE(WindowRig::waitUntil([&] { return rig_.travel_mm() > 0.3; }));
  ASSERT_TRUE(WindowRig::waitUntil([&] { return part("lockedLabel").isVisible(); }));
  for (const char* name : {"panelScalaLength", "panelSpeed", "arraySelector", "scriptedChoice"})
    EXPECT_FALSE(part(name).isEnabled()) << name;
  rig_.pressKey(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_GT(rig_.travel_mm(), 0.0);
  rig_.click("resetButton");
  EXPECT_TRUE(part("panelSpeed").isEnabled());
}

TEST_F(Panel, WhatIsTypedCountsWhenStartIsPressed)
{
  auto& length = static_cast<QLineEdit&>(part("panelScalaLength"));
  length.setFocus();
  length.selectAll();
  QTest::keyClicks(&length, "31.5");
  rig_.click("startButton");
  ASSERT_TRUE(WindowRig::waitUntil([&] { return rig_.travel_mm() > 0.2; }));
  EXPECT_EQ(scenario().patient().scalaTympaniLength, millimeters(31.5));
}

TEST_F(Panel, AnImpossibleNumberIsNotInserted)
{
  auto& length = static_cast<QLineEdit&>(part("panelScalaLength"));
  length.setFocus();
  length.selectAll();
  QTest::keyClicks(&length, "99");
  rig_.click("startButton");
  EXPECT_FALSE(rig_.window().control().isRunning());
  EXPECT_TRUE(rig_.label("bannerText").contains("25.0 to 45.0 mm"));
  QTest::keyClick(&length, Qt::Key_Escape);
  EXPECT_EQ(field("panelScalaLength"), "35.58");
}

TEST_F(Panel, TabGoesThroughTheFieldsAndReturnGivesTheKeysBack)
{
  rig_.click("expertFold");
  rig_.window().activateWindow();
  rig_.window().setFocus();
  QStringList visited;
  for (int i = 0; i < 60; ++i) {
    QTest::keyClick(rig_.window().focusWidget(), Qt::Key_Tab);
    visited << rig_.window().focusWidget()->objectName();
  }
  qsizetype last = -1;
  for (const char* name :
       {"panelPatientName", "earSelector", "anatomySelector", "panelScalaLength",
        "panelWindowWidth", "panelWindowHeight", "arraySelector", "techniqueSelector", "panelSpeed",
        "panelStop", "frictionSelector", "openingSelector", "modelSelector", "panelNodes",
        "scriptedChoice", "panelForceScale", "show0"}) {
    const auto place = visited.indexOf(QLatin1String(name));
    EXPECT_GT(place, last) << name << " in " << visited.join(' ').toStdString();
    last = place;
  }
  part("panelSpeed").setFocus();
  QTest::keyClick(&part("panelSpeed"), Qt::Key_Return);
  rig_.pressKey(Qt::Key_2);
  EXPECT_TRUE(WindowRig::waitUntil([&] {
    return rig_.window().view().scene()->preset() == visualization::CameraPreset::microscope;
  }));
}

TEST_F(Panel, FoldsAwayAndComesBack)
{
  auto* panel = rig_.window().findChild<gui::SidePanel*>();
  const int wide = rig_.window().view().width();
  rig_.pressKey(Qt::Key_B);
  EXPECT_TRUE(panel->isCollapsed());
  EXPECT_TRUE(WindowRig::waitUntil([&] { return rig_.window().view().width() > wide; }));
  rig_.click("expandButton");
  EXPECT_FALSE(panel->isCollapsed());
}

TEST_F(Panel, WhatIsHiddenInThePictureStaysHiddenWithAnotherArray)
{
  rig_.click("show2");  // basilar membrane
  rig_.choose("arraySelector", "flex28");
  const QImage hidden = rig_.picture();
  rig_.click("show2");
  EXPECT_NE(rig_.picture(), hidden);
}

TEST(PanelRecording, ToldByNameIsKeptThereWithTheChangesMadeBefore)
{
  const TemporaryFolder folder;
  const auto file = folder / "kept.insertion";
  {
    WindowRig rig({}, file);
    rig.type("panelSpeed", "5.0");
    rig.click("startButton");
    ASSERT_TRUE(WindowRig::waitUntil([&] { return rig.travel_mm() > 0.5; }));
  }
  const auto kept = session::RecordedInsertion::open(file);
  ASSERT_TRUE(kept) << kept.error().message;
  EXPECT_THAT(kept->facts().scenarioText, HasSubstr("speed_mm_s = 5.0"));
  EXPECT_THAT(kept->facts().scenarioText, HasSubstr("Modified (speed)"));
  EXPECT_EQ(kept->facts().scenarioName, "contour-published-modified");
}

TEST(TheCodeOfAMeasuredCochlea, IsRefusedWithASentenceWhereItIsAName)
{
  gui::CtNextSteps onward(nullptr);
  onward.show(true, true, false);
  onward.QWidget::show();
  auto& code = *onward.findChild<QLineEdit*>("ctPatientCode");
  const auto& plan = *onward.findChild<QPushButton*>("planCtButton");
  const auto& refusal = *onward.findChild<QLabel*>("ctCodeRefusal");
  QTest::keyClicks(&code, QStringLiteral("Anna Muster"));
  EXPECT_EQ(code.text(), "Anna Muster") << "what is typed is shown as it is";
  EXPECT_TRUE(refusal.isVisible());
  EXPECT_TRUE(refusal.text().startsWith("'Anna Muster' cannot be a patient code"));
  EXPECT_FALSE(plan.isEnabled());
  code.clear();
  EXPECT_FALSE(refusal.isVisible()) << "nothing is typed yet";
  QTest::keyClicks(&code, QStringLiteral("P-301"));
  EXPECT_FALSE(refusal.isVisible());
  EXPECT_TRUE(plan.isEnabled());
}

}  // namespace
}  // namespace perilymph::test
