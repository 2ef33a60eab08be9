// SPDX-License-Identifier: BSD-3-Clause

// The page Outcome, with a phantom as the CT after surgery and an array that a test places in it.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QDialog>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMouseEvent>
#include <QProgressBar>
#include <QSignalSpy>
#include <QTableWidget>
#include <QTest>
#include <QThread>
#include <cmath>
#include <fstream>
#include <functional>
#include <nlohmann/json.hpp>

#include "CutTexts.h"
#include "KeptPicture.h"
#include "OwnFolders.h"
#include "PlanReportRig.h"
#include "TheCtPage.h"
#include "WindowRig.h"
#include "gui/pages/ct/PlaneView.h"
#include "gui/pages/outcome/OutcomePage.h"
#include "gui/pages/outcome/OutcomePanel.h"
#include "gui/pages/outcomes/OutcomesPage.h"
#include "gui/pages/plan/PlanPage.h"
#include "gui/program/Languages.h"
#include "gui/setup/OutcomeWords.h"
#include "gui/setup/PatientLibrary.h"
#include "gui/setup/PatientSetup.h"
#include "gui/setup/PlanStore.h"
#include "gui/setup/ScanFolders.h"
#include "gui/shell/OverlayStack.h"
#include "gui/widgets/Notice.h"
#include "gui/widgets/Selector.h"
#include "perilymph/foundation/Resources.h"
#include "perilymph/foundation/StateFolder.h"
#include "perilymph/imaging/CtSeries.h"
#include "perilymph/imaging/MeasuredPatient.h"
#include "perilymph/outcome/ClinicLibrary.h"
#include "perilymph/outcome/OutcomeText.h"
#include "perilymph/planning/Plan.h"
#include "perilymph/planning/PlanFolder.h"
#include "perilymph/planning/PlanReport.h"
#include "perilymph/session/Scenario.h"
#include "perilymph/test/HostileSeries.h"
#include "perilymph/test/SyntheticPlan.h"

namespace perilymph::test {
namespace {

namespace fs = std::filesystem;

constexpr const char* plannedArray = "flex28";
constexpr int contactCount = 12;

/// Lets layouts and pictures come to rest.
void settle()
{
  for (int i = 0; i < 8; ++i) QCoreApplication::processEvents();
}

/// The phantom's cochlea as measured once.
const ct::CochleaMeasures& measured()
{
  static const ct::CochleaMeasures measures = [] {
    ct::MeasureRequest request;
    request.click_P = onDisk().phantom.inside_P;
    auto found = ct::measureCochlea(onDisk().phantom.volume, request);
    if (!found) throw std::runtime_error(found.error().message);
    return *found;
  }();
  return measures;
}

/// Contacts on the center line of the mean anatomy in the phantom: number 1 at 420 degrees, the others
/// 30 degrees apart; the last one is outside.
outcome::FoundArray placedArray(const outcome::ContactsRequest& request)
{
  static const auto scala = [] {
    auto scenario = session::loadScenario("surgery-flex28");
    anatomy::Cochlea cochlea = scenario->parameters().cochlea;
    cochlea.source = anatomy::AnatomySource::mean;
    cochlea.patient = imaging::measuredPatient(measured());
    return *anatomy::buildAnatomy(cochlea, "P-53");
  }();
  outcome::FoundArray found;
  found.array = request.arrayName;
  found.side = measured().side;
  for (int number = 1; number <= contactCount; ++number) {
    outcome::FoundContact contact;
    contact.number = number;
    contact.makerElectrode = request.array.makerElectrode(number);
    const double angle_deg = 420.0 - 30.0 * (number - 1);
    contact.position_P = measured().fromAnatomy(scala->center_W(degrees(angle_deg).si()));
    contact.covariance_P = 0.01 * Eigen::Matrix3d::Identity();
    contact.isInside = number < contactCount;
    contact.angle_deg = {angle_deg, 4.0};
    contact.modiolus_mm = 0.55;
    contact.inScalaTympani = number == 3 ? 0.42 : 0.97;
    contact.isSeenSingly = number != 4;
    contact.greenwood_Hz = {500.0 * number, 450.0 * number, 560.0 * number};
    contact.spiralGanglion_Hz = {400.0 * number, 360.0 * number, 450.0 * number};
    contact.filter_Hz = 200.0 * number;
    contact.mismatch_semitones = 12.0;
    if (const auto hand = request.byHand.find(number); hand != request.byHand.end()) {
      contact.position_P = hand->second;
      contact.isByHand = true;
      contact.angle_deg.value += 7.0;  // so that a test sees that it was found again
    }
    found.contacts.push_back(contact);
  }
  found.angularInsertionDepth_deg = found.contacts.front().angle_deg;
  found.tipAngle_deg = 428.0;
  found.contactsInside = contactCount - 1;
  found.insertedLength_mm = 24.6;
  found.insertedLengthSd_mm = 0.3;
  found.flags = {outcome::Flag::contactsOutside, outcome::Flag::earFromThisCt};
  return found;
}

gui::OutcomeFinder finder(std::vector<outcome::Flag> earFlags = {})
{
  gui::OutcomeFinder made = gui::engineFinder();
  made.measuredEar = [earFlags](const ct::CtVolume&,
                                const ct::MeasureRequest&) -> Result<outcome::Ear> {
    outcome::Ear ear;
    ear.measures = measured();
    ear.flags = earFlags;
    return ear;
  };
  made.findContacts = [](const ct::CtVolume&, const outcome::Ear&,
                         const outcome::ContactsRequest& request) -> Result<outcome::FoundArray> {
    request.onProgress(0.5);
    return placedArray(request);
  };
  return made;
}

class AnOutcome : public testing::Test {
protected:
  AnOutcome()
  {
    patient_ = imaging::measuredPatient(measured());
    patient_.label = "P-53";
    const auto saved = gui::savePatientInLibrary(patient_);
    EXPECT_TRUE(saved) << saved.error().message;
    file_ = *saved;
    storePlan();
  }

  /// A plan of the patient, whose first array is the implanted one.
  void storePlan(const char* name = "P-53-plan", const char* madeUtc = "2026-11-20T09:30:00Z")
  {
    planning::Plan plan = syntheticPlan(200);
    plan.request.patient = patient_;
    plan.request.draws = 200;
    plan.request.arrays = {plannedArray, "flex24"};
    plan.arrays[0].array = plannedArray;
    plan.arrays[1].array = "flex24";
    for (std::size_t k = 0; k < 2; ++k) plan.arrays[k].name = plan.request.arrays[k];
    gui::StoredPlan stored{plansFolder() / name, plan.request, 200, true, madeUtc};
    ASSERT_TRUE(planning::savePlanFolder(stored));
    const auto json = planning::planJson(plan);
    ASSERT_TRUE(json) << json.error().message;
    std::ofstream(stored.folder / "plan.json") << *json;
  }

  /// The page with the patient chosen and the phantom opened.
  gui::OutcomePage& show(WindowRig& rig, gui::OutcomeFinder with = finder())
  {
    auto& page = *rig.window().pages().find<gui::OutcomePage>();
    page.setFinder(std::move(with));
    rig.click("outcomePageButton");
    rig.choose("outcomePatientSelector", file_.string().c_str());
    EXPECT_TRUE(WindowRig::waitUntil([&] { return array(rig) == plannedArray; }))
        << rig.label("outcomeStatus").toStdString();
    page.open(onDisk().folder / "ct");
    EXPECT_TRUE(WindowRig::waitUntil([&] { return page.study().hasCt(); }));
    return page;
  }
  static bool isFound(const gui::OutcomePage& page)
  {
    return WindowRig::waitUntil([&] { return page.found() != nullptr && !page.isBusy(); });
  }
  static std::string array(WindowRig& rig)
  {
    return rig.window().findChild<gui::Selector*>("surgeryArray")->value().toStdString();
  }
  static QString typed(WindowRig& rig, const char* field)
  {
    return rig.window().findChild<QLineEdit*>(field)->text();
  }
  static QTableWidget& table(WindowRig& rig, const char* name = "outcomeContacts")
  {
    return *rig.window().findChild<QTableWidget*>(name);
  }
  session::PatientRecord record() const
  {
    const auto read = session::loadPatientRecord(file_);
    EXPECT_TRUE(read) << read.error().message;
    return *read;
  }

