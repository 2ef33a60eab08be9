// SPDX-License-Identifier: BSD-3-Clause

// perilymph-cli archive: from the CT in an archive to a report beside it, and what is said on the way.

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>

#include <atomic>
#include <csignal>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "../../unit/archive/FaultyPeer.h"
#include "../../unit/archive/SmallStudy.h"
#include "perilymph/archive/Servers.h"
#include "perilymph/imaging/CtSeries.h"
#include "perilymph/imaging/EncapsulatedPdf.h"
#include "perilymph/test/Cli.h"
#include "perilymph/test/CtPhantom.h"
#include "perilymph/test/DicomServers.h"
#include "perilymph/test/DicomWriter.h"
#include "perilymph/test/InetSockets.h"
#include "perilymph/test/waitUntil.h"

namespace perilymph::test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::Not;
using Json = nlohmann::json;
using Kind = DicomServer::Kind;

// What dicomSlices() writes of the patient, and no output may show unasked.
constexpr const char* secrets[] = {"Secretname", "SECRETID", "19010203"};

class ArchiveCommand : public testing::Test {
protected:
  void SetUp() override
  {
    if (!networkObstacle().empty()) GTEST_SKIP() << networkObstacle();
  }

  ProgramCall call(std::vector<std::string> arguments) const
  {
    arguments.insert(arguments.begin(), "archive");
    ProgramCall made = cliCall(std::move(arguments));
    made.environment.emplace_back("XDG_CONFIG_HOME", folder_ / "config");
    return made;
  }
  ProgramOutcome archive(std::vector<std::string> arguments) const
  {
    return run(call(std::move(arguments)));
  }

  Json json() const { return Json::parse(contentOf(folder_ / "out.json")); }
  std::string jsonFile() const { return folder_ / "out.json"; }

  void add(const archive::Server& server, const std::string& retrieve) const
  {
    const auto added =
        archive({"servers", "--add", server.name, "--ae-title", server.aeTitle, "--host",
                 server.host, "--port", std::to_string(server.port), "--own-port",
                 std::to_string(server.ownPort), "--retrieve", retrieve});
    ASSERT_EQ(added.status, 0) << added.err;
  }

  static void expectNoPatient(const std::string& text)
  {
    for (const char* secret : secrets) EXPECT_THAT(text, Not(HasSubstr(secret)));
  }

  TemporaryFolder folder_;
};

struct Walk {
  Kind kind;
  const char* retrieve;
};

class ArchiveWalk : public ArchiveCommand, public testing::WithParamInterface<Walk> {
protected:
  void SetUp() override
  {
    ArchiveCommand::SetUp();
    if (IsSkipped()) return;
    const std::string missing = missingProgram(GetParam().kind);
    if (!missing.empty()) GTEST_SKIP() << missing << " is not installed.";
  }

  /// Makes the archive known to the program and stores a CT there, which it returns.
  CtPhantom storeCt(const DicomServer& server)
  {
    CtPhantom phantom = makeCtPhantom(3, clinicalScan());
    writeDicomFiles(dicomSlices(phantom.volume, "1.2.3.33"), folder_ / "sent");
    [&] { ASSERT_EQ(server.store(folder_ / "sent"), ""); }();
    add(server.entry(), GetParam().retrieve);
    return phantom;
  }
};

