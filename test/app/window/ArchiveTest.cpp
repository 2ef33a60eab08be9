// SPDX-License-Identifier: BSD-3-Clause

// A CT from an archive in the window: settings, query, retrieval, and what is left of it.

#include <gmock/gmock.h>

#include <QGuiApplication>
#include <QLabel>
#include <QLineEdit>
#include <QScreen>
#include <QTableWidget>
#include <chrono>
#include <fstream>
#include <set>

#include "../../unit/archive/SmallStudy.h"
#include "KeptPicture.h"
#include "OwnFolders.h"
#include "TheCtPage.h"
#include "Walk.h"
#include "WindowRig.h"
#include "gui/archive/ArchiveQuery.h"
#include "gui/pages/ct/CtPage.h"
#include "gui/pages/plan/PlanPage.h"
#include "perilymph/archive/Servers.h"
#include "perilymph/foundation/StateFolder.h"
#include "perilymph/test/DicomServers.h"
#include "perilymph/test/InetSockets.h"

namespace perilymph::test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::Not;

std::vector<fs::path> filesBelow(const fs::path& folder)
{
  std::vector<fs::path> found;
  std::error_code none;
  for (fs::recursive_directory_iterator place(folder, none), end; place != end; ++place)
    if (place->is_regular_file(none)) found.push_back(place->path());
  return found;
}

/// A window with a folder of settings and of state of its own.
class ArchiveInTheWindow : public testing::Test {
protected:
  void SetUp() override
  {
    if (!networkObstacle().empty()) GTEST_SKIP() << networkObstacle();
  }
  void TearDown() override { rig_.reset(); }

  void open()
  {
    rig_ = std::make_unique<WindowRig>();
    gui::MainWindow& window = rig_->window();
    window.resize(window.size().boundedTo(QGuiApplication::primaryScreen()->availableSize()));
    window.show();
    rig_->click("ctPageButton");
  }
  gui::CtPage& page() { return *rig_->window().pages().find<gui::CtPage>(); }
  void fill(const char* field, const std::string& text)
  {
    auto* edit = rig_->window().findChild<QLineEdit*>(QLatin1String(field));
    ASSERT_NE(edit, nullptr) << field;
    edit->setText(QString::fromStdString(text));
  }
  std::string said(const char* name) { return rig_->label(name).toStdString(); }
  QTableWidget& table(const char* name)
  {
    return *rig_->window().findChild<QTableWidget*>(QLatin1String(name));
  }
  std::string cell(const char* name, int row, int column)
  {
    return table(name).item(row, column)->text().toStdString();
  }
  bool waits(const std::function<bool()>& claim) { return WindowRig::waitUntil(claim); }
  /// Types an archive into the settings and saves it.
  void enter(const archive::Server& server)
  {
    rig_->click("archiveAddButton");
    fill("archiveName", server.name);
    fill("archiveAeTitle", server.aeTitle);
    fill("archiveHost", server.host);
    fill("archivePort", std::to_string(server.port));
    fill("archiveOwnAeTitle", server.ownAeTitle);
    rig_->click(server.retrieval == archive::Retrieval::move ? "archiveMove" : "archiveGet");
    fill("archiveOwnPort", std::to_string(server.ownPort));
    rig_->click("archiveSaveButton");
  }

  DataFolder data_;
  StateFolder state_;
  OwnFolder config_{"XDG_CONFIG_HOME"};
  std::unique_ptr<WindowRig> rig_;
};

TEST(TypedDates, AreThoseOfBothLanguagesAndOfDicom)
{
  for (const char* typed : {"1970-01-31", "31.1.1970", "31.01.1970", "19700131", " 1970-01-31 "})
    EXPECT_EQ(gui::dicomDate(QLatin1String(typed)), "19700131") << typed;
  for (const char* typed : {"1970-02-30", "70-1-1", "yesterday", "1.1.70", "19701301", "*"})
    EXPECT_FALSE(gui::dicomDate(QLatin1String(typed))) << typed;
}

TEST_F(ArchiveInTheWindow, IsAskedForNothingUntilItIsEntered)
{
  open();
  EXPECT_TRUE(inetSocketsOf(::getpid()).empty());
  rig_->click("openArchiveButton");
  EXPECT_THAT(said("archiveStatus"), HasSubstr("No archive is entered yet"));
  EXPECT_FALSE(rig_->button("archiveFindButton").isEnabled());
  EXPECT_FALSE(rig_->button("archiveFetchButton").isEnabled());
  EXPECT_TRUE(inetSocketsOf(::getpid()).empty());
  EXPECT_FALSE(fs::exists(archive::serversFile()));
  rig_->click("archiveServersButton");
  EXPECT_TRUE(rig_->button("archiveTestButton").isVisible());
  EXPECT_TRUE(inetSocketsOf(::getpid()).empty());
}

