// SPDX-License-Identifier: BSD-3-Clause

// The whole road in the real window, with nothing replaced: CT before surgery, plan, insertion, CT after
// surgery, outcome, outcomes. The ear is an implanted phantom, so that the found contacts have a truth.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QDateTime>
#include <QDialog>
#include <QLabel>
#include <QLineEdit>
#include <QMouseEvent>
#include <QTableWidget>
#include <QTest>
#include <chrono>
#include <cmath>

#include "CutTexts.h"
#include "ImplantOnDisk.h"
#include "KeptPicture.h"
#include "OwnFolders.h"
#include "PlanReportRig.h"
#include "TheCtPage.h"
#include "Walk.h"
#include "WindowRig.h"
#include "gui/pages/ct/CtPage.h"
#include "gui/pages/ct/PlaneView.h"
#include "gui/pages/insert/ResultCard.h"
#include "gui/pages/outcome/OutcomePage.h"
#include "gui/pages/outcomes/OutcomesPage.h"
#include "gui/pages/plan/PlanPage.h"
#include "gui/run/Background.h"
#include "gui/setup/PatientLibrary.h"
#include "gui/setup/ScanFolders.h"
#include "gui/widgets/Selector.h"
#include "perilymph/foundation/StateFolder.h"
#include "perilymph/imaging/CtSeries.h"
#include "perilymph/outcome/OutcomeText.h"
#include "perilymph/session/PatientRecord.h"

namespace perilymph::test {
namespace {

namespace fs = std::filesystem;

constexpr int road_ms = 300'000;  // a plan, a measurement, a search beside other work

class AWalkToAnOutcome : public testing::Test {
protected:
  gui::CtPage& ct() { return *rig_.window().pages().find<gui::CtPage>(); }
  gui::PlanPage& plan() { return *rig_.window().findChild<gui::PlanPage*>(); }
  gui::OutcomePage& page() { return *rig_.window().pages().find<gui::OutcomePage>(); }
  gui::OutcomesPage& outcomes() { return *rig_.window().pages().find<gui::OutcomesPage>(); }
  QTableWidget& table(const char* name) { return *rig_.window().findChild<QTableWidget*>(name); }
  static fs::path patientFile()
  {
    const auto saved = gui::savedPatients();
    EXPECT_EQ(saved.size(), 1u);
    return saved.empty() ? fs::path() : saved.front().file;
  }
  static void settle()
  {
    for (int i = 0; i < 8; ++i) QCoreApplication::processEvents();
  }

  /// Each contact that was found, beside its truth.
  static void expectTruth(const outcome::FoundArray& found, double within_mm)
  {
    const auto& truth = implantOnDisk().phantom.truth;
    ASSERT_EQ(found.contacts.size(), truth.contacts.size());
    double squares = 0.0;
    for (std::size_t i = 0; i < found.contacts.size(); ++i) {
      const outcome::FoundContact& each = found.contacts[i];
      ASSERT_EQ(each.number, truth.contacts[i].number);
      const double error_mm = (each.position_P - truth.contacts[i].position_P).norm();
      EXPECT_LT(error_mm, within_mm) << "contact " << each.number;
      squares += error_mm * error_mm;
    }
    ::testing::Test::RecordProperty("rms_um",
                                    int(1e3 * std::sqrt(squares / double(found.contacts.size()))));
    EXPECT_EQ(found.side == anatomy::Side::right, truth.isRight);
    EXPECT_EQ(found.contactsInside, truth.contactsInside);
  }

  void measureAndPlan(Walk& walk)
  {
    rig_.click("ctPageButton");
    ct().open(implantOnDisk().folder / "before");
    ASSERT_TRUE(WindowRig::waitUntil(
        [&] { return ct().study().measures() != nullptr && !ct().isBusy(); }, road_ms));
    rig_.type("ctPatientCode", "P-061");
    ASSERT_TRUE(WindowRig::waitUntil([&] { return !ct().bone().isBusy(); }, road_ms));
    walk.step(1, rig_.window());

    rig_.click("planCtButton");
    rig_.click("planNoArraysButton");
    rig_.click((std::string("plan-array-") + implantedArray).c_str());
    rig_.choose("planDraws", "16");  // a surgeon leaves the 64; this takes less time
    rig_.click("computePlanButton");
    ASSERT_TRUE(WindowRig::waitUntil([&] { return plan().plan() && !plan().isBusy(); }, road_ms));
    walk.step(2, rig_.window());
  }