TEST_P(ArchiveWalk, GoesFromTheCtToTheReportBesideIt)
{
  const DicomServer server(GetParam().kind);
  const CtPhantom phantom = storeCt(server);
  if (HasFatalFailure()) return;
  const std::string name = server.entry().name;
  EXPECT_EQ(archive({"echo", name, "--json", jsonFile()}).out, name + " answers\n");
  EXPECT_EQ(json()["answers"], true);

  // nobody is named unless it is asked for
  auto found = archive({"find", name, "--patient-id", "SECRET*", "--json", jsonFile()});
  ASSERT_EQ(found.status, 0) << found.err;
  ASSERT_EQ(json()["studies"].size(), 1u);
  const std::string study = json()["studies"][0]["study_uid"];
  EXPECT_EQ(study, "1.2.3");
  expectNoPatient(found.out + found.err + contentOf(jsonFile()));
  found = archive({"find", name, "--patient-id", "SECRET*", "--show-patients"});
  for (const char* secret : secrets) EXPECT_THAT(found.out, HasSubstr(secret));

  found = archive({"find", name, "--study", study, "--json", jsonFile()});
  ASSERT_EQ(found.status, 0) << found.err;
  ASSERT_EQ(json()["series"].size(), 1u);
  const std::string series = json()["series"][0]["series_uid"];

  const std::string ct = folder_ / "ct";
  const auto fetched = archive(
      {"fetch", name, "--study", study, "--series", series, "--out", ct, "--json", jsonFile()});
  ASSERT_EQ(fetched.status, 0) << fetched.err;
  EXPECT_EQ(json()["images"], phantom.volume.size()[2]);
  EXPECT_EQ(json()["readable"], true) << json()["obstacle"];
  expectNoPatient(fetched.out + fetched.err + contentOf(jsonFile()));

  // it is measured as any other folder, and A is the phantom's within its own error
  if (GetParam().kind == Kind::orthanc) {  // once: it takes seconds
    const std::string measures = folder_ / "measures.json", sr = folder_ / "measures.dcm";
    const std::string lumen = folder_ / "lumen.dcm", view = folder_ / "view.dcm";
    const auto measured = cli({"ct", "measure", ct, "--json", measures, "--structured-report", sr,
                               "--segmentation", lumen, "--key-image", view});
    ASSERT_EQ(measured.status, 0) << measured.err;
    const Json a = Json::parse(contentOf(measures))["A_mm"];
    EXPECT_NEAR(a["value"].get<double>(), phantom.a, 1.96 * a["sd"].get<double>());
    for (const std::string& file : {sr, lumen, view}) {
      const auto sent = archive({"send", name, file});
      EXPECT_EQ(sent.status, 0) << sent.err;
      expectNoPatient(sent.out + sent.err);
    }
  }

  const auto list = imaging::findSeries(ct);
  ASSERT_TRUE(list);
  const std::string report = folder_ / "report.dcm";
  ASSERT_TRUE(imaging::writeEncapsulatedPdf(
      {"%PDF-1.4 a report", "Insertion plan", "P-17", "test", list->series.at(0).key}, ct, report));
  const auto sent = archive({"send", name, report, "--json", jsonFile()});
  ASSERT_EQ(sent.status, 0) << sent.err;
  expectNoPatient(sent.out + sent.err + contentOf(jsonFile()));
  found = archive({"find", name, "--study", study, "--json", jsonFile()});
  EXPECT_EQ(json()["series"].size(), GetParam().kind == Kind::orthanc ? 5u : 2u);
  EXPECT_THAT(found.out, HasSubstr("DOC"));
  expectNoPatient(contentOf(folder_ / "config" / "perilymph" / "servers.toml"));
}

#ifdef PERILYMPH_PYTHON
TEST_P(ArchiveWalk, GoesTheSameWayInPython)
{
  const DicomServer server(GetParam().kind);
  const CtPhantom phantom = storeCt(server);
  if (HasFatalFailure()) return;
  const std::string name = server.entry().name;
  const ProgramCall program = call({});
  const std::string path =
      std::string("/usr/bin:/bin:") + fs::path(program.program).parent_path().string();
  const auto python = [&](std::vector<std::string> arguments) {
    ProgramCall made{PERILYMPH_PYTHON, std::move(arguments), {}, {}};
    made.environment = program.environment;
    made.environment.emplace_back("PYTHONPATH", PERILYMPH_PYTHON_PACKAGE);
    made.environment.emplace_back("PYTHONDONTWRITEBYTECODE", "1");
    made.environment.emplace_back("PATH", path);
    return run(made);
  };
  const auto walked = python({std::string(PERILYMPH_SOURCES) + "/test/app/archive/archive_walk.py",
                              name, folder_ / "ct", std::to_string(phantom.volume.size()[2])});
  EXPECT_EQ(walked.status, 0) << walked.out << walked.err;
  expectNoPatient(walked.out + walked.err);

  // the example of the package: the cochlea in the CT, and its measures beside it
  if (GetParam().kind != Kind::orthanc) return;  // once: it takes seconds
  const auto shown =
      python({std::string(PERILYMPH_SOURCES) + "/resources/examples/python/from_the_archive.py",
              name, "SECRETID", folder_ / "picture.png"});
  ASSERT_EQ(shown.status, 0) << shown.out << shown.err;
  EXPECT_THAT(shown.out, HasSubstr("1 studies, 1 series of CT"));
  EXPECT_THAT(shown.out, testing::ContainsRegex("\nA +[0-9.]+ \\([0-9.]+ to [0-9.]+\\) mm"));
  EXPECT_THAT(shown.out, HasSubstr("stored beside the CT as series"));
  EXPECT_TRUE(fs::exists(folder_ / "picture.png"));
  expectNoPatient(shown.out + shown.err);
  EXPECT_EQ(archive({"find", name, "--study", "1.2.3", "--json", jsonFile()}).status, 0);
  EXPECT_EQ(json()["series"].size(), 3u);
}
#endif

