// SPDX-License-Identifier: BSD-3-Clause

// The first screen: the way to an insertion for a surgeon with a patient's measures, a clinician
// and a visitor.

#include <gtest/gtest.h>

#include <QLabel>
#include <QLineEdit>
#include <QTest>

#include "DataFolder.h"
#include "WindowRig.h"
#include "perilymph/foundation/Resources.h"

namespace perilymph::test {
namespace {

/// A window with its first screen that writes to a temporary folder.
class FirstScreen : public testing::Test {
protected:
  FirstScreen()
  {
    rig_ = std::make_unique<WindowRig>();
    rig_->window().showPage(gui::Page::start);
  }

  void type(const char* field, const char* text)
  {
    auto* line = rig_->window().findChild<QLineEdit*>(QLatin1String(field));
    ASSERT_NE(line, nullptr) << field;
    line->clear();
    QTest::keyClicks(line, QLatin1String(text));
  }

  const session::Scenario& scenario() { return rig_->window().control().scenario(); }

  DataFolder data_;
  std::unique_ptr<WindowRig> rig_;
};

TEST_F(FirstScreen, OneClickShowsAMovingArray)
{
  rig_->click("demonstrationCard");
  EXPECT_EQ(rig_->window().page(), gui::Page::insert);
  EXPECT_TRUE(WindowRig::comes([&] { return rig_->travel_mm() > 0.2; }));
}

TEST_F(FirstScreen, TheMeanCochleaIsOneClickAway)
{
  rig_->click("meanCard");
  EXPECT_TRUE(
      WindowRig::comes([&] { return scenario().anatomy() == anatomy::AnatomySource::mean; }));
  EXPECT_EQ(rig_->travel_mm(), 0.0);
  EXPECT_TRUE(rig_->button("startButton").isEnabled());
}

TEST_F(FirstScreen, APatientsThreeLengthsMakeThePatientsCochlea)
{
  rig_->click("patientCard");
  type("patientName", "P 014");
  type("stLength", "34.2");
  type("rwWidth", "2.05");
  type("rwHeight", "1.7");
  rig_->click("leftEar");
  rig_->click("usePatientButton");
  ASSERT_TRUE(WindowRig::comes([&] { return scenario().patient().label == "P 014"; }));
  EXPECT_EQ(scenario().anatomy(), anatomy::AnatomySource::published);
  EXPECT_EQ(scenario().patient().side, anatomy::Side::left);
  EXPECT_EQ(scenario().patient().scalaTympaniLength, millimeters(34.2));
  EXPECT_EQ(scenario().patient().roundWindowWidth, millimeters(2.05));
  EXPECT_EQ(scenario().patient().roundWindowHeight, millimeters(1.7));
  EXPECT_TRUE(rig_->label("patientLabel").contains("P 014"));
  EXPECT_TRUE(rig_->label("patientLabel").contains("left"));
  // the measures are saved
  EXPECT_TRUE(anatomy::loadPatient(patientFolder() / "P-014.toml"));
}

TEST_F(FirstScreen, AAndBMakeAMeanCochleaOfThatSize)
{
  rig_->click("patientCard");
  rig_->click("byBasalTurn");
  type("aValue", "9.0");
  type("bValue", "6.5");
  rig_->click("usePatientButton");
  ASSERT_TRUE(WindowRig::comes([&] { return scenario().patient().basalTurn.has_value(); }));
  EXPECT_EQ(scenario().anatomy(), anatomy::AnatomySource::mean);
  EXPECT_EQ(scenario().patient().basalTurn->a, millimeters(9.0));
  EXPECT_EQ(scenario().patient().basalTurn->b, millimeters(6.5));
  EXPECT_FALSE(scenario().patient().basalTurn->h);
}

TEST_F(FirstScreen, ASurgeonInsertsAnotherArrayIntoThePatientsCochleaAndTakesItBack)
{
  rig_->click("patientCard");
  type("patientName", "P 014");
  type("stLength", "34.2");
  type("rwWidth", "2.05");
  type("rwHeight", "1.7");
  rig_->click("usePatientButton");
  ASSERT_TRUE(WindowRig::comes([&] { return scenario().patient().label == "P 014"; }));
  // measured, as in the form, and no preset
  int measured = 0;
  for (const QLabel* label : rig_->window().findChildren<QLabel*>())
    measured += label->isVisible() && label->text() == "from CT" ? 1 : 0;
  EXPECT_EQ(measured, 3);
  rig_->choose("arraySelector", "slim-straight");
  rig_->type("panelSpeed", "8");
  EXPECT_FALSE(rig_->window().findChild<QLabel*>("modifiedLabel")->isVisible());
  EXPECT_TRUE(rig_->label("scenarioTitle").contains("P 014: Nucleus Slim Straight"));

  ASSERT_TRUE(WindowRig::comes([&] { return rig_->button("startButton").isEnabled(); }));
  rig_->click("startButton");
  ASSERT_TRUE(WindowRig::comes([&] { return rig_->now().output.axialForce > 2e-3; }));
  EXPECT_TRUE(WindowRig::comes([&] { return rig_->readOut("forceReadOut").toDouble() >= 2.0; }));
  rig_->click("resetButton");
  rig_->pressKey(Qt::Key_Z, Qt::ControlModifier);
  rig_->pressKey(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_TRUE(WindowRig::comes([&] { return scenario().arrayName() == "contour"; }));
  EXPECT_EQ(scenario().patient().scalaTympaniLength, millimeters(34.2));
  EXPECT_TRUE(rig_->label("scenarioTitle").contains("P 014: Nucleus 24 Contour"));
}

TEST_F(FirstScreen, AnImpossibleNumberIsRefusedWithTheAllowedRange)
{
  rig_->click("patientCard");
  for (const char* error : {"", "12", "99", "a", "3,4,5", "nan", "-34"}) {
    type("stLength", error);
    EXPECT_FALSE(rig_->button("usePatientButton").isEnabled()) << error;
    bool isSaid = false;
    for (const QLabel* label : rig_->window().findChildren<QLabel*>())
      isSaid = isSaid || (label->isVisible() && label->text().contains("25.0") &&
                          label->text().contains("45.0 mm") && label->property("error").toBool());
    EXPECT_TRUE(isSaid) << error;
  }
  type("stLength", "34");
  EXPECT_TRUE(rig_->button("usePatientButton").isEnabled());
}

TEST_F(FirstScreen, AnArrayThatMovesRestsWhileAnotherPageIsShown)
{
  rig_->click("demonstrationCard");
  ASSERT_TRUE(WindowRig::comes([&] { return rig_->travel_mm() > 0.2; }));
  rig_->click("startPageButton");
  EXPECT_FALSE(rig_->window().control().isMoving());
  ASSERT_TRUE(rig_->liveForTicks(200));
  const double rested = rig_->travel_mm();
  ASSERT_TRUE(rig_->liveForTicks(200));
  EXPECT_NEAR(rig_->travel_mm(), rested, 1e-6);
}

}  // namespace
}  // namespace perilymph::test