  void insert(Walk& walk)
  {
    rig_.click("insertPlanArrayButton");
    ASSERT_TRUE(WindowRig::waitUntil([&] {
      return rig_.window().control().scenario().patient().label == "P-061" &&
             rig_.button("startButton").isEnabled();
    }));
    rig_.click("pointerChoice");
    rig_.click("startButton");
    rig_.window().setFocus();
    rig_.holdKey(Qt::Key_Space);
    rig_.holdKey(Qt::Key_Down);
    ASSERT_TRUE(WindowRig::waitUntil(
        [&] { return rig_.now().output.workflow == haptics::Workflow::finished; }, road_ms));
    rig_.releaseKey(Qt::Key_Down);
    rig_.releaseKey(Qt::Key_Space);
    const auto& card = *rig_.window().findChild<gui::ResultCard*>();
    ASSERT_TRUE(WindowRig::waitUntil([&] { return card.isVisible(); }));
    walk.step(3, rig_.window());
  }

  void findTheArray(Walk& walk)
  {
    rig_.click("outcomePageButton");
    rig_.choose("outcomePatientSelector", patientFile().string().c_str());
    auto& array = *rig_.window().findChild<gui::Selector*>("surgeryArray");
    // that of the insertion, without being asked
    ASSERT_TRUE(WindowRig::waitUntil([&] { return array.value() == implantedArray; }))
        << rig_.window().page().toStdString() << ": " << rig_.label("outcomeStatus").toStdString();
    rig_.choose("surgeryStopReason", "mark");
    rig_.choose("surgeryMarkReached", "yes");
    rig_.type("surgeryDaysToCt", "0");
    walk.step(4, rig_.window());
    page().open(implantOnDisk().folder / "after");
    ASSERT_TRUE(WindowRig::waitUntil([&] { return page().study().hasCt(); }, road_ms));
    EXPECT_TRUE(WindowRig::waitUntil(
        [&] { return rig_.label("outcomeStatus").startsWith("Measuring the ear"); }));
    EXPECT_TRUE(rig_.button("cancelContactsButton").isVisible());
    keepPicture(rig_.window(), "outcome-road-measuring");
    // these images state none; the plan's day is that of Greenwich
    const auto today = QDateTime::currentDateTimeUtc().date().toString(Qt::ISODate).toLatin1();
    rig_.type("surgeryCtDay", today.constData());
    ASSERT_TRUE(WindowRig::waitUntil([&] { return page().found() != nullptr && !page().isBusy(); },
                                     road_ms))
        << rig_.label("outcomeStatus").toStdString();
    // the ear is that of the CT before surgery, not measured beside the metal
    EXPECT_TRUE(page().found()->isRegistered) << rig_.label("outcomeStatus").toStdString();
    EXPECT_EQ(page().findChild<QDialog*>("anotherEarQuestion"), nullptr);
    expectTruth(*page().found(), foundWithin_mm);
    EXPECT_EQ(table("outcomeContacts").rowCount(), int(page().found()->contacts.size()));
    settle();
    EXPECT_THAT(cutTextsOf(rig_.window()), testing::IsEmpty());
    walk.step(5, rig_.window());
  }

  void dragAndTakeBack()
  {
    settle();
    auto& view = *rig_.window().findChild<gui::PlaneView*>("outcomePlane0");
    const std::size_t at = 4;
    const Eigen::Vector3d before_P = page().found()->contacts[at].position_P;
    const QPoint start = view.placeOf(before_P).toPoint(), end = start + QPoint(8, -4);
    ASSERT_EQ(view.contactAt(start), int(at) + 1);
    QTest::mousePress(&view, Qt::LeftButton, Qt::NoModifier, start);
    QMouseEvent move(QEvent::MouseMove, QPointF(end), Qt::NoButton, Qt::LeftButton, Qt::NoModifier);
    QCoreApplication::sendEvent(&view, &move);
    QTest::mouseRelease(&view, Qt::LeftButton, Qt::NoModifier, end);
    ASSERT_TRUE(page().found()->contacts[at].isByHand);
    // what is not found again cannot be kept
    EXPECT_FALSE(rig_.button("saveOutcomeButton").isEnabled());
    ASSERT_TRUE(WindowRig::waitUntil([&] { return !page().isBusy(); }, road_ms));
    EXPECT_TRUE(rig_.button("saveOutcomeButton").isEnabled())
        << rig_.label("outcomeStatus").toStdString();
    EXPECT_GT((page().found()->contacts[at].position_P - before_P).norm(), 0.02);
    EXPECT_EQ(table("outcomeContacts").item(int(at), 8)->text(), "by hand");
    rig_.pressKey(Qt::Key_Z, Qt::ControlModifier);
    EXPECT_EQ((page().found()->contacts[at].position_P - before_P).norm(), 0.0);
    EXPECT_FALSE(page().isBusy());
  }

