// SPDX-License-Identifier: BSD-3-Clause

// Programs that are killed at random while they write a plan, a study, a recording or a patient's
// record, and started again: nothing is lost, and nothing is left behind.

#include <poll.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <gmock/gmock.h>

#include <csignal>
#include <map>
#include <random>

#include "perilymph/anatomy/Patient.h"
#include "perilymph/foundation/Unfinished.h"
#include "perilymph/session/PatientRecord.h"
#include "perilymph/test/Cli.h"
#include "perilymph/test/SyntheticPlan.h"

namespace perilymph::test {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

/// The files of a folder, hidden ones included, with their content.
std::map<std::string, std::string> contentsOf(const fs::path& folder)
{
  std::map<std::string, std::string> all;
  for (const std::string& name : namesIn(folder)) all[name] = contentOf(folder / name);
  return all;
}

/// The content of a file without the time of its plan, which begins plan.toml.
std::string undated(const std::string& content)
{
  return content.starts_with("made = ") ? content.substr(content.find('\n')) : content;
}

class KilledPrograms : public testing::Test {
protected:
  /// Runs a call to its end, which gives the time that it takes.
  ProgramOutcome whole(const std::vector<std::string>& arguments)
  {
    const auto begin = Clock::now();
    const auto outcome = run(fewDrawsCall(arguments));
    duration_ = Clock::now() - begin;
    return outcome;
  }
  /// Kills a call at a random time within that, unless it has ended before.
  void kill(const std::vector<std::string>& arguments)
  {
    const double part = std::uniform_real_distribution<double>(0.0, 1.0)(random_);
    ChildProcess(fewDrawsCall(arguments))
        .wait(std::chrono::duration_cast<std::chrono::milliseconds>(part * duration_));
  }
  std::string place(const std::string& name) const { return folder_ / name; }