TEST_F(ArchiveInTheWindow, IsEnteredTestedChangedAndRemovedInTheSettings)
{
  open();
  rig_->click("openArchiveButton");
  rig_->click("archiveServersButton");
  archive::Server server;
  server.name = "pacs";
  server.aeTitle = "PACS";
  server.host = "a b";
  enter(server);
  EXPECT_THAT(said("archiveServerStatus"), HasSubstr("'a b' is no name or IPv4 address"));
  EXPECT_FALSE(fs::exists(archive::serversFile()));

  // nobody listens there: what failed, and what the administrator has to know
  const TakenPort silent;
  server.host = "127.0.0.1";
  server.port = freePort();
  server.retrieval = archive::Retrieval::move;
  enter(server);
  EXPECT_THAT(said("archiveServerStatus"), HasSubstr("Saved"));
  rig_->click("archiveTestButton");
  ASSERT_TRUE(waits([this] { return rig_->button("archiveTestButton").isEnabled(); }));
  EXPECT_THAT(said("archiveServerStatus"),
              testing::AllOf(HasSubstr("cannot be reached"), HasSubstr("AE title PERILYMPH"),
                             HasSubstr("port 11112")));
  const auto* answer = rig_->window().findChild<QLabel*>("archiveServerStatus");
  EXPECT_TRUE(waits([&] { return answer->height() >= answer->heightForWidth(answer->width()); }));
  EXPECT_GT(answer->height(), 3 * answer->fontMetrics().height());  // it is whole
  keepPicture(rig_->window(), "archive-settings");
  auto read = archive::readServers();
  ASSERT_TRUE(read);
  ASSERT_EQ(read->size(), 1u);
  EXPECT_EQ(read->front().port, server.port);
  EXPECT_EQ(read->front().retrieval, archive::Retrieval::move);

  fill("archiveAeTitle", "OTHER");
  rig_->click("archiveTls");
  rig_->click("archiveSaveButton");
  EXPECT_THAT(said("archiveServerStatus"), HasSubstr("certificate of the authority"));
  fill("archiveAuthority", "/etc/ssl/hospital.pem");
  rig_->click("archiveSaveButton");
  read = archive::readServers();
  ASSERT_EQ(read->size(), 1u);
  EXPECT_EQ(read->front().aeTitle, "OTHER");
  EXPECT_EQ(read->front().tls->authority, "/etc/ssl/hospital.pem");

  server.name = "second";
  enter(server);
  EXPECT_EQ(archive::readServers()->size(), 2u);
  rig_->click("archiveRemoveButton");
  read = archive::readServers();
  ASSERT_EQ(read->size(), 1u);
  EXPECT_EQ(read->front().name, "pacs");
  // the page behind the settings has the new list
  EXPECT_TRUE(rig_->button("archiveFindButton").isEnabled());
}

TEST_F(ArchiveInTheWindow, RemovesWhatAKilledProgramHadRetrieved)
{
  char machine[256] = {};
  ASSERT_EQ(::gethostname(machine, sizeof machine), 0);
  // as unfinishedPath() names it, of a process that has ended: the highest number that Linux gives
  const fs::path left =
      stateFolder() / "archive" / (".series." + std::string(machine) + "-4194303.1.part");
  fs::create_directories(left / "0123.partial");
  std::ofstream(left / "0123.partial" / "slice.dcm") << "Secretname";
  open();
  EXPECT_FALSE(fs::exists(left));
}

struct Way {
  DicomServer::Kind kind;
  archive::Retrieval retrieval;
};

class ACtFromTheArchive : public ArchiveInTheWindow, public testing::WithParamInterface<Way> {
protected:
  void SetUp() override
  {
    ArchiveInTheWindow::SetUp();
    if (IsSkipped()) return;
    const std::string missing = missingProgram(GetParam().kind);
    if (!missing.empty()) GTEST_SKIP() << missing << " is not installed.";
    running_ = std::make_unique<DicomServer>(GetParam().kind);
    ASSERT_EQ(running_->store(onDisk().folder / "ct"), "");
    server_ = running_->entry();
    server_.retrieval = GetParam().retrieval;
    ASSERT_TRUE(archive::writeServers({server_}));
    open();
    rig_->click("openArchiveButton");
  }
  void findAll()
  {
    fill("archivePatientId", "SECRET*");
    rig_->click("archiveFindButton");
    ASSERT_TRUE(waits([this] { return table("archiveStudies").rowCount() == 1; }));
    ASSERT_TRUE(waits([this] { return table("archiveSeries").rowCount() == 1; }));
    ASSERT_TRUE(waits([this] { return rig_->button("archiveFetchButton").isEnabled(); }));
  }

