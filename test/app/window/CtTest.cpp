// SPDX-License-Identifier: BSD-3-Clause

// The page CT in the real window: from a DICOM folder to an insertion in that cochlea.

#include <gmock/gmock.h>

#include <QAction>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMenu>
#include <QMouseEvent>
#include <QPushButton>
#include <QTest>
#include <algorithm>
#include <set>

#include "KeptPicture.h"
#include "TheCtPage.h"
#include "Walk.h"
#include "WindowRig.h"
#include "gui/pages/ct/CtPage.h"
#include "gui/pages/ct/MeasuredSetup.h"
#include "gui/pages/ct/PlaneView.h"
#include "gui/pages/ct/SurfaceView.h"
#include "gui/report/CtPicture.h"
#include "gui/run/UserSettings.h"
#include "gui/scene/SceneLabels.h"
#include "gui/setup/EnteredMeasures.h"
#include "gui/setup/MeasureVersions.h"
#include "gui/setup/PatientHistory.h"
#include "gui/setup/PatientLibrary.h"
#include "gui/setup/PatientSetup.h"
#include "gui/setup/ScanFolders.h"
#include "gui/widgets/Theme.h"
#include "perilymph/analysis/ErrorBand.h"
#include "perilymph/anatomy/DuctLength.h"
#include "perilymph/foundation/AtomicFile.h"
#include "perilymph/foundation/Resources.h"
#include "perilymph/foundation/StateFolder.h"
#include "perilymph/test/CtPhantom.h"
#include "perilymph/test/DicomWriter.h"
#include "perilymph/test/TemporaryFolder.h"