  void keep(Walk& walk)
  {
    rig_.click("saveOutcomeButton");
    const auto record = session::loadPatientRecord(patientFile());
    ASSERT_TRUE(record) << record.error().message;
    ASSERT_EQ(record->outcomes.size(), 1u);
    const auto saved = outcome::outcomeIn(record->outcomes.front().content, "record");
    ASSERT_TRUE(saved) << saved.error().message;
    expectTruth(saved->found, foundWithin_mm);
    EXPECT_EQ(saved->surgery.daysToCt, 0);
    EXPECT_EQ(saved->plan, plan().plan()->fingerprint);
    const fs::path pdf = folder_ / "outcome.pdf", dicom = folder_ / "outcome.dcm";
    page().writeReport({pdf});
    ASSERT_TRUE(fs::exists(pdf)) << rig_.label("outcomeStatus").toStdString();
    const std::string text = textOf(pdf);
    EXPECT_THAT(text, testing::HasSubstr("P-061"));
    EXPECT_THAT(text, testing::HasSubstr("Page 1 of 1"));
    if (const QString kept = qEnvironmentVariable("PERILYMPH_SCREEN_PICTURES"); !kept.isEmpty())
      fs::copy_file(pdf, kept.toStdString() + "/outcome-road.pdf",
                    fs::copy_options::overwrite_existing);
    // into the study of the CT after surgery
    page().writeReport({dicom, implantOnDisk().folder / "after"});
    ASSERT_TRUE(WindowRig::waitUntil([&] { return fs::exists(dicom); }))
        << rig_.label("outcomeStatus").toStdString();
    EXPECT_GT(fs::file_size(dicom), fs::file_size(pdf));  // it holds the page
    rig_.click("outcomeBesideStage");
    settle();
    EXPECT_THAT(cutTextsOf(rig_.window()), testing::IsEmpty());
    walk.step(6, rig_.window());
  }

  void seeAll(Walk& walk)
  {
    rig_.click("outcomesPageButton");
    ASSERT_TRUE(WindowRig::waitUntil([&] { return !outcomes().isBusy(); }, road_ms));
    settle();
    ASSERT_EQ(table("outcomesTable").rowCount(), 1) << rig_.label("outcomesStatus").toStdString();
    EXPECT_TRUE(table("outcomesTable").item(0, 0)->text().startsWith("P-061"));
    EXPECT_THAT(cutTextsOf(rig_.window()), testing::IsEmpty());
    walk.step(7, rig_.window());
  }