  std::unique_ptr<DicomServer> running_;
  archive::Server server_;
};

TEST_P(ACtFromTheArchive, IsMeasuredAtOnceAndNothingOfThePatientIsKept)
{
  ASSERT_NO_FATAL_FAILURE(findAll());
  EXPECT_EQ(cell("archiveStudies", 0, 1), "Secretname, Patient");
  EXPECT_EQ(cell("archiveStudies", 0, 3), "1901-02-03");
  const auto& fetch = rig_->button("archiveFetchButton");
  EXPECT_GE(fetch.width(), fetch.fontMetrics().horizontalAdvance(fetch.text()) + 2 * 17);
  keepPicture(rig_->window(), "archive-found");
  const std::string images = std::to_string(onDisk().phantom.volume.size()[2]);
  // dcmqrscp does not count them
  EXPECT_EQ(cell("archiveSeries", 0, 2),
            GetParam().kind == DicomServer::Kind::orthanc ? images : "\u2013");
  rig_->click("archiveFetchButton");
  ASSERT_TRUE(waits([this] { return page().study().hasCt(); })) << said("archiveStatus");
  EXPECT_TRUE(page().isBusy());  // it is measured
  const fs::path kept = stateFolder() / "archive";
  EXPECT_EQ(filesBelow(kept).size(), std::size_t(onDisk().phantom.volume.size()[2]));
  page().cancel();
  // tables and fields are empty again
  EXPECT_EQ(table("archiveStudies").rowCount(), 0);
  EXPECT_EQ(rig_->window().findChild<QLineEdit*>("archivePatientId")->text(), "");
  EXPECT_TRUE(inetSocketsOf(::getpid()).empty());
  rig_.reset();
  EXPECT_TRUE(filesBelow(kept).empty());  // the images went with the window
  for (const fs::path& root : {stateFolder(), archive::serversFile().parent_path()})
    for (const fs::path& file : filesBelow(root)) {
      std::ifstream stream(file, std::ios::binary);
      const std::string text{std::istreambuf_iterator<char>(stream), {}};
      for (const char* secret : {"Secretname", "SECRETID", "19010203"}) {
        EXPECT_THAT(text, Not(HasSubstr(secret))) << file;
        EXPECT_THAT(file.string(), Not(HasSubstr(secret)));
      }
    }
}

