// SPDX-License-Identifier: BSD-3-Clause

// The first screen: the way to an insertion for a surgeon with a patient's measures, a clinician
// and a visitor.

#include <gtest/gtest.h>

#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QTest>
#include <tuple>

#include "CutTexts.h"
#include "KeptPicture.h"
#include "OwnFolders.h"
#include "WindowRig.h"
#include "gui/pages/start/PatientForm.h"
#include "perilymph/foundation/Resources.h"

namespace perilymph::test {
namespace {

/// A window with its first screen that writes to a temporary folder.
class FirstScreen : public testing::Test {
protected:
  FirstScreen()
  {
    rig_ = std::make_unique<WindowRig>();
    rig_->window().showPage("start");
  }

  void type(const char* field, const char* text)
  {
    auto* line = rig_->window().findChild<QLineEdit*>(QLatin1String(field));
    ASSERT_NE(line, nullptr) << field;
    line->clear();
    QTest::keyClicks(line, QLatin1String(text));
  }

  /// A measure that the form computes.
  QString measure(const char* name)
  {
    const auto* form = rig_->window().findChild<gui::PatientForm*>();
    return form->findChild<QLabel*>(QLatin1String(name))->text();
  }

  /// A visible label says this.
  bool isSaid(const char* text, bool isMarked = false)
  {
    for (const QLabel* label : rig_->window().findChildren<QLabel*>())
      if (label->isVisible() && label->text().contains(QString::fromUtf8(text)) &&
          (!isMarked || label->property("error").toBool()))
        return true;
    return false;
  }
  /// The same in the color of warnings.
  bool isMarked(const char* text) { return isSaid(text, true); }

  const session::Scenario& scenario() { return rig_->window().control().scenario(); }

