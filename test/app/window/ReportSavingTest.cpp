// SPDX-License-Identifier: BSD-3-Clause

// Reports saved by the window's dialog: as PDF, and as DICOM without and with the patient's CT.

#include <gtest/gtest.h>

#include <QTableView>
#include <QTest>
#include <fstream>

#include "OwnFolders.h"
#include "SaveDialog.h"
#include "StudyOfTwoSlices.h"
#include "gui/setup/PatientLibrary.h"
#include "perilymph/device/ScriptedDevice.h"
#include "perilymph/foundation/AtomicFile.h"
#include "perilymph/foundation/Resources.h"
#include "perilymph/session/Insertion.h"
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
  EXPECT_EQ(file.filename(), "20260101T000000Z.pdf");
  EXPECT_EQ(readWhole(file)->substr(0, 5), "%PDF-");
}

TEST_F(SavedReport, IsADicomObjectWithTheCodeAlone)
{
  const fs::path file = save(1);
  EXPECT_EQ(file.filename(), "20260101T000000Z.dcm");
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
  EXPECT_EQ(file.filename(), "20260101T000000Z.dcm");
  // no name in what the program keeps
  for (const fs::path& folder : {data_.path(), state_.path()})
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
      if (!entry.is_regular_file()) continue;
      EXPECT_EQ(readWhole(entry.path())->find("Doe"), std::string::npos) << entry.path();
    }
}

}  // namespace
}  // namespace perilymph::test
