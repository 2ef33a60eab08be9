// SPDX-License-Identifier: BSD-3-Clause

// Reports saved by the window's dialog: as PDF, and as DICOM without and with the patient's CT.

#include <gtest/gtest.h>

#include <QTableView>
#include <QTest>
#include <fstream>
#include <functional>
#include <system_error>

#include "OwnFolders.h"
#include "SaveDialog.h"
#include "StudyOfTwoSlices.h"
#include "gui/pages/insert/ResultCard.h"
#include "gui/pages/plan/PlanPage.h"
#include "gui/setup/PatientLibrary.h"
#include "perilymph/device/ScriptedDevice.h"
#include "perilymph/foundation/AtomicFile.h"
#include "perilymph/foundation/Resources.h"
#include "perilymph/session/Insertion.h"
#include "perilymph/test/ChildProcess.h"
#include "perilymph/test/TemporaryFolder.h"

namespace perilymph::test {
namespace {

namespace fs = std::filesystem;

/// A patient who was measured in the series 1.2.840.99.1.
anatomy::Patient patientOfASeries()
{
  anatomy::Patient patient;
  patient.label = "P-100";
  patient.basalTurn = anatomy::BasalTurn{millimeters(9.2), millimeters(6.8), std::nullopt};
  patient.origin.software = "Perilymph";
  patient.origin.seriesKey = keyOfSeries("1.2.840.99.1");
  patient.origin.landmarksProposed = "RW";
  return patient;
}

class SavedReport : public testing::Test {
protected:
  void SetUp() override
  {
    const auto patient = gui::savePatientInLibrary(patientOfASeries());
    ASSERT_TRUE(patient) << patient.error().message;
    const auto scenario = session::loadScenario(
        "mean-flex28", {{"patient", patient->string()}, {"stop_travel_mm", "3.0"}});
    ASSERT_TRUE(scenario) << scenario.error().message;
    fs::create_directories(sessionFolder());
    const auto insertion = session::Insertion::prepare(
        *scenario,
        std::make_unique<device::ScriptedDevice>(scenario->speed().si(), scenario->timeStep().si()),
        sessionFolder() / "20260101T000000Z.insertion");
    ASSERT_TRUE(insertion) << insertion.error().message;
    ASSERT_TRUE((*insertion)->runToEnd([](const haptics::TickRecord&) { return true; }));
    rig_ = std::make_unique<WindowRig>();
    rig_->click("sessionsPageButton");
    auto& list = *rig_->window().findChild<QTableView*>("sessionList");
    ASSERT_TRUE(WindowRig::waitUntil([&] { return list.model()->rowCount() == 1; }));
    const QRect place = list.visualRect(list.model()->index(0, 2));
    QTest::mouseClick(list.viewport(), Qt::LeftButton, {}, place.center());
  }

  /// Saves the report and waits for what the page says of it.
  fs::path save(int kind, const fs::path& ct = {})
  {
    const fs::path file = saveBy(*rig_, "reportButton", {folder_.path(), kind, ct});
    EXPECT_TRUE(WindowRig::waitUntil([&] {
      return rig_->label("sessionStatus").contains("saved as") ||
             rig_->label("sessionStatus").contains("CT");
    })) << rig_->label("sessionStatus").toStdString();
    return file;
  }