  DataFolder data_;
  StateFolder state_;
  TemporaryFolder folder_;
  WindowRig rig_;
};

TEST_F(AWalkToAnOutcome, FindsTheContactsWhereTheyAreAndSetsThemBesideThePlan)
{
  Walk walk("outcome");
  ASSERT_NO_FATAL_FAILURE(measureAndPlan(walk));
  ASSERT_NO_FATAL_FAILURE(insert(walk));
  ASSERT_NO_FATAL_FAILURE(findTheArray(walk));
  ASSERT_NO_FATAL_FAILURE(dragAndTakeBack());
  ASSERT_NO_FATAL_FAILURE(keep(walk));
  ASSERT_NO_FATAL_FAILURE(seeAll(walk));
  EXPECT_EQ(walk.left(), "");
}

/// A patient whose CT before surgery was read and measured, and the finder of the engine.
class ARealSearch : public testing::Test {
protected:
  /// @param a_mm, b_mm  The measures in the record.
  static fs::path save(const fs::path& before, anatomy::Side side, double a_mm, double b_mm)
  {
    const auto list = imaging::findSeries(before);
    EXPECT_TRUE(list);
    anatomy::Patient patient;
    patient.label = "P-062";
    patient.side = side;
    patient.basalTurn = anatomy::BasalTurn{millimeters(a_mm), millimeters(b_mm), std::nullopt};
    patient.origin.seriesKey = list->series.front().key;
    gui::rememberScan(patient.origin.seriesKey, before, patient.label);
    const auto saved = gui::savePatientInLibrary(patient);
    EXPECT_TRUE(saved) << saved.error().message;
    return *saved;
  }
  static fs::path saveOwn()
  {
    const auto& truth = implantOnDisk().phantom.truth;
    return save(implantOnDisk().folder / "before",
                truth.isRight ? anatomy::Side::right : anatomy::Side::left, truth.a, truth.b);
  }
  static gui::OutcomePage& show(WindowRig& rig, const fs::path& patient)
  {
    rig.click("outcomePageButton");
    rig.choose("outcomePatientSelector", patient.string().c_str());
    rig.choose("surgeryArray", implantedArray);
    return *rig.window().pages().find<gui::OutcomePage>();
  }
  static bool rests(gui::OutcomePage& page)
  {
    return WindowRig::waitUntil([&] { return page.study().hasCt() && !page.isBusy(); }, road_ms);
  }
  static std::size_t saved(const fs::path& patient)
  {
    return session::loadPatientRecord(patient)->outcomes.size();
  }

  DataFolder data_;
  StateFolder state_;
};

TEST_F(ARealSearch, InTheCtBeforeSurgerySaysThatThereIsNoArray)
{
  const fs::path patient = saveOwn();
  WindowRig rig;
  gui::OutcomePage& page = show(rig, patient);
  page.open(implantOnDisk().folder / "before");
  ASSERT_TRUE(rests(page));
  EXPECT_THAT(rig.label("outcomeStatus").toStdString(),
              testing::HasSubstr("There is no array in this ear"));
  EXPECT_EQ(page.found(), nullptr);
  EXPECT_FALSE(rig.button("saveOutcomeButton").isEnabled());
  EXPECT_EQ(saved(patient), 0u);
}

TEST_F(ARealSearch, InTheCtOfAnotherPatientJoinsNothingWithoutAQuestion)
{
  // the CT before surgery is of another ear, measured there
  const CtPhantom& other = onDisk().phantom;
  const fs::path patient =
      save(onDisk().folder / "ct", other.isRight ? anatomy::Side::right : anatomy::Side::left,
           other.a, other.b);
  WindowRig rig;
  gui::OutcomePage& page = show(rig, patient);
  page.open(implantOnDisk().folder / "after");
  ASSERT_TRUE(rests(page));
  const bool wasRequested = page.findChild<QDialog*>("anotherEarQuestion") != nullptr;
  EXPECT_TRUE(wasRequested || !rig.label("outcomeStatus").isEmpty());
  if (wasRequested)
    keepPicture(*page.findChild<QDialog*>("anotherEarQuestion"), "outcome-question");
  EXPECT_EQ(page.found(), nullptr);
  EXPECT_EQ(saved(patient), 0u);
}

TEST_F(ARealSearch, EndsWithTheWindow)
{
  const fs::path patient = saveOwn();
  std::chrono::steady_clock::time_point began;
  {
    WindowRig rig;
    const gui::OutcomePage& page = show(rig, patient);
    rig.window().pages().find<gui::OutcomePage>()->open(implantOnDisk().folder / "after");
    ASSERT_TRUE(WindowRig::waitUntil(
        [&] { return rig.label("outcomeStatus").startsWith("Measuring the ear"); }, road_ms));
    EXPECT_TRUE(page.isBusy());
    began = std::chrono::steady_clock::now();
  }
  EXPECT_LT(std::chrono::steady_clock::now() - began, std::chrono::seconds(10));
  EXPECT_FALSE(gui::Background::isAnyThreadLeft());
  EXPECT_EQ(saved(patient), 0u);
}

}  // namespace
}  // namespace perilymph::test