namespace perilymph::test {
namespace {

namespace fs = std::filesystem;

TEST_F(TheCtPage, GoesFromAFolderToAnInsertionInThatCochlea)
{
  page().open(onDisk().folder / "ct");
  ASSERT_TRUE(WindowRig::waitUntil([this] { return study().measures() != nullptr; }));
  EXPECT_NEAR(study().measures()->a.value, onDisk().phantom.a, 0.4);
  EXPECT_EQ(rig_.label("ctSide"), onDisk().phantom.isRight ? "Right ear" : "Left ear");
  EXPECT_TRUE(rig_.label("fittedA").contains("±"));
  EXPECT_FALSE(rig_.button("insertCtButton").isEnabled());  // no code yet
  rig_.type("ctPatientCode", "CT-203");
  rig_.click("insertCtButton");
  ASSERT_TRUE(WindowRig::waitUntil(
      [this] { return rig_.window().control().scenario().patient().label == "CT-203"; }));
  EXPECT_EQ(rig_.window().page(), "insert");
  const auto& patient = rig_.window().control().scenario().patient();
  ASSERT_TRUE(patient.basalTurn);
  EXPECT_NEAR(inMillimeters(patient.basalTurn->a), study().measures()->a.value, 5e-4);
  EXPECT_NEAR(inMillimeters(patient.basalTurn->b), study().measures()->b.value, 5e-4);
  EXPECT_EQ(patient.side, study().measures()->side);
  // the errors go with the measures, and the file says who placed which landmark
  ASSERT_TRUE(patient.errors);
  EXPECT_NEAR(inMillimeters(patient.errors->b), study().measures()->b.sd(), 5e-4);
  const char* file = patient.side == anatomy::Side::left ? "CT-203-left.toml" : "CT-203-right.toml";
  const auto saved = anatomy::loadPatient(patientFolder() / file);
  ASSERT_TRUE(saved) << saved.error().message;
  EXPECT_EQ(saved->label, "CT-203");
  EXPECT_EQ(saved->origin.seriesKey, study().measures()->provenance.seriesKey);
  EXPECT_EQ(saved->origin.landmarksByHand, "");
}

/// A patient as measured in a CT, with the landmark RW by hand.
anatomy::Patient patientFromCt()
{
  anatomy::Patient patient;
  patient.label = "P-9";
  patient.basalTurn = anatomy::BasalTurn{millimeters(8.85), millimeters(6.58), millimeters(3.85)};
  patient.errors =
      anatomy::BasalTurnErrors{millimeters(0.13), millimeters(0.09), millimeters(0.245)};
  patient.errors->ab = 0.2;
  patient.errors->bh = 0.3;
  patient.origin = {"perilymph 0.3.0", std::string(64, 'a'), "RW", "OW, B1, B2, H, A, C"};
  return patient;
}

TEST(ATypedMeasure, HasTheAssumedErrorAndTheOthersKeepTheirs)
{
  const auto setup = gui::setupOfPatient(patientFromCt());
  ASSERT_TRUE(setup) << setup.error().message;
  const auto type = [&](const gui::Setup& now, const char* a) {
    const auto typed = gui::changed(
        now, {*setup, gui::SetupOrigin::Kind::own},
        {gui::SetupField::lengthA, {{"patient_numbers.a_mm", a}}, {}, gui::ValueSource::typed});
    EXPECT_TRUE(typed) << typed.error().message;
    return *typed;
  };
  const gui::Setup typed = type(*setup, "9.3");
  const auto& errors = typed.scenario.patient().errors;
  ASSERT_TRUE(errors);
  EXPECT_EQ(errors->a, analysis::measuringError);
  EXPECT_EQ(errors->b, millimeters(0.09));
  EXPECT_EQ(errors->h, millimeters(0.245));
  EXPECT_EQ(typed.sourceOf(gui::SetupField::lengthA), gui::ValueSource::typed);
  EXPECT_EQ(typed.sourceOf(gui::SetupField::heightH), gui::ValueSource::ct);
  // the measure of the CT again has its error
  const gui::Setup back = type(typed, "8.85");
  EXPECT_EQ(back.scenario.patient().errors->a, millimeters(0.13));
  EXPECT_EQ(back.sourceOf(gui::SetupField::lengthA), gui::ValueSource::ct);
}

TEST(ATypedMeasure, IsSavedAsEnteredBesideThoseFromTheCt)
{
  const anatomy::Patient known = patientFromCt();
  anatomy::Patient typed = known;
  typed.errors.reset();
  typed.origin = {};
  typed.basalTurn->a = millimeters(9.3);
  const anatomy::Patient saved = gui::withMeasuresOf(known, typed);
  EXPECT_EQ(gui::enteredMeasures(saved), std::vector<std::string>{"A"});
  EXPECT_EQ(saved.origin.software, "perilymph 0.3.0; entered: A");
  EXPECT_EQ(saved.origin.seriesKey, known.origin.seriesKey);
  EXPECT_EQ(saved.origin.landmarksByHand, "RW");
  EXPECT_EQ(saved.errors->a, analysis::measuringError);
  EXPECT_EQ(saved.errors->h, known.errors->h);
  EXPECT_EQ(saved.errors->ab, 0.0);  // that of an entered A goes with no other
  EXPECT_EQ(saved.errors->bh, 0.3);
  // what was entered once stays entered
  typed.basalTurn->h = millimeters(3.5);
  const anatomy::Patient again = gui::withMeasuresOf(saved, typed);
  EXPECT_EQ(again.origin.software, "perilymph 0.3.0; entered: A, H");
  EXPECT_FALSE(again.errors->h);
  EXPECT_EQ(again.errors->b, known.errors->b);
  // nothing of the CT is left
  typed.basalTurn->b = millimeters(6.9);
  const anatomy::Patient all = gui::withMeasuresOf(again, typed);
  EXPECT_FALSE(all.errors);
  EXPECT_FALSE(anatomy::isFromCt(all));
  // unchanged, all of it is
  EXPECT_EQ(anatomy::patientText(gui::withMeasuresOf(known, known)), anatomy::patientText(known));
}

TEST(ATypedMeasure, BecomesAVersionOfTheEarAfterAComparison)
{
  const DataFolder data;
  const auto file = gui::savePatientInLibrary(patientFromCt());
  ASSERT_TRUE(file) << file.error().message;
  WindowRig rig;
  rig.choose("savedPatients", file->string().c_str());
  ASSERT_TRUE(WindowRig::waitUntil([&] {
    return rig.window().control().scenario().patient().label == "P-9" &&
           rig.button("startButton").isEnabled();
  }));
  const QString errorOfH = rig.label("panelHPlace");
  EXPECT_TRUE(errorOfH.contains("± 0.48")) << errorOfH.toStdString();
  rig.type("panelA", "9.3");
  ASSERT_TRUE(WindowRig::waitUntil([&] { return rig.button("savePatientButton").isVisible(); }));
  EXPECT_EQ(rig.label("panelHPlace"), errorOfH);
  EXPECT_EQ(rig.label("savedPatientStatus"), "Saved: A 8.85, B 6.58, H 3.85 mm");
  rig.click("savePatientButton");
  EXPECT_EQ(anatomy::loadPatient(*file)->basalTurn->a, millimeters(8.85));
  EXPECT_EQ(rig.label("panel-differenceA").section(' ', 0, 0), "+0.45");
  EXPECT_EQ(rig.label("panel-differenceH").section(' ', 0, 0), "0.00");
  ASSERT_TRUE(WindowRig::waitUntil([&] { return rig.button("startButton").isEnabled(); }));
  keepPicture(rig.window(), "typed-measure-compared");
  rig.click("panel-newVersionButton");
  const auto saved = gui::findSavedPatient("P-9", anatomy::Side::right);
  ASSERT_TRUE(saved);
  EXPECT_EQ(saved->patient.basalTurn->a, millimeters(9.3));
  EXPECT_EQ(saved->patient.errors->h, millimeters(0.245));
  EXPECT_EQ(saved->patient.origin.seriesKey, std::string(64, 'a'));
  const auto versions = gui::versionsOf(*saved);
  ASSERT_EQ(versions.size(), 2U);
  EXPECT_EQ(versions[0].how, "by hand: RW; A entered");
  EXPECT_EQ(versions[1].how, "by hand: RW");
  EXPECT_EQ(versions[1].patient.basalTurn->a, millimeters(8.85));
}

TEST(MeasureDifferences, AreThoseOfTheValuesThatAreShown)
{
  const gui::ComparedMeasure before{32.051, 0.5}, after{32.049, 0.5};
  EXPECT_EQ(gui::comparedText(before, 3).section(' ', 0, 0), "32.1");
  EXPECT_EQ(gui::comparedText(after, 3).section(' ', 0, 0), "32.0");
  EXPECT_EQ(gui::differenceOf(before, after, 3).text.section(' ', 0, 0), "-0.1");
}

TEST(MeasuredCochleae, OfBothEarsOfAPatientHaveAFileEach)
{
  const DataFolder data;
  ct::MeasureRequest request;
  request.click_P = onDisk().phantom.inside_P;
  request.marks[ct::Mark::apex] = onDisk().phantom.marks[ct::Mark::apex];
  auto measures = ct::measureCochlea(onDisk().phantom.volume, request);
  ASSERT_TRUE(measures) << measures.error().message;
  for (const anatomy::Side side : {anatomy::Side::left, anatomy::Side::right}) {
    measures->side = side;
    ASSERT_TRUE(gui::setupOfMeasures(*measures, QStringLiteral("P-9"), {}));
  }
  for (const auto& [file, side] : {std::pair{"P-9-left.toml", anatomy::Side::left},
                                   std::pair{"P-9-right.toml", anatomy::Side::right}}) {
    const auto patient = anatomy::loadPatient(patientFolder() / file);
    ASSERT_TRUE(patient) << patient.error().message;
    EXPECT_EQ(patient->label, "P-9");
    EXPECT_EQ(patient->side, side);
    EXPECT_EQ(patient->origin.landmarksByHand, "A");
    EXPECT_THAT(patient->origin.landmarksProposed, testing::StartsWith("RW, OW"));
  }
  EXPECT_EQ(gui::savedPatients().size(), 2U);
}

TEST_F(TheCtPage, GoesToAPlanForThatCochleaWithItsErrors)
{
  measure();
  EXPECT_FALSE(rig_.button("planCtButton").isEnabled());  // no code yet
  rig_.type("ctPatientCode", "CT-204");
  rig_.click("planCtButton");
  EXPECT_EQ(rig_.window().page(), "plan");
  EXPECT_TRUE(rig_.label("planPatient").contains("CT-204"));
  const QString measures = rig_.label("planMeasures");
  const auto a_mm = QString::number(study().measures()->a.value, 'f', 2);
  EXPECT_TRUE(measures.contains("A " + a_mm + " ± ")) << measures.toStdString();
  EXPECT_TRUE(measures.contains("errors as measured")) << measures.toStdString();
  EXPECT_TRUE(rig_.button("computePlanButton").isEnabled());
}

TEST_F(TheCtPage, ShowsTheInsertedArrayInTheScan)
{
  measure();
  rig_.type("ctPatientCode", "CT-203");
  rig_.click("insertCtButton");
  ASSERT_TRUE(WindowRig::waitUntil(
      [this] { return rig_.window().control().scenario().patient().label == "CT-203"; }));
  // the reports of this insertion have the cochlea in its CT, those of other measures have not
  anatomy::Patient patient = rig_.window().control().scenario().patient();
  EXPECT_EQ(gui::ctPictureOf(patient).width(), 1536);
  EXPECT_TRUE(gui::ctPictureText(patient).contains("The cochlea in the CT"));
  patient.basalTurn->a = patient.basalTurn->a + millimeters(0.01);
  EXPECT_TRUE(gui::ctPictureText(patient).isEmpty());
  ASSERT_TRUE(WindowRig::waitUntil([this] { return rig_.button("startButton").isEnabled(); }));
  rig_.click("startButton");
  ASSERT_TRUE(WindowRig::waitUntil([this] { return rig_.travel_mm() > 5.0; }));
  rig_.click("ctPageButton");
  const auto& array = study().array().nodes;
  ASSERT_EQ(array.size(), rig_.now().nodes);
  // its tip lies in the measured lumen: within a lumen's width of the wall, inside the cochlea
  double nearest = 1e9;
  for (const Eigen::Vector3d& wall_P : study().measures()->wall_P)
    nearest = std::min(nearest, (wall_P - array.back().center_P).norm());
  EXPECT_LT(nearest, 1.2);
  EXPECT_LT((array.back().center_P - study().measures()->center_P).norm(), 7.0);
  EXPECT_LT(array.back().radius_mm, array.front().radius_mm);  // tapered
  // contacts lie on it, number 1 nearest to the tip
  const auto& contacts = study().array().contacts_P;
  ASSERT_EQ(contacts.size(), rig_.window().control().scenario().array().contactsFromTip.size());
  EXPECT_LT((contacts.front() - array.back().center_P).norm(), 1.5);
  EXPECT_GT((contacts.back() - array.back().center_P).norm(), 3.0);
}

TEST_F(TheCtPage, LinksItsPlanesByTheCrosshair)
{
  const QPointF aim(0.3 * view(0).width(), 0.6 * view(0).height());
  const Eigen::Vector3d aimed = view(0).pointAt(aim);
  QTest::mouseClick(&view(0), Qt::LeftButton, Qt::NoModifier, aim.toPoint());
  EXPECT_LT((study().crosshair_P() - aimed).norm(), study().pixel_mm());
  for (const auto& plane : study().planes())
    EXPECT_NEAR(plane.behind(study().crosshair_P()), 0.0, 1e-9);
}

TEST_F(TheCtPage, StepsThroughLayersAndZoomsWithKeysAndWheel)
{
  const Eigen::Vector3d before = study().crosshair_P();
  QTest::keyClick(&view(0), Qt::Key_Up);
  EXPECT_NEAR(study().crosshair_P().z() - before.z(), 0.3, 1e-9);
  QTest::keyClick(&view(0), Qt::Key_Down);
  EXPECT_NEAR((study().crosshair_P() - before).norm(), 0.0, 1e-9);
  const double pixel = study().pixel_mm();
  QTest::keyClick(&view(0), Qt::Key_Plus);
  EXPECT_LT(study().pixel_mm(), pixel);
}

TEST_F(TheCtPage, TurnsToTheCochlearViewWhenTheCochleaIsMeasured)
{
  EXPECT_FALSE(rig_.button("cochleaPlanes").isEnabled());
  measure();
  EXPECT_TRUE(rig_.button("cochleaPlanes").isChecked());
  const auto planes = study().planes();
  EXPECT_NEAR(planes[0].away_P().dot(study().measures()->axis_P), -1.0, 1e-9);
  rig_.click("patientPlanes");
  EXPECT_NEAR(study().planes()[0].away_P().z(), 1.0, 1e-9);
}

TEST_F(TheCtPage, MovesALandmarkWithTheMouseAndTakesItBack)
{
  measure();
  const auto before = study().marks()[ct::Mark::roundWindow].value();
  study().moveCrosshair(before);
  const QPointF place = view(0).placeOf(before);
  ASSERT_EQ(view(0).markAt(place), ct::Mark::roundWindow);
  const double a = study().marked().a.value();
  const double moved_mm = 20.0 * study().pixel_mm();
  drag(view(0), place, {0.0, 20.0});  // A is vertical: away from the far wall
  EXPECT_NEAR((study().marks()[ct::Mark::roundWindow].value() - before).norm(), moved_mm,
              1.5 * study().pixel_mm());
  EXPECT_NEAR(study().marked().a.value(), a + moved_mm, 2.0 * study().pixel_mm());
  EXPECT_TRUE(study().isCorrected());
  rig_.click("undoMarkButton");
  EXPECT_EQ(study().marks()[ct::Mark::roundWindow].value(), before);
  EXPECT_FALSE(study().isCorrected());
  rig_.click("redoMarkButton");
  EXPECT_TRUE(study().isCorrected());
}

TEST_F(TheCtPage, PlacesALandmarkByButtonAndClick)
{
  auto* guide = page().findChild<QWidget*>("markGuide");
  EXPECT_FALSE(guide->isVisible());
  rig_.click("markRW");
  EXPECT_TRUE(guide->isVisible());
  // drawn with the point that is asked for: another point is another picture
  auto* drawing = guide->findChild<QWidget*>("landmarkDrawing");
  const QImage ofWindow = drawing->grab().toImage();
  rig_.click("markC");
  EXPECT_NE(drawing->grab().toImage(), ofWindow);
  rig_.click("markRW");
  EXPECT_EQ(drawing->grab().toImage(), ofWindow);
  const QPoint aim = view(0).rect().center() + QPoint(30, -20);
  QTest::mouseClick(&view(0), Qt::LeftButton, Qt::NoModifier, aim);
  ASSERT_TRUE(study().marks()[ct::Mark::roundWindow]);
  EXPECT_LT((study().marks()[ct::Mark::roundWindow].value() - view(0).pointAt(aim)).norm(), 1e-9);
  EXPECT_FALSE(guide->isVisible());
  // the next click moves the crosshair again
  const QPoint elsewhere = view(0).rect().center() + QPoint(-60, 60);
  QTest::mouseClick(&view(0), Qt::LeftButton, Qt::NoModifier, elsewhere);
  EXPECT_LT((study().crosshair_P() - view(0).pointAt(elsewhere)).norm(), 1e-9);
}

TEST_F(TheCtPage, GoesOnFromCorrectedLandmarks)
{
  measure();
  const auto before = *study().measures();
  // the round window 0.6 mm along the wall: 0 degrees turns with it
  const Eigen::Vector3d moved = before.roundWindow_P + 0.6 * before.axes_PW.col(1);
  study().beginChange();
  study().placeMark(ct::Mark::roundWindow, moved);
  EXPECT_EQ(rig_.button("measureHereButton").text(), "Re-measure using landmarks");
  rig_.click("measureHereButton");
  ASSERT_TRUE(WindowRig::waitUntil([this] { return !page().isBusy(); }));
  const auto& after = *study().measures();
  EXPECT_LT((after.roundWindow_P - moved).norm(), (before.roundWindow_P - moved).norm());
}

TEST_F(TheCtPage, ShowsWhatItMeasuredBeforeHereAndOnThePagesThatFollow)
{
  measure();
  const ct::CochleaMeasures before = *study().measures();
  // the fit with the landmark is slow, and another test looks at it
  ct::CochleaMeasures after = before;
  after.a.value += 0.37;
  after.cdlOc->value = inMillimeters(
      anatomy::ellipticCircularDuctLength(millimeters(after.a.value), millimeters(after.b.value)));
  page().setMeasurement([&after](const ct::CtVolume&, const ct::MeasureRequest& request) {
    after.marksByHand = request.marks;
    return Result<ct::CochleaMeasures>(after);
  });
  rig_.type("ctPatientCode", "P-77");
  study().beginChange();
  const Eigen::Vector3d wall = *study().marks()[ct::Mark::farWall];
  const Eigen::Vector3d alongA = (wall - *study().marks()[ct::Mark::roundWindow]).normalized();
  study().placeMark(ct::Mark::farWall, wall + (after.a.value - before.a.value) * alongA);
  rig_.click("planCtButton");
  ASSERT_TRUE(WindowRig::waitUntil([&] { return rig_.window().page() == "plan"; }));
  const QString change =
      QStringLiteral("A %1 → %2 mm").arg(before.a.value, 0, 'f', 2).arg(after.a.value, 0, 'f', 2);
  EXPECT_TRUE(rig_.label("planMeasureChange").contains(change))
      << rig_.label("planMeasureChange").toStdString();
  EXPECT_TRUE(rig_.label("planMeasureChange").contains("automatic"));
  const QString told = rig_.label("planMeasureChange");
  keepPicture(rig_.window(), "remeasured-plan");
  rig_.click("ctPageButton");
  EXPECT_TRUE(rig_.label("ctChange").contains(change)) << rig_.label("ctChange").toStdString();
  keepPicture(rig_.window(), "remeasured-ct");
  // both are versions of the patient
  const auto saved = gui::findSavedPatient("P-77", before.side);
  ASSERT_TRUE(saved);
  const auto versions = gui::versionsOf(*saved);
  ASSERT_EQ(versions.size(), 2u);
  EXPECT_TRUE(versions[0].isUsed);
  EXPECT_TRUE(versions[0].how.startsWith("by hand: ")) << versions[0].how.toStdString();
  EXPECT_EQ(versions[1].how, "automatic");
  EXPECT_NEAR(inMillimeters(versions[1].patient.basalTurn->a), before.a.value, 1e-6);
  rig_.click("insertCtButton");
  ASSERT_TRUE(WindowRig::waitUntil([&] { return rig_.window().page() == "insert"; }));
  ASSERT_TRUE(WindowRig::waitUntil([&] {
    return rig_.window().control().scenario().patient().label == "P-77" &&
           rig_.button("startButton").isEnabled();
  }));
  EXPECT_TRUE(rig_.label("panelMeasureChange").contains(change))
      << rig_.label("panelMeasureChange").toStdString();
  EXPECT_EQ(rig_.label("panelMeasureChange"), told);
  keepPicture(rig_.window(), "remeasured-insert");
}

TEST_F(TheCtPage, OpensTheScanOfAPatientAgainWhereItWasRead)
{
  const StateFolder state;
  measure();
  const ct::CochleaMeasures measures = *study().measures();
  page().setMeasurement([&measures](const ct::CtVolume&, const ct::MeasureRequest&) {
    return Result<ct::CochleaMeasures>(measures);
  });
  rig_.type("ctPatientCode", "P-78");
  rig_.click("planCtButton");
  ASSERT_TRUE(WindowRig::waitUntil([&] { return rig_.window().page() == "plan"; }));
  const auto saved = gui::findSavedPatient("P-78", measures.side);
  ASSERT_TRUE(saved);
  const std::string series = statedSeries(saved->patient);
  EXPECT_EQ(gui::placeOfScan(series), onDisk().folder / "ct");

  // a window without a CT
  WindowRig other;
  auto& again = *other.window().pages().find<gui::CtPage>();
  again.setMeasurement([&measures](const ct::CtVolume&, const ct::MeasureRequest&) {
    return Result<ct::CochleaMeasures>(measures);
  });
  again.begin(gui::CtRequest{"P-78", series});
  EXPECT_EQ(other.window().page(), "ct");
  ASSERT_TRUE(WindowRig::waitUntil([&] { return again.study().measures() != nullptr; }));
  EXPECT_EQ(again.study().series().key, series);
  EXPECT_EQ(other.window().findChild<QLineEdit*>("ctPatientCode")->text(), "P-78");

  // another series is there now
  gui::rememberScan("0123abcd", onDisk().folder / "ct");
  again.begin(gui::CtRequest{"P-79", "0123abcd"});
  ASSERT_TRUE(WindowRig::waitUntil([&] { return other.label("ctStatus").contains("P-79"); }));
  EXPECT_TRUE(other.label("ctStatus").contains("no longer where it was read"));
  // the list is of that folder, so nothing of the former scan stays beside it
  EXPECT_FALSE(again.study().hasCt());
  EXPECT_EQ(other.window().findChild<QLineEdit*>("ctPatientCode")->text(), "");
  // nothing is known of it
  again.begin(gui::CtRequest{"P-80", "4567"});
  EXPECT_TRUE(other.label("ctStatus").contains("P-80"));
}

/// The menu of recent CTs, as it opens.
QMenu& recentMenu(WindowRig& rig)
{
  QMenu* menu = rig.window().findChild<QPushButton*>("recentCtButton")->menu();
  Q_EMIT menu->aboutToShow();
  return *menu;
}

QStringList recentEntries(WindowRig& rig)
{
  QStringList entries;
  for (const QAction* each : recentMenu(rig).actions()) entries << each->text();
  return entries;
}

TEST_F(TheCtPage, OpensRecentCtsAgainByCodeAndDateAloneUntilTheListIsCleared)
{
  const StateFolder state;
  EXPECT_EQ(recentEntries(rig_).size(), 1);
  EXPECT_TRUE(recentEntries(rig_).front().contains("No CT was opened yet"));
  const TemporaryFolder disk;
  const fs::path place = disk / "Doe Jane";  // as people call such folders
  fs::copy(onDisk().folder / "ct", place);
  page().open(place);
  ASSERT_TRUE(WindowRig::waitUntil([&] { return gui::recentScans().size() == 1; }));
  page().cancel();
  const std::string series = study().series().key;
  EXPECT_EQ(gui::recentScans().front().place, place);
  EXPECT_EQ(gui::recentScans().front().series, series);
  EXPECT_TRUE(recentEntries(rig_).front().startsWith("without a code · opened 20"))
      << recentEntries(rig_).front().toStdString();

  // with the code under which its measures were saved
  const ct::CochleaMeasures measures = [this] {
    measure();
    return *study().measures();
  }();
  rig_.type("ctPatientCode", "P-81");
  rig_.click("planCtButton");
  ASSERT_TRUE(WindowRig::waitUntil([&] { return rig_.window().page() == "plan"; }));
  EXPECT_TRUE(recentEntries(rig_).front().startsWith("P-81 · opened 20"));
  EXPECT_FALSE(recentEntries(rig_).join('\n').contains("Jane"));
  const std::string settings = gui::UserSettings().fileName().toStdString();
  if (const auto text = readWhole(settings)) {
    EXPECT_EQ(text->find("Jane"), std::string::npos);
  }
  EXPECT_EQ(fs::status(stateFolder() / "ct-folders").permissions(),
            fs::perms::owner_read | fs::perms::owner_write);

  // one from an archive is removed when the program ends, and is no place to return to
  gui::rememberScan("feed", stateFolder() / "archive" / "x");
  EXPECT_EQ(gui::recentScans().size(), 1u);

  // another window opens it
  {
    WindowRig other;
    auto& again = *other.window().pages().find<gui::CtPage>();
    again.setMeasurement([&measures](const ct::CtVolume&, const ct::MeasureRequest&) {
      return Result<ct::CochleaMeasures>(measures);
    });
    other.click("ctPageButton");
    other.window().resize(1280, 760);
    keepPicture(other.window(), "ct-empty-recent");
    recentMenu(other).actions().front()->trigger();
    ASSERT_TRUE(WindowRig::waitUntil([&] { return again.study().hasCt(); }));
    EXPECT_EQ(again.study().series().key, series);
    EXPECT_EQ(other.window().findChild<QLineEdit*>("ctPatientCode")->text(), "P-81");
    ASSERT_TRUE(WindowRig::waitUntil([&] { return !again.isBusy(); }));
    keepPicture(other.window(), "ct-recent");
  }
  // the folder is gone: a sentence with the code and without the place
  fs::rename(place, disk / "elsewhere");
  WindowRig third;
  third.click("ctPageButton");
  recentMenu(third).actions().front()->trigger();
  EXPECT_TRUE(third.label("ctStatus").contains("P-81 was measured is no longer where it was read"));
  EXPECT_FALSE(third.label("ctStatus").contains("Jane"));

  third.pressKey(Qt::Key_Comma, Qt::ControlModifier);
  third.click("clearScansButton");
  EXPECT_TRUE(third.label("clearScansStatus").contains("no longer known where CTs were opened"));
  keepPicture(third.window(), "settings-recent");
  EXPECT_TRUE(gui::recentScans().empty());
  EXPECT_FALSE(fs::exists(stateFolder() / "ct-folders"));
  EXPECT_TRUE(recentEntries(third).front().contains("No CT was opened yet"));
}

/// Landmarks by hand, their records, and the request that opens their scan again.
gui::CtRequest scanRequestOf(const gui::SavedPatient& saved)
{
  for (const gui::HistoryEntry& each : gui::historyOf(saved, {}))
    if (each.kind == gui::HistoryEntry::Kind::scan) return each.scan;
  ADD_FAILURE() << "no scan";
  return {};
}

TEST_F(TheCtPage, LooksForTheCochleaBeforeLandmarksOfThePatientCorrectIt)
{
  const StateFolder state;
  measure();
  const ct::CochleaMeasures automatic = *study().measures();
  std::vector<ct::MeasureRequest> requests;
  const gui::CtWork::Measurement measurement = [&](const ct::CtVolume&,
                                                   const ct::MeasureRequest& request) {
    requests.push_back(request);
    ct::CochleaMeasures measures = automatic;
    measures.marksByHand = request.marks;
    return Result<ct::CochleaMeasures>(measures);
  };
  page().setMeasurement(measurement);
  study().beginChange();
  const Eigen::Vector3d moved = automatic.roundWindow_P + 0.2 * automatic.axes_PW.col(1);
  study().placeMark(ct::Mark::roundWindow, moved);
  rig_.type("ctPatientCode", "P-81");
  rig_.click("planCtButton");
  ASSERT_TRUE(WindowRig::waitUntil([&] { return rig_.window().page() == "plan"; }));
  ASSERT_EQ(requests.size(), 1U);
  const auto saved = gui::findSavedPatient("P-81", automatic.side);
  ASSERT_TRUE(saved);

  WindowRig other;
  auto& again = *other.window().pages().find<gui::CtPage>();
  again.setMeasurement(measurement);
  again.begin(scanRequestOf(*saved));
  ASSERT_TRUE(WindowRig::waitUntil([&] {
    return !again.isBusy() && requests.size() == 3 && again.study().measures() != nullptr;
  }));
  // one landmark says too little of where the cochlea lies: the search in this patient's ear says it
  EXPECT_FALSE(requests[1].click_P);
  EXPECT_TRUE(requests[1].marks.isEmpty());
  EXPECT_EQ(requests[1].side, automatic.side);
  // then the fit begins where it began when the landmark was placed
  EXPECT_TRUE(requests[2].marks == requests[0].marks);
  EXPECT_EQ(requests[2].click_P, requests[0].click_P);
  EXPECT_FALSE(again.study().isStale());
  EXPECT_EQ(again.study().marks()[ct::Mark::roundWindow], moved);
}

TEST_F(TheCtPage, OpensAScanAgainWithTheMeasuresOfItsLandmarksByHand)
{
  const StateFolder state;
  measure();
  const ct::CochleaMeasures before = *study().measures();
  for (const auto& [mark, by_mm] :
       {std::pair{ct::Mark::roundWindow, 0.25}, std::pair{ct::Mark::farWall, 0.15},
        std::pair{ct::Mark::apex, -0.2}}) {
    study().beginChange();
    study().placeMark(mark, *study().marks()[mark] + by_mm * before.axes_PW.col(1));
  }
  rig_.type("ctPatientCode", "P-82");
  rig_.click("planCtButton");
  ASSERT_TRUE(WindowRig::waitUntil([&] { return !page().isBusy(); }, 3 * WindowRig::patience_ms));
  if (rig_.window().page() == "ct") rig_.click("planCtButton");  // a contradiction was shown first
  ASSERT_EQ(rig_.window().page(), "plan");
  const auto saved = gui::findSavedPatient("P-82", before.side);
  ASSERT_TRUE(saved);
  EXPECT_EQ(saved->patient.origin.landmarksByHand, "RW, OW, A");

  WindowRig other;
  auto& again = *other.window().pages().find<gui::CtPage>();
  again.begin(scanRequestOf(*saved));
  ASSERT_TRUE(WindowRig::waitUntil(
      [&] { return !again.isBusy() && again.study().measures() && !again.study().isStale(); },
      3 * WindowRig::patience_ms));
  const ct::CochleaMeasures& after = *again.study().measures();
  EXPECT_NEAR(after.a.value, inMillimeters(saved->patient.basalTurn->a), 0.011);
  EXPECT_NEAR(after.b.value, inMillimeters(saved->patient.basalTurn->b), 0.011);
  EXPECT_NEAR(after.h.value, inMillimeters(*saved->patient.basalTurn->h), 0.011);
  EXPECT_TRUE(after.marksByHand == study().marksByHand());
}

TEST_F(TheCtPage, EmptiesTheCodeWithTheScanOfAnotherSeries)
{
  rig_.type("ctPatientCode", "P-83");
  open(otherOnDisk());
  EXPECT_EQ(code(), "");
  // typed for this one; it is opened again
  rig_.type("ctPatientCode", "P-84");
  open(otherOnDisk());
  EXPECT_EQ(code(), "P-84");
  open(onDisk().folder / "ct");
  EXPECT_EQ(code(), "");
  // given for the next scan, whichever that is
  page().begin(gui::CtRequest{"P-85"});
  open(otherOnDisk());
  EXPECT_EQ(code(), "P-85");
}

TEST_F(TheCtPage, AsksBeforeACodeGetsAnEarOfAnotherSeriesOrASeriesAnotherCode)
{
  measure();
  const ct::CochleaMeasures first = *study().measures();
  const auto isQuestionShown = [this] {
    return page().findChild<QWidget*>("versionQuestion")->isVisible();
  };
  const auto go = [this](const char* name) {
    rig_.type("ctPatientCode", name);
    rig_.click("planCtButton");
  };
  go("P-86");
  ASSERT_EQ(rig_.window().page(), "plan");
  rig_.click("ctPageButton");
  // the same series under another code
  go("P-87");
  ASSERT_EQ(rig_.window().page(), "ct");
  ASSERT_TRUE(isQuestionShown());
  const QString ear = first.side == anatomy::Side::left ? "left ear" : "right ear";
  EXPECT_EQ(rig_.label("codeDoubts"), "This series is already P-86, " + ear + ".");
  EXPECT_FALSE(gui::findSavedPatient("P-87", first.side));
  keepPicture(rig_.window(), "series-has-another-code");
  rig_.click("newVersionButton");
  ASSERT_EQ(rig_.window().page(), "plan");
  EXPECT_TRUE(gui::findSavedPatient("P-87", first.side));
  rig_.click("ctPageButton");
  rig_.click("planCtButton");
  ASSERT_EQ(rig_.window().page(), "plan");  // answered
  rig_.click("ctPageButton");
  // the other ear in another series
  ct::CochleaMeasures second = first;
  second.side = first.side == anatomy::Side::left ? anatomy::Side::right : anatomy::Side::left;
  second.provenance.seriesKey = std::string(64, 'e');
  study().setMeasures(second);
  go("P-86");
  ASSERT_EQ(rig_.window().page(), "ct");
  ASSERT_TRUE(isQuestionShown());
  const QString doubt = rig_.label("codeDoubts");
  EXPECT_TRUE(doubt.contains("P-86, " + ear + ", was measured in series ")) << doubt.toStdString();
  EXPECT_TRUE(doubt.contains("this is series eeeeeeeeeeee"));
  EXPECT_FALSE(gui::findSavedPatient("P-86", second.side));
  keepPicture(rig_.window(), "code-has-another-series");
  rig_.click("otherCodeButton");
  EXPECT_FALSE(gui::findSavedPatient("P-86", second.side));
}

TEST_F(TheCtPage, ShowsNothingOfTheFormerScanBesideAnotherOne)
{
  measure();
  auto* surface = page().findChild<gui::SurfaceView*>("surfaceView");
  const auto colors = [surface] {
    const QImage picture = surface->picture();
    std::set<QRgb> seen;
    for (int y = 0; y < picture.height(); y += 3)
      for (int x = 0; x < picture.width(); x += 3) seen.insert(picture.pixel(x, y));
    return seen.size();
  };
  ASSERT_GT(colors(), 20U);
  ASSERT_TRUE(WindowRig::waitUntil([&] { return !page().bone().isBusy(); }));
  ASSERT_FALSE(surface->labels().labels().empty());
  const auto former = page().bone().model();
  open(otherOnDisk());
  ASSERT_TRUE(study().hasCt());
  EXPECT_TRUE(study().marks().isEmpty());
  EXPECT_TRUE(surface->labels().labels().empty());
  EXPECT_NE(surface->scene()->bone().bone(), former);
  ASSERT_TRUE(WindowRig::waitUntil([&] { return page().bone().model() != nullptr; }));
  EXPECT_GT(colors(), 20U);  // the other one's bone
  keepPicture(rig_.window(), "another-scan-unmeasured");
}

TEST_F(TheCtPage, ShowsNoScanBesideTheListOfAFolderThatCannotBeRead)
{
  measure();
  rig_.type("ctPatientCode", "P-88");
  Eigen::Matrix4d lps = Eigen::Matrix4d::Identity();
  lps.topLeftCorner<3, 3>() *= 0.3;
  const auto volume = ct::CtVolume::make({4, 4, 2}, lps, std::vector<std::int16_t>(32, 7), {});
  auto slices = dicomSlices(*volume, "1.2.3.10");
  for (DicomData& slice : slices) slice.remove(0x7FE00010);  // the pixels
  const TemporaryFolder bad;
  writeDicomFiles(slices, bad / "ct");
  page().open(bad / "ct");
  ASSERT_TRUE(WindowRig::waitUntil([this] { return !page().isBusy(); }));
  EXPECT_FALSE(rig_.label("ctStatus").isEmpty());
  EXPECT_FALSE(study().hasCt());
  EXPECT_EQ(code(), "");
  EXPECT_FALSE(rig_.button("measureCtButton").isEnabled());
  EXPECT_FALSE(rig_.button("planCtButton").isEnabled());
  EXPECT_FALSE(rig_.button("markRW").isEnabled());
  // back in the former folder, the code is that of its patient
  open(onDisk().folder / "ct");
  EXPECT_EQ(code(), "P-88");
}

TEST_F(TheCtPage, WarnsOfAFolderWithImagesOfTwoPatients)
{
  auto slices = dicomSlices(onDisk().phantom.volume, "1.2.3.11");
  auto others = dicomSlices(onDisk().phantom.volume, "1.2.3.12");
  for (DicomData& slice : others) slice.setText(0x00100020, "LO", "OTHERID");
  others.resize(8);
  const TemporaryFolder both;
  writeDicomFiles(slices, both / "ct" / "one");
  writeDicomFiles(others, both / "ct" / "other");
  open(both / "ct");
  const auto* status = page().findChild<QLabel*>("ctStatus");
  EXPECT_TRUE(status->text().contains("images of 2 patients")) << status->text().toStdString();
  EXPECT_TRUE(status->styleSheet().contains(gui::shownTheme().warning.name()));
}

TEST_F(TheCtPage, LetsEveryCorrectedLandmarkSteerTheFitAndKeepsItInItsPlace)
{
  measure();
  EXPECT_FALSE(study().isCorrected());
  const ct::Marks& truth = onDisk().phantom.marks;
  for (const ct::Mark mark : {ct::Mark::apex, ct::Mark::farB}) {
    study().beginChange();
    study().placeMark(mark, *truth[mark]);
  }
  rig_.click("measureHereButton");
  ASSERT_TRUE(WindowRig::waitUntil([this] { return !page().isBusy(); }));
  const ct::Marks& used = study().measures()->marksByHand;
  EXPECT_EQ(used[ct::Mark::apex], truth[ct::Mark::apex]);
  EXPECT_EQ(used[ct::Mark::farB], truth[ct::Mark::farB]);
  EXPECT_FALSE(used[ct::Mark::roundWindow]);
  // the surgeon's landmarks stay, the others are proposed again
  EXPECT_EQ(study().marks()[ct::Mark::apex], truth[ct::Mark::apex]);
  EXPECT_TRUE(study().marksByHand() == used);
  EXPECT_EQ(study().marks()[ct::Mark::roundWindow], study().measures()->roundWindow_P);
  // before the measurement, by undo: still both by hand; before that, one and none
  rig_.click("undoMarkButton");
  EXPECT_TRUE(study().marksByHand() == used);
  rig_.click("undoMarkButton");
  rig_.click("undoMarkButton");
  EXPECT_FALSE(study().isCorrected());
}

TEST_F(TheCtPage, MeasuresACtThatIsOpenedAndSaysHowLongItTakes)
{
  measure();
  const ct::CochleaMeasures measures = *study().measures();
  std::promise<void> hasMeasured;
  page().setMeasurement([&, waited = hasMeasured.get_future().share()](
                            const ct::CtVolume&, const ct::MeasureRequest& request) {
    EXPECT_FALSE(request.click_P);
    request.onProgress(0.5);
    waited.wait();
    return Result<ct::CochleaMeasures>(measures);
  });
  page().open(onDisk().folder / "ct");
  ASSERT_TRUE(WindowRig::waitUntil([&] { return rig_.label("ctStatus").startsWith("Looking"); }));
  EXPECT_FALSE(study().measures());
  EXPECT_TRUE(WindowRig::waitUntil([&] { return rig_.label("ctStatus").endsWith(" s left"); }));
  hasMeasured.set_value();
  EXPECT_TRUE(WindowRig::waitUntil([&] { return study().measures() != nullptr; }));
  // what the reader remarked is shown again
  EXPECT_TRUE(rig_.label("ctStatus").startsWith("Small field of view"));
}

TEST_F(TheCtPage, CancelsAMeasurement)
{
  rig_.click("measureCtButton");
  EXPECT_TRUE(page().isBusy());
  rig_.click("cancelCtButton");
  EXPECT_FALSE(page().isBusy());
  EXPECT_FALSE(study().measures());
  EXPECT_TRUE(rig_.button("measureCtButton").isEnabled());
  // what the reader remarked stays
  EXPECT_TRUE(rig_.label("ctStatus").startsWith("Small field of view"));
}

TEST_F(TheCtPage, SaysWhyAFolderCannotBeRead)
{
  const TemporaryFolder empty;
  page().open(empty.path());
  ASSERT_TRUE(WindowRig::waitUntil([this] { return !page().isBusy(); }));
  // nothing was listed: list and scan are of the folder before
  EXPECT_TRUE(rig_.label("ctStatus").endsWith("The CT shown is the one that was open before."));
  EXPECT_TRUE(study().hasCt());
}

TEST_F(TheCtPage, ShowsAPictureOfEachSeries)
{
  auto* list = rig_.window().findChild<QListWidget*>("ctSeriesList");
  ASSERT_EQ(list->count(), 1);
  EXPECT_TRUE(WindowRig::waitUntil([&] { return !list->item(0)->icon().isNull(); }));
}

TEST_F(TheCtPage, NeverShowsThePatientsName)
{
  for (const QLabel* label : page().findChildren<QLabel*>())
    EXPECT_THAT(label->text().toStdString(), testing::Not(testing::HasSubstr("Secretname")));
}

TEST(AWalkThroughACt, OfASurgeonEndsWithTheArrayInTheScan)
{
  const DataFolder data;
  Walk walk("ct");
  WindowRig rig;
  rig.click("ctPageButton");
  gui::CtPage& page = *rig.window().pages().find<gui::CtPage>();
  page.open(onDisk().folder / "ct");
  ASSERT_TRUE(WindowRig::waitUntil([&] { return page.study().hasCt(); }));
  page.cancel();
  page.study().moveCrosshair(onDisk().phantom.inside_P);
  ASSERT_TRUE(WindowRig::waitUntil([&] { return !page.bone().isBusy(); }));
  walk.step(1, rig.window());

  rig.click("measureHereButton");
  ASSERT_TRUE(WindowRig::waitUntil([&] { return page.study().measures() != nullptr; }));
  ASSERT_TRUE(WindowRig::waitUntil([&] { return !page.bone().isBusy(); }));
  walk.step(2, rig.window());

  auto* view = rig.window().findChild<gui::PlaneView*>("planeView0");
  const auto window_P = page.study().marks()[ct::Mark::roundWindow].value();
  page.study().moveCrosshair(window_P);
  const QPoint from = view->placeOf(window_P).toPoint();
  QTest::mousePress(view, Qt::LeftButton, Qt::NoModifier, from);
  QMouseEvent move(QEvent::MouseMove, from + QPointF(14, 6), Qt::NoButton, Qt::LeftButton,
                   Qt::NoModifier);
  QCoreApplication::sendEvent(view, &move);
  walk.step(3, rig.window());
  QTest::mouseRelease(view, Qt::LeftButton, Qt::NoModifier, from + QPoint(14, 6));

  gui::CtStudy& study = page.study();
  study.turnApproach(anatomy::BasalTurnAngles{degrees(3), degrees(2)});
  study.endChange();
  const ct::ApproachLine line = *study.approachLine();
  const Eigen::Vector3d aside_P = line.outward_P.unitOrthogonal();
  for (const double along : {-3.0, 0.0, 3.0})
    study.addPoint(ct::MarkupKind::facialNerve,
                   line.at(4.0) + 3.0 * aside_P + along * line.outward_P.cross(aside_P));
  ASSERT_EQ(study.pointsOf(ct::MarkupKind::facialNerve).size(), 3u);
  walk.step(4, rig.window());

  rig.type("ctPatientCode", "CT-203");
  rig.click("insertCtButton");
  ASSERT_TRUE(WindowRig::waitUntil(
      [&] { return rig.window().control().scenario().patient().label == "CT-203"; }));
  ASSERT_TRUE(WindowRig::waitUntil([&] { return rig.button("startButton").isEnabled(); }));
  ASSERT_TRUE(WindowRig::waitUntil([&] {
    const auto labels = rig.window().findChildren<QLabel*>();
    return std::none_of(labels.begin(), labels.end(), [](const QLabel* label) {
      return label->isVisible() && label->text() == "computing…";
    });
  }));
  walk.step(5, rig.window());

  rig.click("startButton");
  ASSERT_TRUE(WindowRig::waitUntil([&] { return rig.travel_mm() > 14.0; }));
  rig.click("ctPageButton");
  page.study().moveCrosshair(ct::basalTurnCenter_P(*page.study().measures()) -
                             0.3 * page.study().measures()->axis_P);
  walk.step(6, rig.window());

  const Eigen::Vector3d at = study.crosshair_P(), right = study.planes()[0].right_P,
                        down = study.planes()[0].down_P;
  ASSERT_TRUE(study.addMarkups({{ct::MarkupKind::distance, {at - 5 * right, at + 4 * right}},
                                {ct::MarkupKind::angle, {at - 4 * down, at, at + 3 * right + down}},
                                {ct::MarkupKind::note, {at + 4 * down}, "high jugular bulb"}}));
  walk.step(7, rig.window());
  EXPECT_EQ(walk.left(), "");
}

}  // namespace
}  // namespace perilymph::test
