// SPDX-License-Identifier: BSD-3-Clause

// SIGINT, SIGTERM and SIGHUP: the first one ends every command and leaves no partial file.

#include <chrono>
#include <csignal>
#include <functional>
#include <thread>

#include "perilymph/foundation/Resources.h"
#include "perilymph/test/Cli.h"
#include "perilymph/test/Places.h"
#include "perilymph/test/waitUntil.h"

namespace perilymph::test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::StartsWith;

constexpr auto soon = std::chrono::seconds(20);

/// Runs the program with a signal that was sent before its start: it is blocked and stays pending
/// until the program handles signals. No result depends on the speed of a command.
ProgramOutcome runWithEarlySignal(ProgramCall call, int signal)
{
  std::vector<std::string> arguments = {"-c", "kill -s \"$0\" $$; exec \"$@\"",
                                        std::to_string(signal), call.program};
  arguments.insert(arguments.end(), call.arguments.begin(), call.arguments.end());
  call.program = "sh";
  call.arguments = std::move(arguments);
  sigset_t blocked;
  sigset_t before;
  sigemptyset(&blocked);
  sigaddset(&blocked, signal);
  pthread_sigmask(SIG_BLOCK, &blocked, &before);
  const auto outcome = run(call, soon);
  pthread_sigmask(SIG_SETMASK, &before, nullptr);
  return outcome;
}

/// Waits until the program has opened such a file; false if it ended first.
template <typename Predicate>
bool waitUntilOpen(const ChildProcess& child, Predicate isIt)
{
  const fs::path place = "/proc/" + std::to_string(child.id()) + "/fd";
  bool isOpen = false;
  const bool isOver = waitUntil([&] {
    std::error_code failure;
    fs::directory_iterator entries(place, failure);
    if (failure) return true;
    for (const auto& entry : entries)
      if (isIt(fs::read_symlink(entry.path(), failure))) isOpen = true;
    return isOpen;
  });
  return isOver && isOpen;
}

class InterruptedReplay : public testing::Test {
protected:
  void SetUp() override
  {
    // ten thousand ticks: long enough to be interrupted in the middle
    ASSERT_EQ(cli(shortSimulation({"--set", "speed_mm_s=0.05", "--record", recording})).status, 0);
  }
  const TemporaryFolder folder;
  const std::string recording = folder / "run.insertion";
  const std::function<bool(const fs::path&)> isRecording = [this](const fs::path& file) {
    return file == recording;
  };
};

TEST_F(InterruptedReplay, EndsOnTheFirstSignalWhileItVerifies)
{
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    ChildProcess child(cliCall({"replay", recording, "--verify"}));
    ASSERT_TRUE(waitUntilOpen(child, isRecording));
    child.send(signal);
    const auto outcome = child.wait(soon);
    EXPECT_EQ(outcome.status, 1) << outcome.out;
    EXPECT_THAT(outcome.err, StartsWith("Interrupted")) << signal;
    EXPECT_EQ(outcome.out, "");
  }
}

TEST_F(InterruptedReplay, LeavesNoHalfTable)
{
  ChildProcess child(cliCall({"replay", recording, "--csv", folder / "rows.csv"}));
  ASSERT_TRUE(waitUntilOpen(child, [this](const fs::path& file) {
    return file.parent_path() == folder.path() && !isRecording(file);
  }));
  child.send(SIGTERM);
  const auto outcome = child.wait(soon);
  EXPECT_EQ(outcome.status, 1);
  EXPECT_THAT(outcome.err, StartsWith("Interrupted"));
  EXPECT_EQ(namesIn(folder.path()), std::vector<std::string>{"run.insertion"});
}

TEST_F(InterruptedReplay, OfAJobThatIgnoresHangupsGoesOn)
{
  ProgramCall call = cliCall({});
  call.arguments = {"-c",      "trap '' HUP; exec \"$@\"", "sh", call.program, "replay", recording,
                    "--verify"};
  call.program = "sh";
  ChildProcess child(call);
  ASSERT_TRUE(waitUntilOpen(child, isRecording));
  child.send(SIGHUP);
  const auto outcome = child.wait(std::chrono::minutes(1));
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("Replay verified"));
}

TEST(InterruptedCommand, EndsSoonAndLeavesNothing)
{
  const TemporaryFolder folder;
  const std::string out = folder / "out";
  const std::string surface = folder / "scala.stl";
  ASSERT_EQ(cli({"anatomy", "--preset", "published", "--surface", surface}).status, 0);
  const std::vector<std::vector<std::string>> calls = {
      {"simulate", "--scenario", "contour-published", "--csv", out},
      {"anatomy", "--import", surface, "--json", out},
      {"validate", "--out", out},
      {"calibrate", "--out", out},
      {"predict", "--array", "contour", "--out", out},
      {"render", "--scenario", "contour-published", "--view", "unrolled", "--out", out + ".png"},
      {"devices", "--plugin", examplePlugin(), "--json", out}};
  for (const auto& call : calls) {
    SCOPED_TRACE(call.front());
    const auto outcome = runWithEarlySignal(cliCall(call), SIGTERM);
    EXPECT_EQ(outcome.status, 1) << outcome.out;
    EXPECT_THAT(outcome.err, HasSubstr("Interrupted"));
    EXPECT_EQ(namesIn(folder.path()), std::vector<std::string>{"scala.stl"});
  }
}

TEST(InterruptedCommand, EndsAtOnceOnTheSecondSignal)
{
  const TemporaryFolder folder;
  ChildProcess child(cliCall({"validate", "--runs", "100000", "--out", folder / "out"}));
  ASSERT_TRUE(child.waitForOutput("Simulating", std::chrono::minutes(1)));
  child.send(SIGINT);
  child.send(SIGTERM);
  const auto outcome = child.wait(soon);
  EXPECT_EQ(outcome.status, 1);
  EXPECT_THAT(outcome.err, StartsWith("Interrupted"));
}

}  // namespace
}  // namespace perilymph::test
