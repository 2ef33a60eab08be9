// SPDX-License-Identifier: BSD-3-Clause

// Reports of insertions on their way to an archive, and what is left when the user cancels on the way.

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>

#include <gmock/gmock.h>

#include <QPushButton>
#include <QTableView>
#include <atomic>
#include <future>

#include "../../unit/archive/FaultyPeer.h"
#include "../../unit/archive/SmallStudy.h"
#include "KeptPicture.h"
#include "OwnFolders.h"
#include "WindowRig.h"
#include "gui/archive/SendDialog.h"
#include "gui/pages/sessions/SessionsPage.h"
#include "gui/setup/PatientLibrary.h"
#include "perilymph/archive/Query.h"
#include "perilymph/archive/Servers.h"
#include "perilymph/device/ScriptedDevice.h"
#include "perilymph/foundation/Resources.h"
#include "perilymph/imaging/CtSeries.h"
#include "perilymph/imaging/EncapsulatedPdf.h"
#include "perilymph/session/Insertion.h"
#include "perilymph/test/DicomServers.h"
#include "perilymph/test/TemporaryFolder.h"

namespace perilymph::test {
namespace {

namespace fs = std::filesystem;
using archive::ctStudy;
using testing::HasSubstr;

/// A window, a small CT on the disk and the settings of an archive.
class SendingToAnArchive : public testing::Test {
protected:
  void SetUp() override
  {
    if (!networkObstacle().empty()) GTEST_SKIP() << networkObstacle();
    writeDicomFiles(archive::smallStudy(), ct());
    const auto list = imaging::findSeries(ct());
    ASSERT_TRUE(list) << list.error().message;
    key_ = list->series.at(0).key;
  }

  fs::path ct() const { return folder_ / "ct"; }
  void open(const archive::Server& server)
  {
    ASSERT_TRUE(archive::writeServers({server}));
    rig_ = std::make_unique<WindowRig>();
  }
  gui::SendDialog* dialog() { return rig_->window().findChild<gui::SendDialog*>("sendDialog"); }
  std::string said() { return rig_->label("sendStatus").toStdString(); }
  /// Whether nothing that was written to be sent is left.
  bool isCleanedUp() const
  {
    for (const fs::directory_entry& each : fs::directory_iterator(temporary_.path()))
      if (each.path().filename().string().find("perilymph-send") != std::string::npos) return false;
    return true;
  }
  static bool waits(const std::function<bool()>& claim) { return WindowRig::waitUntil(claim); }

  /// A report of so many bytes; `before` is called in the thread that writes it.
  gui::SentPart part(const QString& name, std::size_t bytes,
                     std::function<void()> before = {}) const
  {
    return {name, [=, key = key_](const fs::path& place, const fs::path& file) {
              if (before) before();
              std::string pdf = "%PDF-1.4 a report";
              pdf.resize(bytes, ' ');
              return imaging::writeEncapsulatedPdf({pdf, "Insertion plan", "P-17", "test", key},
                                                   place, file);
            }};
  }
  void show(std::vector<gui::SentPart> parts)
  {
    (new gui::SendDialog(std::move(parts), ct(), &rig_->window()))->open();
    rig_->click("sendButton");
  }