TEST_P(ACtFromTheArchive, IsMeasuredPlannedReportedAndFiledInTheArchive)
{
  const auto began = std::chrono::steady_clock::now();
  ASSERT_NO_FATAL_FAILURE(findAll());
  rig_->click("archiveFetchButton");
  ASSERT_TRUE(waits([this] { return page().study().measures() != nullptr && !page().isBusy(); }))
      << said("archiveStatus") << said("ctStatus");
  EXPECT_NEAR(page().study().measures()->a.value, onDisk().phantom.a, 0.4);
  keepPicture(rig_->window(), "archive-measured");

  // measures, lumen and picture
  rig_->click("sendCtResultsButton");
  ASSERT_TRUE(rig_->button("sendButton").isEnabled());
  keepPicture(*rig_->window().findChild<QWidget*>("sendDialog"), "archive-send");
  rig_->click("sendButton");
  ASSERT_TRUE(waits([this] { return said("sendStatus").find("Sending") == std::string::npos; }));
  EXPECT_THAT(said("sendStatus"), HasSubstr("Stored in the study of the CT, as series"));
  EXPECT_FALSE(rig_->button("sendButton").isEnabled());
  keepPicture(*rig_->window().findChild<QWidget*>("sendDialog"), "archive-sent");
  rig_->click("sendCloseButton");

  // the plan's report; its CT is still open, so nothing is asked for
  rig_->type("ctPatientCode", "P-311");
  rig_->click("planCtButton");
  auto& plan = *rig_->window().findChild<gui::PlanPage*>();
  rig_->click("planNoArraysButton");
  rig_->click("plan-array-flex24");
  rig_->choose("planDraws", "16");
  rig_->click("computePlanButton");
  ASSERT_TRUE(WindowRig::waitUntil([&] { return plan.plan() && !plan.isBusy(); }, 300'000));
  ASSERT_TRUE(
      waits([this] { return rig_->window().findChild<QWidget*>("sendDialog") == nullptr; }));
  rig_->click("sendPlanButton");
  ASSERT_TRUE(waits([this] { return rig_->window().findChild<QWidget*>("sendDialog") != nullptr; }))
      << said("planStatus");
  keepPicture(rig_->window(), "archive-plan");
  EXPECT_TRUE(rig_->button("sendButton").isEnabled());
  rig_->click("sendButton");
  ASSERT_TRUE(waits([this] { return said("sendStatus").find("Sending") == std::string::npos; }));
  EXPECT_THAT(said("sendStatus"), HasSubstr("Stored in the study of the CT, as series"));
  rig_->click("sendCloseButton");

  // and the archive has them beside the CT, each under its own number
  rig_->click("ctPageButton");
  rig_->click("openArchiveButton");
  fill("archivePatientId", "SECRETID");
  rig_->click("archiveFindButton");
  ASSERT_TRUE(waits([this] { return table("archiveSeries").rowCount() == 5; }));
  std::set<std::string> kinds, numbers;
  for (int row = 0; row < 5; ++row) {
    numbers.insert(cell("archiveSeries", row, 0));
    kinds.insert(cell("archiveSeries", row, 1));
  }
  EXPECT_EQ(kinds, (std::set<std::string>{"CT", "SR", "SEG", "OT", "DOC"}));
  EXPECT_EQ(numbers.size(), 5u);
  keepPicture(rig_->window(), "archive-filed");
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - began;
  std::printf("the walk took %.0f s\n", took.count());
}

TEST_F(ArchiveInTheWindow, ShowsAStudyWithTheSeriesToChooseFirstAsInTheGuide)
{
  const std::string missing = missingProgram(DicomServer::Kind::orthanc);
  if (!missing.empty()) GTEST_SKIP() << missing << " is not installed.";
  const DicomServer running(DicomServer::Kind::orthanc);
  const TemporaryFolder folder;
  auto images = archive::smallStudy();
  for (auto& image : archive::smallStudy(3, "1.2.840.99.17.2")) {
    image.setText(0x00080060, "CS", "MR");
    image.setText(0x0008103E, "LO", "T2 axial");
    image.setText(0x00200011, "IS", "5");
    images.push_back(image);
  }
  writeDicomFiles(images, folder / "ct");
  ASSERT_EQ(running.store(folder / "ct"), "");
  archive::Server server = running.entry();
  server.name = "Radiology";
  ASSERT_TRUE(archive::writeServers({server}));
  open();
  rig_->window().resize(1280, 760);
  rig_->click("openArchiveButton");
  fill("archivePatientId", "MRN-4711");
  rig_->click("archiveFindButton");
  ASSERT_TRUE(waits([this] { return table("archiveSeries").rowCount() == 2; }));
  ASSERT_TRUE(waits([this] { return !page().isBusy(); }));
  EXPECT_EQ(cell("archiveStudies", 0, 1), "M\u00fcller, Jane");
  EXPECT_EQ(cell("archiveSeries", 0, 1), "CT");
  EXPECT_EQ(cell("archiveSeries", 0, 2), "12");
  EXPECT_EQ(cell("archiveSeries", 1, 1), "MR");
  table("archiveSeries").selectRow(0);
  EXPECT_TRUE(rig_->button("archiveFetchButton").isEnabled());
  keepForGuide(rig_->window(), "archive-search");
}

TEST_F(ArchiveInTheWindow, NeverBlocksTheWindowAndIsCanceledByEscAndByTheEnd)
{
  const TakenPort silent;  // takes a connection, and never answers
  archive::Server server;
  server.name = "silent";
  server.aeTitle = "SILENT";
  server.host = "127.0.0.1";
  server.port = silent.number();
  ASSERT_TRUE(archive::writeServers({server}));
  open();
  rig_->click("openArchiveButton");
  fill("archivePatientId", "1");
  rig_->click("archiveFindButton");
  EXPECT_TRUE(page().isBusy());
  ASSERT_TRUE(waits([] { return !inetSocketsOf(::getpid()).empty(); }));
  const auto before = std::chrono::steady_clock::now();
  rig_->pressKey(Qt::Key_Escape);
  EXPECT_FALSE(page().isBusy());
  EXPECT_EQ(said("archiveStatus"), "Canceled.");
  ASSERT_TRUE(waits([&] { return inetSocketsOf(::getpid()).size() <= 1; }));  // the test's own
  rig_->click("archiveFindButton");
  EXPECT_TRUE(page().isBusy());
  rig_.reset();
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - before;
  EXPECT_LT(took.count(), 5.0);
  EXPECT_LE(inetSocketsOf(::getpid()).size(), 1u);
}

std::string nameOf(const testing::TestParamInfo<Way>& way)
{
  return std::string(way.param.kind == DicomServer::Kind::orthanc ? "Orthanc" : "Dcmqrscp") +
         (way.param.retrieval == archive::Retrieval::get ? "Get" : "Move");
}

INSTANTIATE_TEST_SUITE_P(EachWay, ACtFromTheArchive,
                         testing::Values(Way{DicomServer::Kind::orthanc, archive::Retrieval::get},
                                         Way{DicomServer::Kind::dcmqrscp,
                                             archive::Retrieval::move}),
                         nameOf);

}  // namespace
}  // namespace perilymph::test