// each a suite of its own for ctest
INSTANTIATE_TEST_SUITE_P(Orthanc, ArchiveWalk, testing::Values(Walk{Kind::orthanc, "get"}));
INSTANTIATE_TEST_SUITE_P(Dcmqrscp, ArchiveWalk, testing::Values(Walk{Kind::dcmqrscp, "move"}));

TEST_F(ArchiveCommand, ListsAddsReplacesAndRemovesServers)
{
  EXPECT_THAT(archive({"servers"}).out, HasSubstr("0 servers"));
  archive::Server server;
  server.name = "pacs";
  server.aeTitle = "PACS";
  server.host = "pacs.example";
  add(server, "get");
  server.host = "other.example";
  add(server, "move");
  const auto listed = archive({"servers", "--json", jsonFile()});
  EXPECT_THAT(listed.out, HasSubstr("PACS at other.example:104, by move to port 11112"));
  ASSERT_EQ(json()["servers"].size(), 1u);
  EXPECT_EQ(json()["servers"][0]["retrieve"], "move");
  EXPECT_EQ(archive({"servers", "--remove", "pacs"}).status, 0);
  expectRefusal(archive({"servers", "--remove", "pacs"}), "no server 'pacs'");
  expectRefusal(archive({"echo", "pacs"}), "no server 'pacs'");
  expectRefusal(archive({"servers", "--add", "a", "--ae-title", "A", "--host", "a b"}),
                "is no name or IPv4 address");
  expectUsageError(archive({"servers", "--add", "a"}), "--add requires");
  expectUsageError(archive({"find", "a", "--study", "1", "--modality", "CT"}), "excludes");
  expectUsageError(archive({}), "subcommand");
}

TEST_F(ArchiveCommand, EndsAtASignalWhileItWaits)
{
  const TakenPort silent;
  archive::Server server;
  server.name = "silent";
  server.aeTitle = "ANY";
  server.host = "127.0.0.1";
  server.port = silent.number();
  add(server, "get");
  ChildProcess waiting(call({"echo", "silent"}));
  ASSERT_TRUE(waitUntil([&] { return !inetSocketsOf(waiting.id()).empty(); }));
  waiting.send(SIGINT);
  const auto outcome = waiting.wait(std::chrono::seconds(20));
  EXPECT_EQ(outcome.status, 1);
  EXPECT_THAT(outcome.err, HasSubstr("was canceled"));
}

TEST_F(ArchiveCommand, GoesOnWhereItWasKilled)
{
  using archive::ctSeries, archive::ctStudy;
  const auto uidOf = [](int i) { return std::string(ctSeries) + "." + std::to_string(i); };
  std::atomic<bool> waits = true, isAtTheSecond = false;
  archive::Faults slow;
  slow.rows = slow.objects = 3;
  slow.row = [&uidOf](DcmDataset& row, int i) {
    row.putAndInsertString(DCM_SOPInstanceUID, uidOf(i).c_str());
  };
  slow.object = [&](DcmDataset& object, int i) {
    object.putAndInsertString(DCM_SOPClassUID, UID_CTImageStorage);
    object.putAndInsertString(DCM_SOPInstanceUID, uidOf(i).c_str());
    object.putAndInsertString(DCM_StudyInstanceUID, ctStudy);
    object.putAndInsertString(DCM_SeriesInstanceUID, ctSeries);
    if (i == 0) return;
    isAtTheSecond = true;
    EXPECT_TRUE(waitUntil([&waits] { return !waits; }));
  };
  archive::FaultyPeer peer(slow);
  add(peer.entry(), "get");
  const std::string ct = folder_ / "ct";
  const ProgramCall fetch =
      call({"fetch", "faulty", "--study", ctStudy, "--series", ctSeries, "--out", ct});
  ChildProcess killed(fetch);
  ASSERT_TRUE(waitUntil([&] { return isAtTheSecond.load(); }));
  killed.send(SIGKILL);
  EXPECT_EQ(killed.wait(std::chrono::seconds(20)).signal, SIGKILL);
  EXPECT_EQ(namesIn(ct + ".partial").size(), 1u);
  waits = false;
  const auto next = run(fetch);
  EXPECT_EQ(next.status, 0) << next.err;
  EXPECT_THAT(next.out, HasSubstr("3 images in " + ct + ", 1 of them from an earlier call"));
  EXPECT_EQ(namesIn(ct).size(), 3u);
  EXPECT_FALSE(fs::exists(ct + ".partial"));
}