  std::mt19937 random_{20'261'126};
  TemporaryFolder folder_;

private:
  Clock::duration duration_{};
};

/// Killed again and again until it is done by itself, or once more at most.
TEST_F(KilledPrograms, ContinueAPlanAndAStudyToTheSameBytes)
{
  std::ofstream(place("s.toml")) << "title = \"Short\"\nscenario = \"mean-flex28\"\ndepth = "
                                    "\"scenario\"\n[cochleae]\nmean = true\nvirtual = 1\n[vary]\n"
                                    "nodes = [20]\ndt_ms = [10.0]\nstop_travel_mm = [1.0]\n"
                                    "speed_mm_s = [4.0, 5.0]\n";
  const std::vector<std::string> commands[] = {
      {"plan", "--patient", "measured", "--arrays", "flex24", "--samples", "1", "--out"},
      {"study", "run", place("s.toml"), "--out"}};
  for (const auto& command : commands) {
    const auto into = [&command, this](const std::string& name) {
      std::vector<std::string> call = command;
      call.push_back(place(name));
      return call;
    };
    ASSERT_EQ(whole(into(command[0])).status, 0);
    const auto expected = contentsOf(place(command[0]));
    for (int i = 0; i < PROGRAM_KILLS; ++i) {
      const std::string name = command[0] + std::to_string(i);
      kill(into(name));
      kill(into(name));  // the second one continues the first
      const auto again = run(fewDrawsCall(into(name)));
      ASSERT_EQ(again.status, 0) << again.err;
      const auto found = contentsOf(place(name));
      // SQLite counts the transactions of the files that a program continues
      for (const auto& [file, content] : expected)
        EXPECT_TRUE(found.contains(file) && (undated(found.at(file)) == undated(content) ||
                                             file == "draws.sqlite" || file.starts_with("shard-")))
            << name << ": " << file;
      EXPECT_EQ(found.size(), expected.size()) << testing::PrintToString(namesIn(place(name)));
    }
  }
}

TEST_F(KilledPrograms, LeaveAReadableRecordingAndNoTable)
{
  const auto call = [this](const std::string& recording) {
    return shortSimulation({"--csv", place("out/run.csv"), "--record", place("out/") + recording});
  };
  fs::create_directory(place("out"));
  ASSERT_EQ(whole(call("whole.insertion")).status, 0);
  const std::string table = contentOf(place("out/run.csv"));
  for (int i = 0; i < 2 * PROGRAM_KILLS; ++i) {
    fs::remove_all(place("out"));
    fs::create_directory(place("out"));
    kill(call("killed.insertion"));
    // what was recorded is the beginning of the insertion, to the same bits
    const fs::path killed = place("out/killed.insertion");
    if (fs::exists(killed) && fs::file_size(killed) == 0) {
      EXPECT_THAT(cli({"replay", killed.string()}).err, testing::HasSubstr("is empty"));
    } else if (fs::exists(killed)) {
      const auto replayed = cli({"replay", place("out/killed.insertion"), "--verify"});
      EXPECT_TRUE(replayed.status == 0 ||
                  replayed.err.find("holds nothing that could be compared") != std::string::npos)
          << replayed.err;
      const auto shown =
          cli({"replay", place("out/killed.insertion"), "--csv", place("killed.csv")});
      ASSERT_EQ(shown.status, 0) << shown.err;
      const std::string rows = contentOf(place("killed.csv"));
      EXPECT_EQ(rows, table.substr(0, rows.size()));
    }
    EXPECT_TRUE(!fs::exists(place("out/run.csv")) || contentOf(place("out/run.csv")) == table);
    ASSERT_EQ(cli(call("again.insertion")).status, 0);
    EXPECT_EQ(contentOf(place("out/run.csv")), table);
    for (const std::string& name : namesIn(place("out")))
      EXPECT_TRUE(name == "run.csv" || name == "again.insertion" ||
                  name.starts_with("killed.insertion"))
          << name;
  }
}

/// A program adds insertions to a record, and states each that is kept.
TEST_F(KilledPrograms, LoseNoEntryOfAPatientsRecord)
{
  for (int i = 0; i < 5 * PROGRAM_KILLS; ++i) {
    const fs::path patient = place("patients") + std::to_string(i) + "/P-17-right.toml";
    fs::create_directory(patient.parent_path());
    int kept[2];
    ASSERT_EQ(::pipe(kept), 0);
    const ::pid_t child = ::fork();
    if (child == 0) {
      for (int n = 0;; ++n) {
        anatomy::Patient measured = measuredPatient();
        measured.basalTurn->a = millimeters(9.0 + 0.001 * n);
        const auto saved = session::savePatientVersion(
            measured, patient, {"2026-11-20T09:30:00Z", {}, {}, {}}, n == 0);
        const auto changed =
            session::changePatientRecord(patient, [n](session::PatientRecord& one) {
              one.insertions.push_back({"2026-11-20T09:30:00Z", std::to_string(n), "FLEX28"});
            });
        if (!saved || !changed || ::write(kept[1], "x", 1) != 1) ::_exit(1);
      }
    }
    ::close(kept[1]);
    const int end = static_cast<int>(::syscall(SYS_pidfd_open, child, 0));
    ASSERT_GE(end, 0);
    pollfd itsEnd{end, POLLIN, 0};
    const timespec longest{0, std::uniform_int_distribution<long>(0, 60'000'000)(random_)};
    EXPECT_EQ(::ppoll(&itsEnd, 1, &longest, nullptr), 0) << "it ended by itself";
    ::close(end);
    ::kill(child, SIGKILL);
    ::waitpid(child, nullptr, 0);
    std::size_t count = 0;
    for (char byte = 0; ::read(kept[0], &byte, 1) == 1;) ++count;
    ::close(kept[0]);

    const auto record = session::loadPatientRecord(patient);
    ASSERT_TRUE(record) << record.error().message;
    EXPECT_FALSE(record->isChangedByHand);
    EXPECT_GE(record->insertions.size(), count);
    EXPECT_LE(record->insertions.size(), count + 1);
    EXPECT_GE(record->versions.size(), count);
    if (fs::exists(patient)) {
      EXPECT_EQ(anatomy::loadPatient(patient)->seal, Seal::intact);
    }
    removeLeftovers(patient.parent_path());  // as a program does when it starts
    ASSERT_TRUE(session::changePatientRecord(
        patient, [](session::PatientRecord& one) { one.notes = "after it"; }));
    for (const std::string& name : namesIn(patient.parent_path()))
      EXPECT_TRUE(name == "P-17-right.toml" || name == "P-17-right.json") << name;
  }
}

}  // namespace
}  // namespace perilymph::test