  DataFolder data_;
  StateFolder state_;
  TemporaryFolder folder_;
  std::unique_ptr<WindowRig> rig_;
};

TEST_F(SavedReport, IsAPdfByDefaultUnderTheNameOfTheRecording)
{
  const fs::path file = save(0);
  EXPECT_EQ(file.filename(), "20260101T000000Z-right.pdf");
  EXPECT_EQ(readWhole(file)->substr(0, 5), "%PDF-");
}

TEST_F(SavedReport, IsADicomObjectWithTheCodeAlone)
{
  const fs::path file = save(1);
  EXPECT_EQ(file.filename(), "20260101T000000Z-right.dcm");
  const auto bytes = readWhole(file);
  ASSERT_TRUE(bytes) << rig_->label("sessionStatus").toStdString();
  EXPECT_EQ(bytes->substr(128, 4), "DICM");
  EXPECT_NE(bytes->find("%PDF-"), std::string::npos);
  EXPECT_NE(bytes->find("P-100"), std::string::npos);
  EXPECT_FALSE(rig_->label("sessionStatus").contains("names the patient"));
}

TEST_F(SavedReport, BecomesPartOfTheStudyOfItsCtAndOfNoOtherAndThenNamesThePatient)
{
  writeStudy(folder_ / "own", "1.2.840.99.1", "Doe^Jane");
  writeStudy(folder_ / "other", "1.2.840.99.2", "Roe^Richard");
  const fs::path refused = save(2, folder_ / "other");
  EXPECT_TRUE(rig_->label("sessionStatus").contains("is not the CT in which this was measured"))
      << rig_->label("sessionStatus").toStdString();
  EXPECT_FALSE(fs::exists(refused));

  const fs::path file = save(2, folder_ / "own");
  ASSERT_TRUE(WindowRig::waitUntil([&] { return fs::exists(file); }));
  EXPECT_TRUE(WindowRig::waitUntil(
      [&] { return rig_->label("sessionStatus").contains("names the patient, as the CT does"); }));
  EXPECT_NE(readWhole(file)->find("Doe^Jane"), std::string::npos);
  EXPECT_EQ(file.filename(), "20260101T000000Z-right.dcm");
  // no name in what the program keeps
  for (const fs::path& folder : {data_.path(), state_.path()})
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
      if (!entry.is_regular_file()) continue;
      EXPECT_EQ(readWhole(entry.path())->find("Doe"), std::string::npos) << entry.path();
    }
}

/// The value of an attribute as DCMTK reads it: "P-100"; empty without a value.
std::string attributeOf(const fs::path& file, const std::string& tag)
{
  const std::string line = run({"dcmdump", {"+P", tag, file.string()}, {}, {}}).out;
  const auto begin = line.find('['), end = line.find(']');
  return begin == std::string::npos ? std::string() : line.substr(begin + 1, end - begin - 1);
}

bool hasDcmtk()
{
  try {
    run({"dcmdump", {"--version"}, {}, {}});
    return true;
  } catch (const std::system_error&) {
    return false;
  }
}

/// The identity of a report that was saved with the patient's code alone.
void expectCodeAlone(const fs::path& file, const std::string& title)
{
  EXPECT_EQ(attributeOf(file, "0010,0020"), "P-100");
  EXPECT_EQ(attributeOf(file, "0010,0010"), "");
  EXPECT_EQ(attributeOf(file, "0042,0010"), title);
  EXPECT_NE(attributeOf(file, "0020,000d"), "1.2.840.99") << "a study of its own";
}

/// That of one that was filed in the study of its CT.
void expectStudyOfCt(const fs::path& file, const std::string& title)
{
  EXPECT_EQ(attributeOf(file, "0010,0010"), "Doe^Jane");
  EXPECT_EQ(attributeOf(file, "0042,0010"), title);
  EXPECT_EQ(attributeOf(file, "0020,000d"), "1.2.840.99");
  EXPECT_EQ(attributeOf(file, "0042,0012"), "application/pdf");
}

/// Saves a report from a page in each kind, and reads it back.
class SavedFromAPage : public testing::Test {
protected:
  void SetUp() override
  {
    if (!hasDcmtk()) GTEST_SKIP() << "Install the package dcmtk.";
    const auto patient = gui::savePatientInLibrary(patientOfASeries());
    ASSERT_TRUE(patient) << patient.error().message;
    patient_ = *patient;
    writeStudy(folder_ / "own", "1.2.840.99.1", "Doe^Jane");
    writeStudy(folder_ / "other", "1.2.840.99.2", "Roe^Richard");
  }

  /// @param said  What the page says last.
  void expectEveryKind(WindowRig& rig, const char* button, const std::string& title,
                       const std::function<QString()>& said)
  {
    const auto saved = [&](int kind, const fs::path& ct, const char* sentence) {
      const fs::path file = saveBy(rig, button, {folder_.path(), kind, ct});
      EXPECT_TRUE(WindowRig::waitUntil([&] { return said().contains(QLatin1String(sentence)); }))
          << said().toStdString();
      return file;
    };
    const fs::path pdf = saved(0, {}, ".pdf");
    EXPECT_EQ(readWhole(pdf)->substr(0, 5), "%PDF-");
    const fs::path code = saved(1, {}, ".dcm");
    expectCodeAlone(code, title);
    EXPECT_FALSE(said().contains("names the patient"));
    fs::remove(code);
    saved(2, folder_ / "other", "is not the CT in which this was measured");
    EXPECT_FALSE(fs::exists(code));
    const fs::path filed = saved(2, folder_ / "own", "names the patient, as the CT does");
    EXPECT_EQ(filed, code);
    expectStudyOfCt(filed, title);
  }

  DataFolder data_;
  StateFolder state_;
  TemporaryFolder folder_;
  fs::path patient_;
};

TEST_F(SavedFromAPage, InsertIsAnInsertionReportUnderTheRulesOfThePatientsIdentity)
{
  WindowRig rig(session::Overrides{{"anatomy", "mean"},
                                   {"patient", patient_.string()},
                                   {"nodes", "40"},
                                   {"stop_travel_mm", "2.0"}});
  rig.click("startButton");
  const auto* card = rig.window().findChild<gui::ResultCard*>();
  ASSERT_TRUE(WindowRig::waitUntil([&] { return !card->isHidden(); }));
  expectEveryKind(rig, "resultReportButton", "Insertion report",
                  [&] { return rig.label("noticeText"); });
}

TEST_F(SavedFromAPage, PlanIsAnInsertionPlanUnderTheRulesOfThePatientsIdentity)
{
  WindowRig rig;
  const fs::path scenario = folder_ / "coarse.toml";
  std::ofstream(scenario) << "title = 'coarse'\narray = 'flex28'\nanatomy = 'mean'\n"
                             "friction = 'estimate-from-pig-tissue'\nnodes = 20\ndt_ms = 10.0\n"
                             "start_inside_mm = 1.0\nstop_travel_mm = 20.0\n";
  rig.click("planPageButton");
  auto& page = *rig.window().findChild<gui::PlanPage*>();
  page.setScenario(scenario.string());
  page.planFor(patientOfASeries());
  rig.click("planNoArraysButton");
  rig.click("plan-array-flex24");
  rig.choose("planDraws", "16");
  rig.click("computePlanButton");
  ASSERT_TRUE(WindowRig::waitUntil([&] { return page.plan() && !page.isBusy(); }));
  expectEveryKind(rig, "planReportButton", "Insertion plan",
                  [&] { return rig.label("planStatus"); });
}

}  // namespace
}  // namespace perilymph::test