  DataFolder data_;
  StateFolder state_;
  anatomy::Patient patient_;
  fs::path file_;
};

TEST_F(AnOutcome, IsFoundAfterAPatientAndACtAreChosenAndStatesItsValues)
{
  WindowRig rig;
  const gui::OutcomePage& page = show(rig);
  ASSERT_TRUE(isFound(page));
  EXPECT_THAT(rig.label("outcomeHead").toStdString(), testing::HasSubstr("420 (412–428)°"));
  EXPECT_THAT(rig.label("outcomeHead").toStdString(), testing::HasSubstr("11 of 12"));
  EXPECT_THAT(rig.label("outcomeHead").toStdString(),
              testing::HasSubstr("the ear is measured in this CT, with wider errors"));
  QTableWidget& contacts = table(rig);
  ASSERT_EQ(contacts.rowCount(), contactCount);
  EXPECT_EQ(contacts.item(0, 0)->text(), "1 (E1)");
  EXPECT_EQ(contacts.item(2, 3)->text(), "42 %");
  EXPECT_EQ(contacts.item(3, 8)->text(), "by spacing");
  EXPECT_EQ(contacts.item(contactCount - 1, 1)->text(), "outside");
  // each flag by its sentence
  for (const outcome::Flag flag : page.found()->flags)
    EXPECT_THAT(rig.label("outcomeFlags").toStdString(),
                testing::HasSubstr(std::string(outcome::sentenceOf(flag))));
}

TEST_F(AnOutcome, ShowsTheWholeCtWhileTheEarIsLookedFor)
{
  gui::OutcomeFinder slow = finder();
  slow.measuredEar = [](const ct::CtVolume&,
                        const ct::MeasureRequest& request) -> Result<outcome::Ear> {
    while (!request.stop.stop_requested()) QThread::msleep(5);
    return Error{"The search was canceled."};
  };
  WindowRig rig;
  gui::OutcomePage& page = show(rig, std::move(slow));
  settle();  // the pictures have their size
  const auto& volume = *page.study().volume();
  const double longest_mm = volume.spacing_mm()[0] * volume.size()[0];
  for (const char* name : {"outcomePlane0", "outcomePlane1", "outcomePlane2"}) {
    const auto& view = *rig.window().findChild<gui::PlaneView*>(name);
    const double shown_mm = page.study().pixel_mm() * std::min(view.width(), view.height());
    EXPECT_GT(shown_mm, 0.4 * longest_mm) << name;
    EXPECT_LT(shown_mm, 3.0 * longest_mm) << name;
  }
  page.cancel();
}

TEST_F(AnOutcome, IsComparedWithTheBandsOfThePlan)
{
  WindowRig rig;
  const gui::OutcomePage& page = show(rig);
  ASSERT_TRUE(isFound(page));
  rig.click("outcomeBesideStage");
  QTableWidget& beside = table(rig, "outcomeBesidePlan");
  ASSERT_EQ(beside.rowCount(), contactCount + 2);
  // angles of the plan's array are 301 to 500: 420 lies at three fifths of them
  EXPECT_EQ(beside.item(0, 3)->text(), "60 %");
  // the plan's depth is 20 mm in all simulations
  EXPECT_EQ(beside.item(1, 3)->text(), "above 95 %");
  // the plan has two contacts
  EXPECT_EQ(beside.item(2, 0)->text(), "Contact 1");
  EXPECT_EQ(beside.item(2, 3)->text(), "60 %");
  EXPECT_EQ(beside.item(5, 1)->text(), QString::fromUtf8("–"));
}

TEST_F(AnOutcome, PercentilesAreThoseOfTheQuantiles)
{
  const planning::Band band{100.0, 140.0, 200.0, 240.0, 300.0};
  EXPECT_EQ(gui::percentileIn(band, 100.0), 5.0);
  EXPECT_EQ(gui::percentileIn(band, 120.0), 15.0);
  EXPECT_EQ(gui::percentileIn(band, 200.0), 50.0);
  EXPECT_EQ(gui::percentileIn(band, 270.0), 85.0);
  EXPECT_FALSE(gui::percentileIn(band, 99.0));
  EXPECT_FALSE(gui::percentileIn(band, 301.0));
}

TEST_F(AnOutcome, AsksForNothingButTheArrayAndExplainsAnErrorWhileItIsTyped)
{
  WindowRig rig;
  show(rig);
  auto& depth = *rig.window().findChild<QLineEdit*>("surgeryIntendedDepth");
  depth.setText("abc");
  EXPECT_THAT(rig.label("surgeryError").toStdString(), testing::HasSubstr("is not a number"));
  EXPECT_FALSE(rig.button("findContactsButton").isEnabled());
  depth.setText("400");
  EXPECT_THAT(rig.label("surgeryError").toStdString(),
              testing::HasSubstr("Intended depth is 400 mm; 0 to 40"));
  depth.setText("24,5");
  EXPECT_TRUE(rig.label("surgeryError").isEmpty());
  depth.clear();
  EXPECT_TRUE(rig.label("surgeryError").isEmpty());
}

TEST_F(AnOutcome, FollowsAContactThatIsDraggedAndTakesItBack)
{
  WindowRig rig;
  gui::OutcomePage& page = show(rig);
  ASSERT_TRUE(isFound(page));
  settle();
  auto& view = *rig.window().findChild<gui::PlaneView*>("outcomePlane0");
  const Eigen::Vector3d before_P = page.found()->contacts[4].position_P;
  const QPoint start = view.placeOf(before_P).toPoint(), end = start + QPoint(18, -6);
  ASSERT_EQ(view.contactAt(start), 5);
  QTest::mousePress(&view, Qt::LeftButton, Qt::NoModifier, start);
  QMouseEvent move(QEvent::MouseMove, QPointF(end), Qt::NoButton, Qt::LeftButton, Qt::NoModifier);
  QCoreApplication::sendEvent(&view, &move);
  QTest::mouseRelease(&view, Qt::LeftButton, Qt::NoModifier, end);
  ASSERT_TRUE(page.found()->contacts[4].isByHand);
  const Eigen::Vector3d moved_P = page.found()->contacts[4].position_P;
  EXPECT_GT((moved_P - before_P).norm(), 0.1);
  // the others are found again around it
  ASSERT_TRUE(WindowRig::waitUntil(
      [&] { return !page.isBusy() && page.found()->contacts[4].angle_deg.value == 307.0; }));
  EXPECT_EQ(table(rig).item(4, 8)->text(), "by hand");
  EXPECT_EQ((page.found()->contacts[4].position_P - moved_P).norm(), 0.0);
  rig.pressKey(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ((page.found()->contacts[4].position_P - before_P).norm(), 0.0);
  EXPECT_FALSE(page.found()->contacts[4].isByHand);
  rig.pressKey(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
  EXPECT_TRUE(page.found()->contacts[4].isByHand);
  EXPECT_EQ(table(rig).item(4, 8)->text(), "by hand");
}

TEST_F(AnOutcome, MovesAContactByKeys)
{
  WindowRig rig;
  gui::OutcomePage& page = show(rig);
  ASSERT_TRUE(isFound(page));
  table(rig).selectRow(2);
  EXPECT_EQ(page.study().chosenContact(), 3);
  const Eigen::Vector3d before_P = page.found()->contacts[2].position_P;
  auto& view = *rig.window().findChild<gui::PlaneView*>("outcomePlane0");
  QTest::keyClick(&view, Qt::Key_Right, Qt::ShiftModifier);
  const Eigen::Vector3d by_P = page.found()->contacts[2].position_P - before_P;
  EXPECT_NEAR(by_P.norm(), 0.1, 1e-9);
  EXPECT_NEAR(by_P.dot(page.study().planes()[0].right_P), 0.1, 1e-9);
}

TEST_F(AnOutcome, EverySaveIsAVersionInThePatientsRecord)
{
  WindowRig rig;
  gui::OutcomePage& page = show(rig);
  ASSERT_TRUE(isFound(page));
  EXPECT_TRUE(page.unfinished());
  rig.click("saveOutcomeButton");
  EXPECT_FALSE(page.unfinished());
  ASSERT_EQ(record().outcomes.size(), 1u);
  rig.choose("surgeryStopReason", "resistance");
  rig.click("saveOutcomeButton");
  const session::PatientRecord now = record();
  ASSERT_EQ(now.outcomes.size(), 2u);
  EXPECT_EQ(now.outcomes[0].series, page.study().series().key);
  const auto first = outcome::outcomeIn(now.outcomes[0].content, "first");
  const auto second = outcome::outcomeIn(now.outcomes[1].content, "second");
  ASSERT_TRUE(first && second);
  EXPECT_EQ(first->surgery.stopReason, outcome::StopReason::unknown);
  EXPECT_EQ(second->surgery.stopReason, outcome::StopReason::resistance);
  // the first one can be opened again, in its CT
  rig.choose("outcomeVersions", "0");
  ASSERT_TRUE(WindowRig::waitUntil([&] { return page.study().hasCt() && !page.isBusy(); }));
  EXPECT_EQ(rig.window().findChild<gui::Selector*>("surgeryStopReason")->value(), "unknown");
  EXPECT_EQ(page.study().contacts().size(), std::size_t(contactCount));
  EXPECT_FALSE(page.unfinished());
}

TEST_F(AnOutcome, IsOfThePlanMadeBeforeSurgeryAsTheCtStatesItsDay)
{
  storePlan("P-53-before", "2025-01-10T09:30:00Z");  // the other one was made after surgery
  auto slices = dicomSlices(onDisk().phantom.volume, "1.2.3.78");
  for (DicomData& each : slices) each.setText(0x00080022, "DA", "20250203");
  const TemporaryFolder folder;
  writeDicomFiles(slices, folder / "ct");
  WindowRig rig;
  gui::OutcomePage& page = show(rig);
  ASSERT_TRUE(isFound(page));
  // that CT states no day
  rig.click("outcomeBesideStage");
  EXPECT_THAT(rig.label("outcomePlanNote").toStdString(), testing::HasSubstr("2026-11-20"));
  EXPECT_THAT(rig.label("outcomePlanDoubt").toStdString(), testing::HasSubstr("states no day"));
  page.open(folder / "ct");
  rig.click("noticeButton");
  ASSERT_TRUE(WindowRig::waitUntil([&] {
    return typed(rig, "surgeryCtDay") == "2025-02-03" && page.found() && !page.isBusy();
  }));
  rig.click("outcomeBesideStage");
  EXPECT_THAT(rig.label("outcomePlanDoubt").toStdString(),
              testing::HasSubstr("Type Days from surgery to CT"));
  rig.type("surgeryDaysToCt", "20");
  ASSERT_TRUE(
      WindowRig::waitUntil([&] { return rig.label("outcomePlanNote").contains("2025-01-10"); }));
  EXPECT_TRUE(rig.label("outcomePlanDoubt").isEmpty());
  rig.click("saveOutcomeButton");
  EXPECT_THAT(rig.label("outcomeStatus").toStdString(), testing::EndsWith("version 1."));
  ASSERT_EQ(record().outcomes.size(), 1u);
  const session::PatientOutcome kept = record().outcomes[0];
  const auto content = outcome::outcomeIn(kept.content, "kept");
  ASSERT_TRUE(content) << content.error().message;
  EXPECT_EQ(outcome::ctDayOf(*content, kept.utc), "2025-02-03");
  // with more days, both plans were made after surgery
  rig.type("surgeryDaysToCt", "30");
  ASSERT_TRUE(
      WindowRig::waitUntil([&] { return rig.label("outcomePlanNote").contains("2026-11-20"); }));
  EXPECT_THAT(rig.label("outcomePlanDoubt").toStdString(),
              testing::HasSubstr("made after surgery"));
  rig.click("saveOutcomeButton");
  EXPECT_THAT(rig.label("outcomeStatus").toStdString(), testing::HasSubstr("made after surgery"));
  // the CT's day is that of the record when it is opened again
  rig.type("surgeryCtDay", "1.1.2025");
  rig.choose("outcomeVersions", "0");
  rig.click("noticeButton");
  EXPECT_EQ(typed(rig, "surgeryCtDay"), "2025-02-03");
  rig.type("surgeryCtDay", "1.1.2999");
  EXPECT_THAT(rig.label("surgeryError").toStdString(), testing::HasSubstr("1.1.2999"));
  EXPECT_FALSE(rig.button("saveOutcomeButton").isEnabled());
  page.cancel();
}

TEST_F(AnOutcome, ThatIsNotSavedIsAskedAboutBeforeAnotherTakesItsPlace)
{
  anatomy::Patient patient = patient_;
  patient.label = "P-54";
  const auto other = gui::savePatientInLibrary(patient);
  ASSERT_TRUE(other) << other.error().message;
  WindowRig rig;
  gui::OutcomePage& page = show(rig);
  ASSERT_TRUE(isFound(page));
  rig.click("saveOutcomeButton");
  table(rig).selectRow(2);
  QTest::keyClick(rig.window().findChild<gui::PlaneView*>("outcomePlane0"), Qt::Key_Right,
                  Qt::ShiftModifier);
  ASSERT_TRUE(isFound(page));
  const auto moved = page.found();
  ASSERT_TRUE(moved->contacts[2].isByHand);
  const std::string own = file_.string(), others = other->string();
  const auto chosen = [&](const char* list) {
    return rig.window().findChild<gui::Selector*>(list)->value().toStdString();
  };
  const std::pair<const char*, std::function<void()>> ways[] = {
      {"another patient", [&] { rig.choose("outcomePatientSelector", others.c_str()); }},
      {"another CT", [&] { page.open(otherOnDisk()); }},
      {"another version", [&] { rig.choose("outcomeVersions", "0"); }},
      {"the patient's history", [&] { page.openSaved(file_, 0); }},
      {"the window's end", [&] { rig.window().close(); }}};
  for (const auto& [what, act] : ways) {
    SCOPED_TRACE(what);
    act();
    ASSERT_TRUE(rig.button("noticeDismissButton").isVisible());
    EXPECT_THAT(rig.window().notice().sentence().toStdString(),
                testing::AllOf(testing::HasSubstr("P-53"), testing::HasSubstr("not saved")));
    rig.click("noticeDismissButton");
    settle();
    EXPECT_TRUE(rig.window().isVisible());
    EXPECT_EQ(page.found(), moved);
    EXPECT_FALSE(page.isBusy());
    EXPECT_EQ(chosen("outcomePatientSelector"), own);
    EXPECT_EQ(chosen("outcomeVersions"), "");
  }
  // an insertion ends no outcome
  auto scenario = session::loadScenario("mean-contour");
  ASSERT_TRUE(scenario);
  Q_EMIT page.insertionRequested({{*scenario, {}}});
  EXPECT_EQ(rig.window().page(), "insert");
  EXPECT_EQ(page.found(), moved);
  rig.click("outcomePageButton");
  // saving answers the question
  rig.choose("outcomePatientSelector", others.c_str());
  ASSERT_TRUE(rig.button("noticeDismissButton").isVisible());
  ASSERT_TRUE(WindowRig::waitUntil([&] { return rig.button("saveOutcomeButton").isEnabled(); }));
  rig.click("saveOutcomeButton");
  EXPECT_FALSE(rig.window().notice().isVisible());
  EXPECT_EQ(record().outcomes.size(), 2u);
  // answers alone are asked about, too, and the other patient has none of them
  rig.type("surgeryIntendedDepth", "20");
  rig.choose("outcomePatientSelector", others.c_str());
  rig.click("noticeButton");
  EXPECT_EQ(chosen("outcomePatientSelector"), others);
  EXPECT_EQ(typed(rig, "surgeryIntendedDepth"), "");
  EXPECT_EQ(record().outcomes.size(), 2u);
  page.cancel();
}

TEST_F(AnOutcome, ThatIsNotSavedIsAskedAboutBeforeAnotherLanguageOpensTheWindowAnew)
{
  WindowRig rig;
  const gui::OutcomePage& page = show(rig);
  ASSERT_TRUE(isFound(page));
  const QSignalSpy reopened(&rig.window(), &gui::MainWindow::reopenRequested);
  Q_EMIT rig.window().sheets().settingChosen();
  EXPECT_EQ(reopened.count(), 0);
  EXPECT_THAT(rig.window().notice().sentence().toStdString(), testing::HasSubstr("P-53"));
  EXPECT_NE(page.found(), nullptr);
  rig.click("noticeButton");
  EXPECT_EQ(reopened.count(), 1);
  Q_EMIT rig.window().sheets().settingChosen();  // nothing is lost any more
  EXPECT_EQ(reopened.count(), 2);
}

TEST_F(AnOutcome, OfNoEarIsNotSaved)
{
  gui::OutcomeFinder wrong = finder();
  wrong.findContacts = [](const ct::CtVolume&, const outcome::Ear&,
                          const outcome::ContactsRequest& request) -> Result<outcome::FoundArray> {
    outcome::FoundArray found = placedArray(request);
    found.insertedLength_mm = 53.6;
    return found;
  };
  WindowRig rig;
  gui::OutcomePage& page = show(rig, std::move(wrong));
  ASSERT_TRUE(isFound(page));
  EXPECT_FALSE(rig.button("saveOutcomeButton").isEnabled());
  for (const std::string& shown : {rig.label("outcomeFlags").toStdString(),
                                   rig.button("saveOutcomeButton").toolTip().toStdString()}) {
    EXPECT_THAT(shown, testing::HasSubstr("53.6 mm"));
    EXPECT_THAT(shown, testing::HasSubstr("28 mm long"));
  }
  page.save();
  EXPECT_TRUE(record().outcomes.empty());
}

TEST_F(AnOutcome, StaysSavedWhileOtherPagesAreVisitedAndAnEarlierVersionCountsAgain)
{
  WindowRig rig;
  gui::OutcomePage& page = show(rig);
  ASSERT_TRUE(isFound(page));
  rig.click("saveOutcomeButton");
  rig.click("outcomeBesideStage");
  rig.window().showPage("plan");
  fs::remove_all(plansFolder() / "P-53-plan");
  rig.click("outcomePageButton");
  // what was planned is read again
  ASSERT_TRUE(WindowRig::waitUntil(
      [&] { return rig.label("outcomePlanNote").startsWith("There is no plan"); }));
  EXPECT_FALSE(rig.button("saveOutcomeButton").isEnabled());
  EXPECT_FALSE(page.unfinished());
  rig.choose("surgeryStopReason", "resistance");
  rig.click("saveOutcomeButton");
  ASSERT_EQ(record().outcomes.size(), 2u);
  // the first one takes the place of the second
  rig.choose("outcomeVersions", "0");
  EXPECT_TRUE(rig.button("exportOutcomeButton").isEnabled());  // while its CT is read
  ASSERT_TRUE(WindowRig::waitUntil([&] { return page.study().hasCt() && !page.isBusy(); }));
  EXPECT_FALSE(page.unfinished());
  ASSERT_TRUE(rig.button("saveOutcomeButton").isEnabled());
  rig.click("saveOutcomeButton");
  const session::PatientRecord now = record();
  ASSERT_EQ(now.outcomes.size(), 3u);
  const auto newest = outcome::outcomeIn(now.outcomes[2].content, "newest");
  ASSERT_TRUE(newest) << newest.error().message;
  EXPECT_EQ(newest->surgery.stopReason, outcome::StopReason::unknown);
  EXPECT_FALSE(rig.button("saveOutcomeButton").isEnabled());
}

TEST_F(AnOutcome, SaysWhereTheAnswersContradictTheArrayOrTheCt)
{
  WindowRig rig;
  rig.click("outcomePageButton");
  rig.type("surgeryIntendedDepth", "26");  // before a patient is chosen
  gui::OutcomePage& page = show(rig);
  ASSERT_TRUE(isFound(page));
  EXPECT_EQ(typed(rig, "surgeryIntendedDepth"), "26.0");
  const auto error = [&rig] { return rig.label("surgeryError").toStdString(); };
  const auto flags = [&rig] { return rig.label("outcomeFlags").toStdString(); };
  rig.type("surgeryIntendedDepth", "35");
  EXPECT_THAT(error(), testing::HasSubstr("Intended depth is 35 mm, and FLEX28 goes 28 mm deep"));
  EXPECT_FALSE(rig.button("saveOutcomeButton").isEnabled());
  rig.type("surgeryIntendedDepth", "28");
  EXPECT_EQ(error(), "");
  EXPECT_THAT(flags(), testing::Not(testing::HasSubstr("The mark at")));
  rig.choose("surgeryMarkReached", "yes");  // 24.6 mm are inserted
  EXPECT_THAT(flags(), testing::HasSubstr("The mark at 28.0 mm was reached"));
  rig.type("surgeryIntendedDepth", "25");
  EXPECT_THAT(flags(), testing::Not(testing::HasSubstr("The mark at")));
  rig.type("surgeryContactsOutside", "13");
  EXPECT_THAT(error(), testing::HasSubstr("Contacts outside is 13, and FLEX28 has 12 contacts"));
  rig.type("surgeryContactsOutside", "3");
  EXPECT_EQ(error(), "");
  EXPECT_THAT(flags(),
              testing::HasSubstr("Contacts outside: 3 as the surgeon states, 1 in the CT"));
  rig.type("surgeryContactsOutside", "1");
  EXPECT_THAT(flags(), testing::Not(testing::HasSubstr("as the surgeon states")));
  EXPECT_TRUE(rig.button("saveOutcomeButton").isEnabled());
}

TEST_F(AnOutcome, StandsInThePatientsHistoryAndIsOpenedFromThere)
{
  WindowRig rig;
  gui::OutcomePage& page = show(rig);
  ASSERT_TRUE(isFound(page));
  rig.click("saveOutcomeButton");
  rig.choose("surgeryStopReason", "resistance");
  rig.click("saveOutcomeButton");
  rig.window().showPage("start");
  rig.click("allPatientsButton");
  auto& patients = *rig.window().findChild<QListWidget*>("patientList");
  patients.setCurrentRow(0);
  QTableWidget& history = table(rig, "patientHistory");
  const auto rowsOf = [&history](const char* what) {
    std::vector<int> rows;
    for (int row = 0; row < history.rowCount(); ++row)
      if (history.item(row, 1)->text() == what) rows.push_back(row);
    return rows;
  };
  ASSERT_TRUE(WindowRig::waitUntil([&] { return rowsOf("Outcome").size() == 2; }));
  keepPicture(rig.window(), "outcome-history");
  EXPECT_THAT(cutTextsOf(rig.window()), testing::IsEmpty());
  const int oldest = rowsOf("Outcome").back();
  EXPECT_EQ(history.item(oldest, 2)->text(), QString::fromUtf8("FLEX28 · 420 (412–428)°"));
  EXPECT_EQ(rowsOf("Plan").size(), 1u);
  const QRect place = history.visualItemRect(history.item(oldest, 2));
  QTest::mouseClick(history.viewport(), Qt::LeftButton, Qt::NoModifier, place.center());
  EXPECT_EQ(rig.window().page(), "outcome");
  ASSERT_TRUE(WindowRig::waitUntil([&] { return page.study().hasCt() && !page.isBusy(); }));
  // the one before a reason was given, in its CT
  EXPECT_EQ(rig.window().findChild<gui::Selector*>("surgeryStopReason")->value(), "unknown");
  ASSERT_NE(page.found(), nullptr);
  EXPECT_EQ(page.study().contacts().size(), std::size_t(contactCount));
  EXPECT_FALSE(page.unfinished());
  EXPECT_EQ(record().outcomes.size(), 2u);  // nothing was saved again
}

TEST_F(AnOutcome, TheTableStatesTheValuesOfTheJson)
{
  WindowRig rig;
  gui::OutcomePage& page = show(rig);
  ASSERT_TRUE(isFound(page));
  TemporaryFolder folder;
  page.exportTo(gui::OutcomeExport::json, folder / "outcome.json");
  page.exportTo(gui::OutcomeExport::table, folder / "outcome.csv");
  page.exportTo(gui::OutcomeExport::markups, folder / "outcome.mrk.json");
  page.exportTo(gui::OutcomeExport::picture, folder / "outcome.png");
  for (const char* each :
       {"outcome.csv", "outcome-dictionary.csv", "outcome.mrk.json", "outcome.png"})
    EXPECT_GT(fs::file_size(folder / each), 0u) << each;
  const auto json = nlohmann::json::parse(std::ifstream(folder / "outcome.json"));
  ASSERT_EQ(json["contacts"].size(), std::size_t(contactCount));
  for (int row = 0; row < contactCount - 1; ++row) {
    const auto& contact = json["contacts"][std::size_t(row)];
    EXPECT_EQ(table(rig).item(row, 0)->text().toStdString(),
              std::to_string(contact["number"].get<int>()) + " (E" +
                  std::to_string(contact["maker_electrode"].get<int>()) + ")");
    EXPECT_EQ(table(rig).item(row, 2)->text().toStdString(),
              QString::number(contact["modiolus_mm"].get<double>(), 'f', 2).toStdString() + " mm");
  }
}

TEST_F(AnOutcome, OfARecordIsFoundAgainAroundAContactThatIsMoved)
{
  WindowRig rig;
  gui::OutcomePage& page = show(rig);
  ASSERT_TRUE(isFound(page));
  rig.click("saveOutcomeButton");
  rig.choose("outcomeVersions", "0");
  ASSERT_TRUE(WindowRig::waitUntil([&] { return page.study().hasCt() && !page.isBusy(); }));
  table(rig).selectRow(2);
  auto& view = *rig.window().findChild<gui::PlaneView*>("outcomePlane0");
  QTest::keyClick(&view, Qt::Key_Right, Qt::ShiftModifier);
  // an angle of the former place is never saved with the new place
  EXPECT_FALSE(rig.button("saveOutcomeButton").isEnabled());
  EXPECT_FALSE(rig.button("outcomeReportButton").isEnabled());
  ASSERT_TRUE(WindowRig::waitUntil([&] { return !page.isBusy(); }));
  EXPECT_EQ(page.found()->contacts[2].angle_deg.value, 367.0);
  EXPECT_TRUE(rig.button("saveOutcomeButton").isEnabled());
}

TEST_F(AnOutcome, OfAMoveWhoseSearchIsCanceledIsNotSaved)
{
  gui::OutcomeFinder slow = finder();
  slow.findContacts = [](const ct::CtVolume&, const outcome::Ear&,
                         const outcome::ContactsRequest& request) -> Result<outcome::FoundArray> {
    while (!request.byHand.empty() && !request.stop.stop_requested()) QThread::msleep(5);
    return placedArray(request);
  };
  WindowRig rig;
  gui::OutcomePage& page = show(rig, std::move(slow));
  ASSERT_TRUE(isFound(page));
  table(rig).selectRow(2);
  auto& view = *rig.window().findChild<gui::PlaneView*>("outcomePlane0");
  QTest::keyClick(&view, Qt::Key_Right, Qt::ShiftModifier);
  ASSERT_TRUE(page.isBusy());
  rig.pressKey(Qt::Key_Escape);
  EXPECT_FALSE(page.isBusy());
  EXPECT_FALSE(rig.button("saveOutcomeButton").isEnabled());
  EXPECT_FALSE(rig.button("exportOutcomeButton").isEnabled());
  rig.pressKey(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_TRUE(rig.button("saveOutcomeButton").isEnabled());
  EXPECT_EQ(page.found()->contacts[2].angle_deg.value, 360.0);
}

TEST_F(AnOutcome, OfAnotherArrayThatIsChosenDuringASearchIsThatOfTheNewOne)
{
  gui::OutcomeFinder slow = finder();
  slow.findContacts = [](const ct::CtVolume&, const outcome::Ear&,
                         const outcome::ContactsRequest& request) -> Result<outcome::FoundArray> {
    while (request.arrayName == plannedArray && !request.stop.stop_requested()) QThread::msleep(5);
    if (request.stop.stop_requested()) return Error{"The search was canceled."};
    return placedArray(request);
  };
  WindowRig rig;
  gui::OutcomePage& page = show(rig, std::move(slow));
  ASSERT_TRUE(WindowRig::waitUntil(
      [&] { return rig.label("outcomeStatus").startsWith("Finding the contacts"); }));
  rig.choose("surgeryArray", "flex24");
  ASSERT_TRUE(isFound(page));
  EXPECT_EQ(page.found()->array, "flex24");
}

TEST_F(AnOutcome, EndsWhereThePatientIsRemovedDuringASearch)
{
  gui::OutcomeFinder slow = finder();
  slow.measuredEar = [](const ct::CtVolume&,
                        const ct::MeasureRequest& request) -> Result<outcome::Ear> {
    while (!request.stop.stop_requested()) QThread::msleep(5);
    return outcome::Ear{measured(), nullptr, false, 0.0, {}};
  };
  WindowRig rig;
  gui::OutcomePage& page = show(rig, std::move(slow));
  ASSERT_TRUE(WindowRig::waitUntil(
      [&] { return rig.label("outcomeStatus").startsWith("Measuring the ear"); }));
  rig.window().showPage("start");
  EXPECT_TRUE(page.isBusy());  // it goes on behind another page
  fs::remove(file_);
  rig.click("outcomePageButton");
  settle();
  EXPECT_FALSE(page.isBusy());
  EXPECT_EQ(page.found(), nullptr);
  EXPECT_FALSE(rig.button("findContactsButton").isEnabled());
  EXPECT_TRUE(rig.label("surgeryError").isEmpty());
}

TEST_F(AnOutcome, AsksNothingOfAnEarlierCtWhenAnotherOneIsOpened)
{
  patient_.basalTurn->a = patient_.basalTurn->a + millimeters(1.5);
  const auto other = gui::savePatientInLibrary(patient_, file_);
  ASSERT_TRUE(other) << other.error().message;
  WindowRig rig;
  gui::OutcomePage& page = show(rig);
  const auto questions = [&] {
    std::size_t open = 0;
    for (const QDialog* each : page.findChildren<QDialog*>("anotherEarQuestion"))
      open += each->isVisible() ? 1 : 0;
    return open;
  };
  ASSERT_TRUE(WindowRig::waitUntil([&] { return questions() == 1; }));
  page.open(otherOnDisk());  // as a call from outside the window does
  EXPECT_EQ(questions(), 0u);
  ASSERT_TRUE(WindowRig::waitUntil([&] { return questions() == 1; }));
  EXPECT_EQ(page.found(), nullptr);
  page.cancel();
}

TEST_F(AnOutcome, OfASeriesThatIsNotToBeTrustedIsRefusedInASentenceAndNothingIsKept)
{
  WindowRig rig;
  auto& page = *rig.window().pages().find<gui::OutcomePage>();
  page.setFinder(finder());
  rig.click("outcomePageButton");
  rig.choose("outcomePatientSelector", file_.string().c_str());
  ASSERT_TRUE(WindowRig::waitUntil([&] { return array(rig) == plannedArray; }));
  const session::PatientRecord before = record();
  for (const HostileSeries& each : hostileSeries()) {
    SCOPED_TRACE(each.name);
    const TemporaryFolder folder;
    each.write(dicomSlices(onDisk().phantom.volume), folder / "ct");
    page.open(folder / "ct");
    ASSERT_TRUE(WindowRig::waitUntil([&] { return !page.isBusy(); }));
    EXPECT_THAT(rig.label("outcomeStatus").toStdString(), testing::HasSubstr(each.sentence));
    EXPECT_FALSE(rig.label("outcomeStatus").contains("Secretname"));
    EXPECT_FALSE(page.study().hasCt());
    EXPECT_EQ(page.found(), nullptr);
    EXPECT_FALSE(rig.button("findContactsButton").isEnabled());
    EXPECT_TRUE(record() == before);
  }
}

TEST_F(AnOutcome, OfImagesThatStateTheOtherSideIsAskedFor)
{
  auto slices = dicomSlices(onDisk().phantom.volume, "1.2.3.77");
  for (DicomData& each : slices)
    each.setText(0x00200060, "CS", patient_.side == anatomy::Side::left ? "R" : "L");
  const TemporaryFolder folder;
  writeDicomFiles(slices, folder / "ct");
  WindowRig rig;
  gui::OutcomePage& page = show(rig);
  ASSERT_TRUE(isFound(page));
  page.open(folder / "ct");
  rig.click("noticeButton");
  const QDialog* question = nullptr;
  ASSERT_TRUE(WindowRig::waitUntil(
      [&] { return (question = page.findChild<QDialog*>("anotherEarQuestion")) != nullptr; }));
  EXPECT_THAT(question->findChild<QLabel*>("anotherEarDoubts")->text().toStdString(),
              testing::HasSubstr("The images state a "));
  EXPECT_EQ(page.found(), nullptr);
  page.findChild<QAbstractButton*>("leaveEarButton")->click();
  EXPECT_TRUE(record().outcomes.empty());
}

TEST_F(AnOutcome, OfASeriesOfAnotherPatientsRecordIsAskedFor)
{
  const auto list = imaging::findSeries(onDisk().folder / "ct");
  ASSERT_TRUE(list) << list.error().message;
  anatomy::Patient other = patient_;
  other.label = "P-54";
  other.origin.seriesKey = list->series.front().key;
  ASSERT_TRUE(gui::savePatientInLibrary(other));
  WindowRig rig;
  gui::OutcomePage& page = show(rig);
  const QDialog* question = nullptr;
  ASSERT_TRUE(WindowRig::waitUntil(
      [&] { return (question = page.findChild<QDialog*>("anotherEarQuestion")) != nullptr; }));
  EXPECT_THAT(question->findChild<QLabel*>("anotherEarDoubts")->text().toStdString(),
              testing::HasSubstr("in the record of P-54"));
  page.findChild<QAbstractButton*>("leaveEarButton")->click();
  EXPECT_EQ(page.found(), nullptr);
  EXPECT_TRUE(record().outcomes.empty());
}

TEST_F(AnOutcome, OfCtsThatDoNotAgreeIsAskedFor)
{
  WindowRig rig;
  gui::OutcomePage& page = show(rig, finder({outcome::Flag::registrationPoor}));
  const QDialog* question = nullptr;
  ASSERT_TRUE(WindowRig::waitUntil(
      [&] { return (question = page.findChild<QDialog*>("anotherEarQuestion")) != nullptr; }));
  EXPECT_THAT(question->findChild<QLabel*>("anotherEarDoubts")->text().toStdString(),
              testing::HasSubstr("do not agree around the cochlea"));
  page.findChild<QAbstractButton*>("leaveEarButton")->click();
}

TEST_F(AnOutcome, IsOfThePatientWhosePlanIsShownOrWhoIsInserted)
{
  const auto showPlan = [this](WindowRig& rig) {
    rig.window().pages().find<gui::OutcomePage>()->setPlannedPatient([this] { return patient_; });
    rig.window().showPage("plan");
  };
  const auto patientShown = [](WindowRig& rig) {
    rig.click("outcomePageButton");
    return rig.window().findChild<gui::Selector*>("outcomePatientSelector")->value().toStdString();
  };
  {
    WindowRig rig;
    EXPECT_EQ(patientShown(rig), "");  // the published cochlea is no saved patient
    showPlan(rig);
    EXPECT_EQ(patientShown(rig), file_.string());
  }
  anatomy::Patient other = patient_;
  other.label = "P-54";
  const auto saved = gui::savePatientInLibrary(other);
  ASSERT_TRUE(saved) << saved.error().message;
  const auto setup = gui::setupOfPatient(other);
  ASSERT_TRUE(setup) << setup.error().message;
  const auto insert = [&setup](WindowRig& rig) {
    rig.window().load({*setup});
    EXPECT_TRUE(WindowRig::waitUntil(
        [&] { return rig.window().control().scenario().patient().label == "P-54"; }));
  };
  {
    WindowRig rig;
    insert(rig);
    showPlan(rig);
    EXPECT_EQ(patientShown(rig), "");  // two ears: which one is meant is not known
  }
  WindowRig rig;
  insert(rig);
  EXPECT_EQ(patientShown(rig), saved->string());
}

TEST_F(AnOutcome, SeesAPlanThatWasMadeAfterThePageWasLeft)
{
  fs::remove_all(plansFolder() / "P-53-plan");
  WindowRig rig;
  auto& page = *rig.window().pages().find<gui::OutcomePage>();
  page.setFinder(finder());
  rig.click("outcomePageButton");
  rig.choose("outcomePatientSelector", file_.string().c_str());
  rig.choose("surgeryArray", plannedArray);
  page.open(onDisk().folder / "ct");
  ASSERT_TRUE(isFound(page));
  rig.click("outcomeBesideStage");
  EXPECT_TRUE(rig.label("outcomePlanNote").startsWith("There is no plan"));
  rig.window().showPage("plan");
  storePlan();
  rig.click("outcomePageButton");
  EXPECT_TRUE(
      WindowRig::waitUntil([&] { return rig.label("outcomePlanNote").startsWith("Plan of "); }));
}

TEST_F(AnOutcome, ACtOfAnotherEarIsNotJoinedWithoutAQuestion)
{
  // a patient whose basal turn is another one
  patient_.basalTurn->a = patient_.basalTurn->a + millimeters(1.5);
  const auto other = gui::savePatientInLibrary(patient_, file_);
  ASSERT_TRUE(other) << other.error().message;
  WindowRig rig;
  gui::OutcomePage& page = show(rig);
  QDialog* question = nullptr;
  const auto isShown = [&] {
    question = page.findChild<QDialog*>("anotherEarQuestion");
    return question != nullptr && question->isVisible();
  };
  ASSERT_TRUE(WindowRig::waitUntil(isShown));
  const std::string doubts = question->findChild<QLabel*>("anotherEarDoubts")->text().toStdString();
  EXPECT_THAT(doubts, testing::HasSubstr("A is"));
  EXPECT_THAT(doubts, testing::HasSubstr("in the record"));
  // the answer of Return is No
  QTest::keyClick(question, Qt::Key_Return);
  EXPECT_TRUE(
      WindowRig::waitUntil([&] { return !page.findChild<QDialog*>("anotherEarQuestion"); }));
  EXPECT_EQ(page.found(), nullptr);
  EXPECT_FALSE(rig.button("saveOutcomeButton").isEnabled());
  EXPECT_THAT(rig.label("outcomeStatus").toStdString(), testing::HasSubstr("was not joined"));
  // asked again, and joined
  rig.click("findContactsButton");
  ASSERT_TRUE(WindowRig::waitUntil(isShown));
  question->findChild<QAbstractButton*>("joinEarButton")->click();
  EXPECT_TRUE(isFound(page));
}

TEST_F(AnOutcome, TheOtherSideIsADoubtEvenIfTheMeasuresAgree)
{
  patient_.side = patient_.side == anatomy::Side::left ? anatomy::Side::right : anatomy::Side::left;
  const auto other = gui::savePatientInLibrary(patient_);
  ASSERT_TRUE(other);
  file_ = *other;
  storePlan();
  WindowRig rig;
  gui::OutcomePage& page = show(rig);
  ASSERT_TRUE(WindowRig::waitUntil(
      [&] { return page.findChild<QDialog*>("anotherEarQuestion") != nullptr; }));
  EXPECT_THAT(page.findChild<QLabel*>("anotherEarDoubts")->text().toStdString(),
              testing::HasSubstr("The ear in this CT is a"));
  const bool isLeft = patient_.side == anatomy::Side::left;
  EXPECT_EQ(page.findChild<QLabel*>("anotherEarTitle")->text(),
            isLeft ? "This CT shows a right ear; the record is that of a left ear."
                   : "This CT shows a left ear; the record is that of a right ear.");
  page.findChild<QAbstractButton*>("leaveEarButton")->click();
}

TEST_F(AnOutcome, ASearchIsCanceledByEscape)
{
  gui::OutcomeFinder slow = finder();
  slow.findContacts = [](const ct::CtVolume&, const outcome::Ear&,
                         const outcome::ContactsRequest& request) -> Result<outcome::FoundArray> {
    while (!request.stop.stop_requested()) QThread::msleep(5);
    return Error{"The search was canceled."};
  };
  WindowRig rig;
  gui::OutcomePage& page = show(rig, std::move(slow));
  ASSERT_TRUE(WindowRig::waitUntil(
      [&] { return rig.label("outcomeStatus").startsWith("Finding the contacts"); }));
  rig.pressKey(Qt::Key_Escape);
  EXPECT_FALSE(page.isBusy());
  EXPECT_EQ(page.found(), nullptr);
  EXPECT_TRUE(rig.button("findContactsButton").isEnabled());
}

TEST_F(AnOutcome, SaysWhichStepRunsAndCancelsTheCarryingOverOfTheEar)
{
  const auto before = imaging::findSeries(onDisk().folder / "ct");
  ASSERT_TRUE(before) << before.error().message;
  patient_.origin.seriesKey = before->series.front().key;
  const auto saved = gui::savePatientInLibrary(patient_, file_);
  ASSERT_TRUE(saved) << saved.error().message;
  gui::rememberScan(patient_.origin.seriesKey, onDisk().folder / "ct");
  gui::OutcomeFinder slow = finder();
  slow.measure = [](const ct::CtVolume&,
                    const ct::MeasureRequest& request) -> Result<ct::CochleaMeasures> {
    request.onProgress(0.5);
    QThread::msleep(400);
    return measured();
  };
  slow.registeredEar = [](const ct::CtVolume&, const ct::CtVolume&, const ct::CochleaMeasures&,
                          const std::stop_token& stop,
                          const std::function<void(double)>& onProgress) -> Result<outcome::Ear> {
    onProgress(0.5);
    while (!stop.stop_requested()) QThread::msleep(5);
    return Error{"The registration was canceled."};
  };
  WindowRig rig;
  auto& page = *rig.window().pages().find<gui::OutcomePage>();
  page.setFinder(std::move(slow));
  rig.click("outcomePageButton");
  rig.choose("outcomePatientSelector", file_.string().c_str());
  ASSERT_TRUE(WindowRig::waitUntil([&] { return array(rig) == plannedArray; }));
  page.open(otherOnDisk());
  const auto& bar = *rig.window().findChild<gui::OutcomePanel*>()->findChild<QProgressBar*>();
  ASSERT_TRUE(WindowRig::waitUntil([&] {
    return rig.label("outcomeStatus").startsWith("Measuring the ear in the CT before surgery");
  })) << rig.label("outcomeStatus").toStdString();
  const int measuring = bar.value();
  ASSERT_TRUE(WindowRig::waitUntil([&] {
    return rig.label("outcomeStatus").startsWith("Carrying the ear over");
  })) << rig.label("outcomeStatus").toStdString();
  EXPECT_GT(bar.value(), measuring);
  rig.pressKey(Qt::Key_Escape);
  EXPECT_FALSE(page.isBusy());
  settle();
  EXPECT_EQ(page.found(), nullptr);
  EXPECT_TRUE(rig.label("outcomeStatus").isEmpty());
  EXPECT_TRUE(rig.button("findContactsButton").isEnabled());
}

TEST_F(AnOutcome, TheReportIsOnePageAndStatesEveryFlag)
{
  try {
    run({"pdftotext", {"-v"}, {}, {}});
  } catch (const std::system_error&) {
    GTEST_SKIP() << "Install the package poppler-utils.";
  }
  WindowRig rig;
  gui::OutcomePage& page = show(rig);
  ASSERT_TRUE(isFound(page));
  settle();
  TemporaryFolder folder;
  page.writeReport({folder / "outcome.pdf"});
  ASSERT_TRUE(fs::exists(folder / "outcome.pdf")) << rig.label("outcomeStatus").toStdString();
  if (const QString kept = qEnvironmentVariable("PERILYMPH_SCREEN_PICTURES"); !kept.isEmpty())
    fs::copy_file(folder / "outcome.pdf", kept.toStdString() + "/outcome-report.pdf",
                  fs::copy_options::overwrite_existing);
  std::string text = textOf(folder / "outcome.pdf");
  EXPECT_THAT(text, testing::HasSubstr("Page 1 of 1"));
  EXPECT_THAT(text, testing::HasSubstr("P-53"));
  EXPECT_THAT(text, testing::HasSubstr("420"));
  for (const char* head : {"GW, kHz", "SG, kHz (95 %)", "filter, kHz", "mismatch, st"})
    EXPECT_THAT(text, testing::HasSubstr(head));
  // lines are broken anywhere
  std::string flat;
  for (const char c : text)
    if (!std::isspace(static_cast<unsigned char>(c))) flat += c;
  // contact 1: the maker's number; modiolus, Greenwood, spiral ganglion, default filter, mismatch
  EXPECT_THAT(flat, testing::HasSubstr("1(E1)420(412–428)°"));
  EXPECT_THAT(flat, testing::HasSubstr("97%0.550.500.40(0.36–0.45)0.2012(10–14)singly"));
  for (const outcome::Flag flag : page.found()->flags) {
    std::string sentence;
    for (const char c : std::string(outcome::sentenceOf(flag)))
      if (!std::isspace(static_cast<unsigned char>(c))) sentence += c;
    EXPECT_THAT(flat, testing::HasSubstr(sentence));
  }
}

TEST_F(AnOutcome, StandsBesideItsPlanOnThePageOutcomes)
{
  WindowRig rig;
  const auto isRead = [&] {
    return WindowRig::waitUntil(
        [&] { return !rig.window().pages().find<gui::OutcomesPage>()->isBusy(); });
  };
  rig.click("outcomesPageButton");
  ASSERT_TRUE(isRead());
  EXPECT_FALSE(table(rig, "outcomesTable").isVisible());  // none is saved yet
  // a plan of one simulation, whose depth is known
  planning::PlanRequest request;
  request.patient = patient_;
  request.arrays = {plannedArray};
  request.draws = 1;
  const fs::path folder = plansFolder() / "P-53-plan";
  fs::remove_all(folder);
  ASSERT_TRUE(planning::savePlanFolder({folder, request, 1, true, "2025-01-10T09:30:00Z"}));
  const auto plan = planning::makePlan(request, folder / planning::planDrawsFile);
  ASSERT_TRUE(plan) << plan.error().message;
  std::ofstream(folder / "plan.json") << *planning::planJson(*plan);
  gui::OutcomePage& page = show(rig);
  ASSERT_TRUE(isFound(page));
  // the plan counts once it is known to be made before surgery
  rig.click("saveOutcomeButton");
  rig.click("outcomesPageButton");
  ASSERT_TRUE(isRead());
  EXPECT_THAT(rig.label("outcomesStatus").toStdString(),
              testing::HasSubstr("the day of its CT is not known"));
  rig.click("outcomePageButton");
  rig.type("surgeryCtDay", "3.2.2025");
  rig.type("surgeryDaysToCt", "20");
  // its place in the plan is the same on both pages
  ASSERT_TRUE(WindowRig::waitUntil([&] { return rig.label("outcomePlanDoubt").isEmpty(); }));
  const QString place = table(rig, "outcomeBesidePlan").item(1, 3)->text();
  const QString anglePlace = table(rig, "outcomeBesidePlan").item(0, 3)->text();
  EXPECT_EQ(table(rig, "outcomeBesidePlan").item(2, 3)->text(), anglePlace);  // contact 1
  rig.click("saveOutcomeButton");
  rig.click("outcomesPageButton");
  ASSERT_TRUE(isRead());
  EXPECT_EQ(table(rig, "outcomesTable").item(0, 4)->text(), place);
  EXPECT_EQ(table(rig, "outcomesTable").item(0, 7)->text(), anglePlace);
  rig.window().resize(1366, 768);
  settle();
  keepPicture(rig.window(), "outcomes");
  EXPECT_THAT(cutTextsOf(rig.window()), testing::IsEmpty());
  QTableWidget& all = table(rig, "outcomesTable");
  ASSERT_EQ(all.rowCount(), 1) << rig.label("outcomesStatus").toStdString();
  EXPECT_TRUE(all.item(0, 0)->text().startsWith("P-53"));
  EXPECT_EQ(all.item(0, 1)->text(), "FLEX28");
  const double simulated_mm = inMillimeters(plan->insertions.front().insertion.depth);
  EXPECT_TRUE(all.item(0, 2)->text().startsWith(QString::number(simulated_mm, 'f', 1)));
  EXPECT_EQ(all.item(0, 3)->text(), QString::fromUtf8("24.6 (24.0–25.2) mm"));
  // (Phi((x - x_1) / sd) + 1/2) / 2 of the one simulation
  const double below = 0.5 * std::erfc(-(24.6 - simulated_mm) / 0.3 / std::sqrt(2.0));
  EXPECT_EQ(all.item(0, 4)->text(),
            QString::number(100.0 * (below + 0.5) / 2.0, 'f', 0) + QString::fromUtf8(" %"));
  // all together, and the array
  const QTableWidget& coverage = table(rig, "outcomesCoverage");
  ASSERT_EQ(coverage.rowCount(), 2);
  EXPECT_EQ(coverage.item(1, 0)->text(), "FLEX28");
  EXPECT_TRUE(coverage.item(0, 2)->text().contains("of 1"));
  // an ear that cannot be compared is named, and the other one stays
  anatomy::Patient other = patient_;
  other.label = "P-54";
  const auto saved = gui::savePatientInLibrary(other);
  ASSERT_TRUE(saved) << saved.error().message;
  const fs::path file = *saved;
  ASSERT_TRUE(session::changePatientRecord(file, [](session::PatientRecord& record) {
    record.outcomes.push_back({"2026-02-20T10:00:00Z", std::string(64, 'a'), "{"});
  }));
  rig.click("outcomePageButton");
  rig.click("outcomesPageButton");
  ASSERT_TRUE(isRead());
  EXPECT_EQ(all.rowCount(), 1);
  EXPECT_TRUE(all.isVisible());
  EXPECT_THAT(rig.label("outcomesStatus").toStdString(), testing::HasSubstr("P-54"));
  EXPECT_THAT(rig.label("outcomesStatus").toStdString(), testing::HasSubstr("is left out"));
  for (const fs::path& each : {file, session::recordFileOf(file)}) fs::remove(each);
}

TEST_F(AnOutcome, IsShownWithoutCutWordsOnASmallScreen)
{
  WindowRig rig;
  const gui::OutcomePage& page = show(rig);
  ASSERT_TRUE(isFound(page));
  rig.window().resize(1366, 768);
  settle();
  EXPECT_THAT(cutTextsOf(rig.window()), testing::IsEmpty());
  keepPicture(rig.window(), "outcome-contacts");
  rig.click("outcomeBesideStage");
  settle();
  EXPECT_THAT(cutTextsOf(rig.window()), testing::IsEmpty());
  keepPicture(rig.window(), "outcome-beside");
}

TEST_F(AnOutcome, NamesAFieldInAnErrorAsTheFormNamesItInGerman)
{
  gui::useLanguage(*QCoreApplication::instance(), "de");
  {
    WindowRig rig;
    rig.click("outcomePageButton");
    for (const char* name :
         {"surgeryIntendedDepth", "surgeryContactsOutside", "surgeryDaysToCt",
          "surgeryIntendedContacts", "surgeryOutside", "surgeryContactAtResistance",
          "surgeryAttempts", "surgeryPullBacks", "surgeryTilt", "surgeryTurn"}) {
      auto& field = *rig.window().findChild<QLineEdit*>(name);
      const QString label = field.accessibleName().section(QLatin1Char(','), 0, 0);
      for (const char* typed : {"99999", "-91", "abc"}) {
        field.setText(typed);
        const QString sentence = rig.label("surgeryError");
        EXPECT_TRUE(sentence.startsWith(label + " ist ")) << sentence.toStdString();
        EXPECT_FALSE(sentence.contains(".000")) << sentence.toStdString();
      }
      field.clear();
      EXPECT_TRUE(rig.label("surgeryError").isEmpty()) << name;
    }
  }
  gui::useLanguage(*QCoreApplication::instance(), "en");
}

TEST_F(AnOutcome, IsShownInGermanWithoutCutWords)
{
  gui::useLanguage(*QCoreApplication::instance(), "de");
  {
    WindowRig rig;
    const gui::OutcomePage& page = show(rig);
    ASSERT_TRUE(isFound(page));
    rig.window().resize(1366, 768);
    settle();
    EXPECT_THAT(rig.label("outcomeHead").toStdString(),
                testing::HasSubstr("Kontakte innen 11 von 12"));
    EXPECT_THAT(cutTextsOf(rig.window()), testing::IsEmpty());
    keepPicture(rig.window(), "outcome-contacts-de");
    rig.click("surgeryMore");
    rig.click("outcomeBesideStage");
    settle();
    EXPECT_THAT(cutTextsOf(rig.window()), testing::IsEmpty());
    keepPicture(rig.window(), "outcome-beside-de");
  }
  gui::useLanguage(*QCoreApplication::instance(), "en");
}

}  // namespace
}  // namespace perilymph::test
