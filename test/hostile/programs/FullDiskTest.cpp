// SPDX-License-Identifier: BSD-3-Clause

// Full disks: before anything is written, and while writing.

#include <sys/mount.h>
#include <unistd.h>

#include "perilymph/test/Cli.h"

namespace perilymph::test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

/// perilymph-cli with a limited file size [KiB], which behaves like a full disk.
ProgramOutcome cliWithSmallFiles(int max_KiB, const std::vector<std::string>& arguments)
{
  ProgramCall call = cliCall(arguments);
  std::vector<std::string> text = {"-c", "ulimit -f \"$1\"; shift; exec \"$@\"", "bash",
                                   std::to_string(max_KiB), call.program};
  text.insert(text.end(), arguments.begin(), arguments.end());
  return run({"bash", text, {}, {}});
}

/// Exactly one message on standard error, naming the file.
void expectSentence(const ProgramOutcome& outcome, const std::string& file)
{
  EXPECT_EQ(outcome.status, 1) << outcome.out << outcome.err;
  EXPECT_EQ(outcome.signal, 0);
  EXPECT_THAT(outcome.err, HasSubstr(file));
  EXPECT_LE(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 2) << outcome.err;
}

TEST(FullDisk, LeavesNoHalfTableBehind)
{
  const TemporaryFolder folder;
  const std::string csv = folder / "run.csv";
  expectSentence(cliWithSmallFiles(16, shortSimulation({"--csv", csv})), "run.csv");
  EXPECT_THAT(namesIn(folder.path()), testing::IsEmpty());
}

TEST(FullDisk, LeavesAnOlderFileAsItWas)
{
  const TemporaryFolder folder;
  const std::string csv = folder / "run.csv";
  std::ofstream(csv) << "older\n";
  expectSentence(cliWithSmallFiles(16, shortSimulation({"--csv", csv})), "run.csv");
  EXPECT_EQ(contentOf(csv), "older\n");
  EXPECT_THAT(namesIn(folder.path()), testing::ElementsAre("run.csv"));
}

TEST(FullDisk, EndsARecordingThatStaysReadable)
{
  const TemporaryFolder folder;
  const std::string file = folder / "run.insertion";
  expectSentence(cliWithSmallFiles(200, shortSimulation({"--record", file})), "run.insertion");
  const ProgramOutcome read = cli({"replay", file, "--verify"});
  EXPECT_EQ(read.status, 0) << read.err;
  EXPECT_THAT(read.out, HasSubstr("not closed"));
}

TEST(FullDisk, RefusesARecordingThatCannotEvenBegin)
{
  const TemporaryFolder folder;
  const std::string file = folder / "run.insertion";
  expectSentence(cliWithSmallFiles(4, shortSimulation({"--record", file})), "run.insertion");
  EXPECT_THAT(namesIn(folder.path()), testing::IsEmpty());
}

TEST(FullDisk, IsSaidOfAStreamThatTakesNothing)
{
  expectSentence(cli(shortSimulation({"--json", "/dev/full"})), "/dev/full");
  expectSentence(cli({"anatomy", "--preset", "published", "--json", "/dev/full"}), "/dev/full");
}

/// perilymph-cli with its standard output on a full device.
ProgramOutcome cliOntoFullDevice(const std::vector<std::string>& arguments)
{
  std::vector<std::string> text = {"-c", "exec \"$@\" > /dev/full", "sh", cliCall({}).program};
  text.insert(text.end(), arguments.begin(), arguments.end());
  return run({"sh", text, {}, {}});
}