  DataFolder data_;
  std::unique_ptr<WindowRig> rig_;
};

TEST_F(FirstScreen, OneClickShowsAMovingArray)
{
  rig_->click("demonstrationCard");
  EXPECT_EQ(rig_->window().page(), "insert");
  EXPECT_TRUE(WindowRig::waitUntil([&] { return rig_->travel_mm() > 0.2; }));
}

TEST_F(FirstScreen, TheMeanCochleaIsOneClickAway)
{
  rig_->click("meanCard");
  EXPECT_TRUE(
      WindowRig::waitUntil([&] { return scenario().anatomy() == anatomy::AnatomySource::mean; }));
  EXPECT_EQ(rig_->travel_mm(), 0.0);
  EXPECT_TRUE(rig_->button("startButton").isEnabled());
}

TEST_F(FirstScreen, APatientsThreeLengthsMakeThePatientsCochlea)
{
  rig_->click("patientCard");
  rig_->click("byLengths");
  type("patientName", "P-014");
  type("stLength", "34.2");
  type("rwWidth", "2.05");
  type("rwHeight", "1.7");
  rig_->click("leftEar");
  rig_->click("usePatientButton");
  ASSERT_TRUE(WindowRig::waitUntil([&] { return scenario().patient().label == "P-014"; }));
  EXPECT_EQ(scenario().anatomy(), anatomy::AnatomySource::published);
  EXPECT_EQ(scenario().patient().side, anatomy::Side::left);
  EXPECT_EQ(scenario().patient().scalaTympaniLength, millimeters(34.2));
  EXPECT_EQ(scenario().patient().roundWindowWidth, millimeters(2.05));
  EXPECT_EQ(scenario().patient().roundWindowHeight, millimeters(1.7));
  EXPECT_TRUE(rig_->label("patientLabel").contains("P-014"));
  EXPECT_TRUE(rig_->label("patientLabel").contains("left"));
  // the measures are saved
  EXPECT_TRUE(anatomy::loadPatient(patientFolder() / "P-014-left.toml"));
}

TEST_F(FirstScreen, TheFormShowsItsComputedMeasuresAndTheirNoteWhole)
{
  rig_->click("patientCard");
  type("patientName", "P-014");
  type("aValue", "9.0");
  type("bValue", "6.6");
  ASSERT_TRUE(WindowRig::waitUntil([&] { return isSaid("± 95 % interval of an error of"); }));
  for (const QSize& size : {QSize(1280, 800), QSize(1366, 768)}) {
    rig_->window().resize(size);
    WindowRig::waitUntil([&] { return cutTextsOf(rig_->window()).empty(); });
    EXPECT_EQ(cutTextsOf(rig_->window()), std::vector<std::string>{}) << size.width();
    keepPicture(rig_->window(), "form-" + std::to_string(size.width()));
  }
}

TEST_F(FirstScreen, AAndBMakeAMeanCochleaOfThatSize)
{
  rig_->click("patientCard");
  type("patientName", "P-015");
  type("aValue", "9.0");
  type("bValue", "6.5");
  rig_->click("usePatientButton");
  ASSERT_TRUE(WindowRig::waitUntil([&] { return scenario().patient().basalTurn.has_value(); }));
  EXPECT_EQ(scenario().anatomy(), anatomy::AnatomySource::mean);
  EXPECT_EQ(scenario().patient().basalTurn->a, millimeters(9.0));
  EXPECT_EQ(scenario().patient().basalTurn->b, millimeters(6.5));
  EXPECT_FALSE(scenario().patient().basalTurn->h);
}

TEST_F(FirstScreen, TheFormIsFilledWithTheKeyboardInItsOrder)
{
  rig_->click("patientCard");
  const auto focused = [&] { return rig_->window().focusWidget(); };
  const auto typeHere = [&](const char* text) { QTest::keyClicks(focused(), QLatin1String(text)); };
  const auto tab = [&] { QTest::keyClick(focused(), Qt::Key_Tab); };
  ASSERT_TRUE(WindowRig::waitUntil(
      [&] { return focused() != nullptr && focused()->objectName() == "patientName"; }));
  typeHere("P-016");
  for (const auto& [name, text] : {std::pair{"rightEar", ""}, std::pair{"aValue", "9.1"},
                                   std::pair{"bValue", "6.7"}, std::pair{"hValue", "3.9"}}) {
    tab();
    ASSERT_EQ(focused()->objectName(), name);
    typeHere(text);
  }
  tab();
  EXPECT_EQ(focused()->objectName(), "byBasalTurn");
  tab();
  EXPECT_EQ(focused()->objectName(), "usePatientButton");
  QTest::keyClick(focused(), Qt::Key_Tab, Qt::ShiftModifier);
  QTest::keyClick(focused(), Qt::Key_Tab, Qt::ShiftModifier);
  ASSERT_EQ(focused()->objectName(), "hValue");
  QTest::keyClick(focused(), Qt::Key_Return);
  ASSERT_TRUE(WindowRig::waitUntil([&] { return scenario().patient().label == "P-016"; }));
  EXPECT_EQ(*scenario().patient().basalTurn->h, millimeters(3.9));
}

TEST_F(FirstScreen, AnUntouchedFormCannotBeSentOff)
{
  rig_->click("patientCard");
  for (const char* field : {"aValue", "bValue", "hValue", "stLength", "rwWidth", "rwHeight"}) {
    const auto* line = rig_->window().findChild<QLineEdit*>(QLatin1String(field));
    EXPECT_TRUE(line->text().isEmpty()) << field;
    EXPECT_FALSE(line->placeholderText().isEmpty()) << field;
  }
  EXPECT_FALSE(rig_->button("usePatientButton").isEnabled());
  type("aValue", "9.1");
  type("bValue", "6.7");
  EXPECT_FALSE(rig_->button("usePatientButton").isEnabled());  // for whom?
  type("patientName", "P-016");
  EXPECT_TRUE(rig_->button("usePatientButton").isEnabled());
}

TEST_F(FirstScreen, ANameInPlaceOfACodeIsRefusedInASentence)
{
  rig_->click("patientCard");
  type("aValue", "9.1");
  type("bValue", "6.7");
  rig_->window().findChild<QLineEdit*>("patientName")->setText(QString::fromUtf8("Müller"));
  EXPECT_FALSE(rig_->button("usePatientButton").isEnabled());
  EXPECT_TRUE(isMarked("letters A to Z, digits and hyphens"));
}

TEST_F(FirstScreen, UnusualMeasuresAreMarkedAndStillPossible)
{
  rig_->click("patientCard");
  type("patientName", "P-016");
  type("aValue", "10.4");  // (10.4 - 9.23) / 0.43 = 2.7 standard deviations
  type("bValue", "7.4");
  EXPECT_TRUE(isMarked("2.7 SD above population mean (9.23 mm, SD 0.43): check the measurement"));
  EXPECT_TRUE(rig_->button("usePatientButton").isEnabled());
  type("aValue", "9.9");  // each within two standard deviations, but not together
  type("bValue", "6.3");
  EXPECT_FALSE(isMarked("check the measurement"));
  EXPECT_TRUE(isMarked("A and B do not match"));
  EXPECT_TRUE(rig_->button("usePatientButton").isEnabled());
  type("aValue", "7.2");
  EXPECT_TRUE(isMarked("malformed"));
  EXPECT_FALSE(rig_->button("usePatientButton").isEnabled());
}

TEST_F(FirstScreen, TheDrawingOfTheLandmarksShowsTheirNamesWhole)
{
  rig_->click("patientCard");
  auto* drawing = rig_->window().findChild<QWidget*>("landmarkDrawing");
  for (const char* ear : {"leftEar", "rightEar"}) {
    rig_->click(ear);
    const QImage picture = drawing->grab().toImage();
    const QColor ground = picture.pixelColor(4, picture.height() / 2);
    for (int y = 8; y < picture.height() - 8; ++y)
      for (const int x : {2, 4, 6, picture.width() - 7, picture.width() - 5, picture.width() - 3})
        ASSERT_EQ(picture.pixelColor(x, y), ground) << ear << ", at " << x << ", " << y;
  }
}

TEST_F(FirstScreen, TheFormShowsWhatTheMeasuresMean)
{
  rig_->click("patientCard");
  type("patientName", "P-016");
  type("aValue", "9.20");
  type("bValue", "6.80");
  // by hand: elliptic-circular, with the errors of A and B (SD 0.1 mm) and the 0.9 mm to 4.16 A - 4
  ASSERT_TRUE(WindowRig::waitUntil([&] { return measure("duct_length_mm").contains("±"); }));
  EXPECT_EQ(measure("duct_length_mm"), "33.4 ± 1.2 mm");
  EXPECT_TRUE(measure("angular_insertion_depth_deg").endsWith("°"));
  EXPECT_TRUE(measure("coverage_percent").endsWith(" %"));
  type("aValue", "9.80");
  EXPECT_EQ(measure("duct_length_mm"), "–") << "until the other cochlea's is computed";
  ASSERT_TRUE(WindowRig::waitUntil([&] { return measure("duct_length_mm").contains("±"); }));
  type("aValue", "");
  EXPECT_FALSE(measure("duct_length_mm").contains("33.4"));
}

TEST_F(FirstScreen, TheCodeThatWasTypedIsKeptOnTheWayToTheCt)
{
  rig_->click("patientCard");
  type("patientName", "P-016");
  rig_->click("patientCtButton");
  EXPECT_EQ(rig_->window().page(), "ct");
  EXPECT_EQ(rig_->window().findChild<QLineEdit*>("ctPatientCode")->text(), "P-016");
  // another patient's form without a code leaves it
  rig_->window().showPage("start");
  rig_->click("patientCard");
  rig_->click("patientCtButton");
  EXPECT_EQ(rig_->window().findChild<QLineEdit*>("ctPatientCode")->text(), "P-016");
}

TEST_F(FirstScreen, APatientIsEditedFoundAndReopenedWithMouseAndKeyboard)
{
  for (const auto& [code, a, b] :
       {std::tuple{"P-017", "9.1", "6.7"}, std::tuple{"K-2", "9.4", "6.9"}}) {
    rig_->window().showPage("start");
    rig_->click("patientCard");
    type("patientName", code);
    type("aValue", a);
    type("bValue", b);
    rig_->click("usePatientButton");
    ASSERT_TRUE(WindowRig::waitUntil([&] { return scenario().patient().label == code; })) << code;
  }
  // the program is closed and opened again
  rig_.reset();
  rig_ = std::make_unique<WindowRig>();
  rig_->window().showPage("start");
  EXPECT_TRUE(rig_->button("recentPatient0").text().contains("K-2"));  // the last one first
  rig_->click("recentPatient1");
  ASSERT_TRUE(WindowRig::waitUntil([&] { return scenario().patient().label == "P-017"; }));

  // found by typing, and edited
  rig_->click("startPageButton");
  rig_->click("allPatientsButton");
  QTest::keyClicks(rig_->window().focusWidget(), "k-2");
  auto* list = rig_->window().findChild<QListWidget*>("patientList");
  ASSERT_EQ(list->count(), 1);
  rig_->click("editPatientButton");
  EXPECT_EQ(rig_->window().findChild<QLineEdit*>("patientName")->text(), "K-2");
  type("aValue", "9.5");
  EXPECT_EQ(rig_->button("usePatientButton").text(), "Save changes");
  rig_->click("usePatientButton");
  ASSERT_TRUE(WindowRig::waitUntil([&] { return scenario().patient().label == "K-2"; }));
  EXPECT_EQ(scenario().patient().basalTurn->a, millimeters(9.5));
  EXPECT_EQ(anatomy::loadPatient(patientFolder() / "K-2-right.toml")->basalTurn->a,
            millimeters(9.5));

  // opened from the panel; a change there is saved when asked for
  const std::string other = (patientFolder() / "P-017-right.toml").string();
  rig_->choose("savedPatients", other.c_str());
  ASSERT_TRUE(WindowRig::waitUntil([&] { return scenario().patient().label == "P-017"; }));
  EXPECT_FALSE(rig_->button("savePatientButton").isVisible());
  rig_->type("panelA", "9.2");
  ASSERT_TRUE(WindowRig::waitUntil([&] { return rig_->button("savePatientButton").isVisible(); }));
  EXPECT_EQ(anatomy::loadPatient(other)->basalTurn->a, millimeters(9.1));
  rig_->click("savePatientButton");
  EXPECT_EQ(anatomy::loadPatient(other)->basalTurn->a,
            millimeters(9.1));  // both are compared first
  EXPECT_EQ(rig_->label("panel-differenceA").section(' ', 0, 0), "+0.10");
  rig_->click("panel-newVersionButton");
  EXPECT_EQ(anatomy::loadPatient(other)->basalTurn->a, millimeters(9.2));
  EXPECT_FALSE(rig_->button("savePatientButton").isVisible());
}

TEST_F(FirstScreen, ACodeIsNotGivenToTwoPatients)
{
  for (int i = 0; i < 2; ++i) {
    rig_->window().showPage("start");
    rig_->click("patientCard");
    type("patientName", "P-018");
    type("aValue", i == 0 ? "9.1" : "9.6");
    type("bValue", "6.8");
    rig_->click("usePatientButton");
    if (i > 0) continue;
    ASSERT_TRUE(WindowRig::waitUntil([&] { return scenario().patient().label == "P-018"; }));
  }
  EXPECT_TRUE(isMarked("saved already"));
  EXPECT_EQ(anatomy::loadPatient(patientFolder() / "P-018-right.toml")->basalTurn->a,
            millimeters(9.1));
  rig_->click("leftEar");  // the other ear is another cochlea
  rig_->click("usePatientButton");
  EXPECT_TRUE(
      WindowRig::waitUntil([&] { return scenario().patient().side == anatomy::Side::left; }));
}

TEST_F(FirstScreen, ItsKeysWorkWhereverTheFocusIs)
{
  rig_->window().activateWindow();
  ASSERT_TRUE(WindowRig::waitUntil([&] { return rig_->window().isActiveWindow(); }));
  rig_->button("keysButton").setFocus();
  QTest::keyClick(&rig_->button("keysButton"), Qt::Key_2);
  EXPECT_TRUE(WindowRig::waitUntil([&] { return rig_->window().page() == "insert"; }));
  EXPECT_TRUE(
      WindowRig::waitUntil([&] { return scenario().anatomy() == anatomy::AnatomySource::mean; }));
}

TEST_F(FirstScreen, WorkIsContinuedAndTheLastInsertionReplayed)
{
  EXPECT_EQ(rig_->window().findChild<QAbstractButton*>("continueButton"), nullptr);
  rig_->click("demonstrationCard");
  ASSERT_TRUE(WindowRig::waitUntil([&] { return rig_->travel_mm() > 0.5; }));
  rig_->click("resetButton");
  rig_->choose("arraySelector", "flex24");
  ASSERT_TRUE(WindowRig::waitUntil([&] { return scenario().arrayName() == "flex24"; }));
  rig_->click("startPageButton");
  rig_->click("continueButton");
  EXPECT_EQ(rig_->window().page(), "insert");
  EXPECT_EQ(scenario().arrayName(), "flex24");
  rig_->click("startPageButton");
  ASSERT_TRUE(WindowRig::waitUntil(
      [&] { return rig_->window().findChild<QAbstractButton*>("recentRecording0") != nullptr; }));
  rig_->click("recentRecording0");
  EXPECT_TRUE(WindowRig::waitUntil(
      [&] { return rig_->window().windowTitle().startsWith("Replay of contour-published"); }));
  EXPECT_EQ(rig_->window().windowTitle().count("Perilymph"), 1);
}

TEST_F(FirstScreen, ASurgeonInsertsAnotherArrayIntoThePatientsCochleaAndTakesItBack)
{
  rig_->click("patientCard");
  rig_->click("byLengths");
  type("patientName", "P-014");
  type("stLength", "34.2");
  type("rwWidth", "2.05");
  type("rwHeight", "1.7");
  rig_->click("usePatientButton");
  ASSERT_TRUE(WindowRig::waitUntil([&] { return scenario().patient().label == "P-014"; }));
  // entered in the form, and no preset
  int entered = 0;
  for (const QLabel* label : rig_->window().findChildren<QLabel*>())
    entered += label->isVisible() && label->text() == "entered" ? 1 : 0;
  EXPECT_EQ(entered, 3);
  rig_->choose("arraySelector", "slim-straight");
  rig_->type("panelSpeed", "8");
  EXPECT_FALSE(rig_->window().findChild<QLabel*>("modifiedLabel")->isVisible());
  EXPECT_TRUE(rig_->label("scenarioTitle").contains("P-014: Nucleus Slim Straight"));

  ASSERT_TRUE(WindowRig::waitUntil([&] { return rig_->button("startButton").isEnabled(); }));
  rig_->click("startButton");
  ASSERT_TRUE(WindowRig::waitUntil([&] { return rig_->now().output.axialForce > 2e-3; }));
  EXPECT_TRUE(
      WindowRig::waitUntil([&] { return rig_->readOut("forceReadOut").toDouble() >= 2.0; }));
  rig_->click("resetButton");
  rig_->pressKey(Qt::Key_Z, Qt::ControlModifier);
  rig_->pressKey(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_TRUE(WindowRig::waitUntil([&] { return scenario().arrayName() == "contour"; }));
  EXPECT_EQ(scenario().patient().scalaTympaniLength, millimeters(34.2));
  EXPECT_TRUE(rig_->label("scenarioTitle").contains("P-014: Nucleus 24 Contour"));
}

TEST_F(FirstScreen, AnImpossibleNumberIsRefusedWithTheAllowedRange)
{
  rig_->click("patientCard");
  rig_->click("byLengths");
  type("patientName", "P-014");
  type("rwWidth", "2.05");
  type("rwHeight", "1.7");
  for (const char* error : {"12", "99", "a", "3,4,5", "nan", "-34"}) {
    type("stLength", error);
    EXPECT_FALSE(rig_->button("usePatientButton").isEnabled()) << error;
    EXPECT_TRUE(isMarked("from 25.0 to 45.0 mm")) << error;
  }
  type("stLength", "");
  EXPECT_FALSE(rig_->button("usePatientButton").isEnabled());
  EXPECT_TRUE(isSaid("from 25.0 to 45.0 mm"));
  EXPECT_FALSE(isMarked("from 25.0 to 45.0 mm"));  // nothing wrong was typed
  type("stLength", "34");
  EXPECT_TRUE(rig_->button("usePatientButton").isEnabled());
}

TEST_F(FirstScreen, AnArrayThatMovesRestsWhileAnotherPageIsShown)
{
  rig_->click("demonstrationCard");
  ASSERT_TRUE(WindowRig::waitUntil([&] { return rig_->travel_mm() > 0.2; }));
  rig_->click("startPageButton");
  EXPECT_FALSE(rig_->window().control().isMoving());
  ASSERT_TRUE(rig_->runForTicks(200));
  const double rested = rig_->travel_mm();
  ASSERT_TRUE(rig_->runForTicks(200));
  EXPECT_NEAR(rig_->travel_mm(), rested, 1e-6);
}

}  // namespace
}  // namespace perilymph::test