TEST_F(ArchiveCommand, SaysWhenTheDiskIsFullAndKeepsWhatIsWhole)
{
  if (!missingProgram(Kind::dcmqrscp).empty()) GTEST_SKIP() << "dcmqrscp is not installed.";
  const CtPhantom phantom = makeCtPhantom(3, clinicalScan());
  writeDicomFiles(dicomSlices(phantom.volume, "1.2.3.33"), folder_ / "sent");
  const DicomServer server(Kind::dcmqrscp);
  ASSERT_EQ(server.store(folder_ / "sent"), "");
  add(server.entry(), "get");
  const std::string ct = folder_ / "ct";
  ProgramCall limited =
      call({"fetch", "dcmqrscp", "--study", "1.2.3", "--series", "1.2.3.33", "--out", ct});
  // no file may become larger than 4 blocks of 512 or 1024 bytes; a slice is
  limited.arguments.insert(limited.arguments.begin(),
                           {"-c", "ulimit -f 4; exec \"$@\"", "sh", limited.program});
  limited.program = "sh";
  expectRefusal(run(limited), "could not be written");
  EXPECT_FALSE(fs::exists(ct));
  EXPECT_FALSE(fs::exists(ct + ".partial"));
}

TEST_F(ArchiveCommand, KeepsTheImagesThatFitOnASmallDisk)
{
  if (::geteuid() != 0) GTEST_SKIP() << "Only root may mount a file system of its own.";
  if (run({"unshare", {"-m", "mount", "-t", "tmpfs", "none", "/mnt"}, {}, {}}).status != 0)
    GTEST_SKIP() << "No file system may be mounted here.";
  if (!missingProgram(Kind::dcmqrscp).empty()) GTEST_SKIP() << "dcmqrscp is not installed.";
  const CtPhantom phantom = makeCtPhantom(3, clinicalScan());
  writeDicomFiles(dicomSlices(phantom.volume, "1.2.3.33"), folder_ / "sent");
  const auto slice = fs::file_size(fs::directory_iterator(folder_ / "sent")->path());
  const DicomServer server(Kind::dcmqrscp);
  ASSERT_EQ(server.store(folder_ / "sent"), "");
  add(server.entry(), "get");
  ProgramCall limited =
      call({"fetch", "dcmqrscp", "--study", "1.2.3", "--series", "1.2.3.33", "--out", "/mnt/ct"});
  // room for five slices and a half; afterward, what is on the disk
  const std::string script = "mount -t tmpfs -o size=" + std::to_string(slice * 11 / 2) +
                             " none /mnt && \"$@\"; status=$?; ls -A /mnt /mnt/ct.partial; "
                             "exit $status";
  limited.arguments.insert(limited.arguments.begin(),
                           {"-m", "sh", "-c", script, "sh", limited.program});
  limited.program = "unshare";
  const ProgramOutcome outcome = run(limited);
  EXPECT_EQ(outcome.status, 1);
  EXPECT_THAT(outcome.err, HasSubstr("could not be written: No space left on device"));
  EXPECT_THAT(outcome.err, testing::ContainsRegex("[1-5] of [0-9]+ images are in /mnt/ct.partial"));
  EXPECT_THAT(outcome.out, HasSubstr("ct.partial"));
  EXPECT_THAT(outcome.out, Not(HasSubstr("\nct\n")));
  EXPECT_THAT(outcome.out, Not(HasSubstr(".part.dcm")));  // nothing half-written
}

}  // namespace
}  // namespace perilymph::test