TEST(FullDisk, UnderStandardOutputIsSaidByEveryCommandThatPrints)
{
  const TemporaryFolder folder;
  const std::string recording = folder / "run.insertion";
  const std::string surface = folder / "scala.stl";
  ASSERT_EQ(cli(shortSimulation({"--record", recording})).status, 0);
  ASSERT_EQ(cli({"anatomy", "--preset", "published", "--surface", surface}).status, 0);
  const std::vector<std::vector<std::string>> calls = {
      shortSimulation(),
      {"anatomy", "--preset", "published"},
      {"anatomy", "--import", surface},
      {"replay", recording},
      {"replay", recording, "--verify"},
      {"compare", recording, "--out", folder / "compared"},
      {"render", "--preset", "published", "--view", "unrolled", "--out", folder / "x.png"},
      {"devices"},
      {"validate", "--runs", "2", "--set", "nodes=20", "--out", folder / "validated"},
      {"--help"},
      {"simulate", "--help"},
      {"--version"}};
  for (const auto& arguments : calls) {
    SCOPED_TRACE(testing::PrintToString(arguments));
    const ProgramOutcome outcome = cliOntoFullDevice(arguments);
    EXPECT_EQ(outcome.status, 1);
    if (lacksVtkFor(arguments)) {
      expectRefusal(outcome, "has no VTK");
      continue;
    }
    EXPECT_THAT(outcome.err, HasSubstr("Standard output did not take all"));
    EXPECT_THAT(outcome.err, HasSubstr("No space left on device"));
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
  }
}

TEST(FullDisk, UnderStandardOutputLeavesTheFilesThatWereAskedFor)
{
  const TemporaryFolder folder;
  const std::string json = folder / "run.json";
  EXPECT_EQ(cliOntoFullDevice(shortSimulation({"--json", json})).status, 1);
  EXPECT_THAT(contentOf(json), HasSubstr("peak_force_N"));
}

TEST(ClosedStreams, TakeNoFileOfTheProgram)
{
  const TemporaryFolder folder;
  ProgramCall call = cliCall({});
  call.arguments = {"-c", "exec \"$@\" <&- >&- 2>&-", "sh", call.program};
  for (const std::string& word :
       shortSimulation({"--csv", folder / "run.csv", "--record", folder / "run.insertion"}))
    call.arguments.push_back(word);
  call.program = "sh";
  EXPECT_EQ(run(call).status, 0);
  // no printed text is among the rows
  EXPECT_THAT(contentOf(folder / "run.csv"), testing::Not(HasSubstr("peak force")));
  EXPECT_EQ(cli({"replay", folder / "run.insertion", "--verify"}).status, 0);
}

TEST(FullDisk, OfASmallFileSystemIsSaidAndNothingElseBreaks)
{
  if (::geteuid() != 0) GTEST_SKIP() << "Only root may mount a file system of its own.";
  // A mount would be visible to other tests: use a separate mount namespace.
  const ProgramOutcome mount =
      run({"unshare", {"-m", "mount", "-t", "tmpfs", "-o", "size=300k", "none", "/mnt"}, {}, {}});
  if (mount.status != 0) GTEST_SKIP() << "No file system may be mounted here: " << mount.err;

  const std::string program = cliCall({}).program;
  const std::string text =
      "mount -t tmpfs -o size=300k none /mnt && cd /mnt && "
      "{ '" +
      program +
      "' simulate --scenario contour-published --nodes 30 "
      "--set stop_travel_mm=2 --record run.insertion; echo status $?; "
      "'" +
      program +
      "' simulate --scenario contour-published --nodes 30 "
      "--set stop_travel_mm=2 --csv run.csv; echo status $?; ls -a; "
      "'" +
      program + "' replay run.insertion; echo status $?; }";
  const ProgramOutcome outcome = run({"unshare", {"-m", "sh", "-c", text}, {}, {}});
  EXPECT_EQ(outcome.signal, 0);
  EXPECT_THAT(outcome.out, HasSubstr("status 1")) << outcome.err;
  EXPECT_THAT(outcome.err, HasSubstr("run.insertion can no longer be recorded"));
  EXPECT_THAT(outcome.err, HasSubstr("run.csv"));
  EXPECT_THAT(outcome.out, testing::Not(HasSubstr(".part")));
  // Content recorded before the disk was full can be read, on the full disk.
  EXPECT_THAT(outcome.out, testing::EndsWith("status 0\n")) << outcome.err;
}

}  // namespace
}  // namespace perilymph::test