  DataFolder data_;
  StateFolder state_;
  OwnFolder config_{"XDG_CONFIG_HOME"};
  OwnFolder temporary_{"TMPDIR"};
  TemporaryFolder folder_;
  std::string key_;
  std::unique_ptr<WindowRig> rig_;
};

/// An archive that has the study of smallStudy(), and takes objects.
archive::Faults takingArchive()
{
  archive::Faults faults;
  faults.rows = 1;
  faults.row = [](DcmDataset& row, int) {
    row.putAndInsertString(DCM_StudyInstanceUID, ctStudy);
    row.putAndInsertString(DCM_SeriesInstanceUID, archive::ctSeries);
    row.putAndInsertString(DCM_PatientID, "MRN-4711");
    row.putAndInsertString(DCM_PatientBirthDate, "19700102");
    row.putAndInsertString(DCM_SeriesNumber, "3");
    row.putAndInsertString(DCM_Modality, "CT");
  };
  return faults;
}

/// Opened by the test; threads that wait for it go on.
struct Gate {
  std::promise<void> promise;
  std::shared_future<void> opened = promise.get_future().share();
  std::atomic<bool> isReached = false;
  void wait()
  {
    isReached = true;
    opened.wait_for(std::chrono::seconds(60));
  }
};

TEST_F(SendingToAnArchive, ClosesWhenItIsCanceledBeforeAnythingIsSent)
{
  const archive::FaultyPeer peer(takingArchive());
  open(peer.entry());
  Gate gate;
  show({part("first", 1000, [&gate] { gate.wait(); }), part("second", 1000)});
  ASSERT_TRUE(waits([&] { return gate.isReached.load(); }));
  rig_->click("sendCloseButton");
  ASSERT_NE(dialog(), nullptr);  // until the writing has ended
  EXPECT_THAT(said(), HasSubstr("Canceling"));
  gate.promise.set_value();
  EXPECT_TRUE(waits([this] { return dialog() == nullptr; }));
  EXPECT_EQ(peer.stored(), 0);
  EXPECT_TRUE(isCleanedUp());
}

TEST_F(SendingToAnArchive, SaysThatAnObjectMayHaveArrivedWhenItWasCanceledUnderWay)
{
  Gate gate;
  archive::Faults faults = takingArchive();
  faults.offered = [&gate] { gate.wait(); };
  const archive::FaultyPeer peer(faults);
  open(peer.entry());
  // more than the buffers of a connection hold
  show({part("first", std::size_t{24} << 20)});
  ASSERT_TRUE(waits([&] { return gate.isReached.load(); }));
  rig_->click("sendCloseButton");
  ASSERT_TRUE(waits([this] { return said().find("Canceling") == std::string::npos; }));
  ASSERT_NE(dialog(), nullptr);
  EXPECT_THAT(said(),
              HasSubstr("was canceled while an object was under way: it may have stored it"));
  EXPECT_EQ(rig_->button("sendCloseButton").text(), "Close");
  gate.promise.set_value();
  rig_->click("sendCloseButton");
  EXPECT_TRUE(waits([this] { return dialog() == nullptr; }));
  EXPECT_EQ(peer.stored(), 0);  // half of it is none
  EXPECT_TRUE(isCleanedUp());
}

TEST_F(SendingToAnArchive, SaysWhatIsStoredWhenItIsCanceledBetweenTwoObjects)
{
  const archive::FaultyPeer peer(takingArchive());
  open(peer.entry());
  Gate gate;
  show({part("first", 1000), part("second", 1000, [&gate] { gate.wait(); })});
  ASSERT_TRUE(waits([&] { return gate.isReached.load(); }));
  rig_->click("sendCloseButton");
  gate.promise.set_value();
  ASSERT_TRUE(waits([this] { return said().find("Canceling") == std::string::npos; }));
  EXPECT_THAT(said(), HasSubstr("1 of 2 objects were stored, as series 1. Then: "));
  EXPECT_THAT(said(), testing::Not(HasSubstr("Stored in the study")));
  EXPECT_EQ(peer.stored(), 1);
}

TEST_F(SendingToAnArchive, ClosesAtOnceWhenItIsCanceledASecondTime)
{
  const archive::FaultyPeer peer(takingArchive());
  open(peer.entry());
  Gate gate;
  show({part("first", 1000, [&gate] { gate.wait(); })});
  ASSERT_TRUE(waits([&] { return gate.isReached.load(); }));
  rig_->click("sendCloseButton");
  rig_->click("sendCloseButton");
  EXPECT_TRUE(dialog() == nullptr || !dialog()->isVisible());
  gate.promise.set_value();
  EXPECT_TRUE(waits([this] { return dialog() == nullptr; }));
  EXPECT_TRUE(waits([this] { return isCleanedUp(); }));
  EXPECT_EQ(peer.stored(), 0);
}

/// A recording of a short insertion into a patient's cochlea.
void record(const fs::path& patient, const char* name)
{
  const auto scenario = session::loadScenario(
      "mean-flex28", {{"patient", patient.string()}, {"nodes", "40"}, {"stop_travel_mm", "2.0"}});
  ASSERT_TRUE(scenario) << scenario.error().message;
  fs::create_directories(sessionFolder());
  auto insertion = session::Insertion::prepare(
      *scenario,
      std::make_unique<device::ScriptedDevice>(scenario->speed().si(), scenario->timeStep().si()),
      sessionFolder() / (std::string(name) + ".insertion"));
  ASSERT_TRUE(insertion) << insertion.error().message;
  ASSERT_TRUE((*insertion)->runToEnd(nullptr));
}

TEST_F(SendingToAnArchive, ARecordedInsertionGoesIntoTheStudyOfItsCtAlone)
{
  const std::string missing = missingProgram(DicomServer::Kind::dcmqrscp);
  if (!missing.empty()) GTEST_SKIP() << missing << " is not installed.";
  const DicomServer running(DicomServer::Kind::dcmqrscp);
  ASSERT_EQ(running.store(ct()), "");
  anatomy::Patient patient;
  patient.label = "P-53";
  patient.basalTurn = anatomy::BasalTurn{millimeters(9.1), millimeters(6.7), std::nullopt};
  patient.origin.seriesKey = key_;
  patient.origin.software = "test";
  const auto file = gui::savePatientInLibrary(patient);
  ASSERT_TRUE(file) << file.error().message;
  record(*file, "measured");
  open(running.entry());
  rig_->window().show();
  rig_->click("sessionsPageButton");
  auto& page = *rig_->window().pages().find<gui::SessionsPage>();
  ASSERT_TRUE(
      waits([&] { return !page.isBusy() && rig_->button("sendReportButton").isEnabled(); }));
  rig_->click("sendReportButton");
  ASSERT_TRUE(waits([this] { return dialog() != nullptr; }))
      << rig_->label("sessionStatus").toStdString();
  EXPECT_FALSE(rig_->button("sendButton").isEnabled());  // its CT is not open
  dialog()->setCt(ct());
  keepPicture(*dialog(), "insertion-send");
  keepPicture(rig_->window(), "sessions-send");
  rig_->click("sendButton");
  ASSERT_TRUE(waits([this] { return said().find("Sending") == std::string::npos; }));
  EXPECT_THAT(said(), HasSubstr("Stored in the study of the CT, as series"));
  rig_->click("sendCloseButton");
  const auto found = archive::findSeries(running.entry(), ctStudy);
  ASSERT_TRUE(found) << found.error().message;
  std::multiset<std::string> kinds;
  for (const auto& each : found->rows) kinds.insert(each.modality);
  EXPECT_EQ(kinds, (std::multiset<std::string>{"CT", "DOC"}));

  // another series is refused, as for a plan
  auto others = archive::smallStudy(13, "1.2.840.99.17.9");
  writeDicomFiles(others, folder_ / "other");
  ASSERT_TRUE(waits([this] { return dialog() == nullptr; }));
  rig_->click("sendReportButton");
  ASSERT_TRUE(waits([this] { return dialog() != nullptr; }));
  dialog()->setCt(folder_ / "other");
  rig_->click("sendButton");
  ASSERT_TRUE(waits([this] { return said().find("Sending") == std::string::npos; }));
  EXPECT_THAT(said(), testing::Not(HasSubstr("Stored")));
  EXPECT_EQ(archive::findSeries(running.entry(), ctStudy)->rows.size(), 2u);
}

TEST_F(SendingToAnArchive, ARecordingWithoutACtSaysSo)
{
  anatomy::Patient patient;
  patient.label = "P-54";
  patient.basalTurn = anatomy::BasalTurn{millimeters(9.1), millimeters(6.7), std::nullopt};
  const auto file = gui::savePatientInLibrary(patient);
  ASSERT_TRUE(file) << file.error().message;
  record(*file, "typed");
  rig_ = std::make_unique<WindowRig>();
  rig_->click("sessionsPageButton");
  auto& page = *rig_->window().pages().find<gui::SessionsPage>();
  ASSERT_TRUE(
      waits([&] { return !page.isBusy() && rig_->button("sendReportButton").isEnabled(); }));
  rig_->click("sendReportButton");
  EXPECT_TRUE(
      waits([this] { return rig_->label("sessionStatus").contains("states no CT series"); }));
  EXPECT_EQ(dialog(), nullptr);
}

}  // namespace
}  // namespace perilymph::test
