// SIGINT, SIGTERM and SIGHUP: the first one ends every command, and nothing half-written is left.

#include <chrono>
#include <csignal>
#include <thread>

#include "Cli.h"
#include "perilymph/foundation/Resources.h"

namespace perilymph::test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::StartsWith;

constexpr auto soon = std::chrono::seconds(20);

/// Waits until the program has a handler for the signal; false if it ended without.
bool waitForHandler(const ChildProcess& child, int signal)
{
  const std::string place = "/proc/" + std::to_string(child.id()) + "/status";
  while (true) {
    std::ifstream status(place);
    std::string mask;
    for (std::string line; std::getline(status, line);)
      if (line.rfind("SigCgt:", 0) == 0) mask = line.substr(7);
    if (mask.empty()) return false;
    if ((std::stoull(mask, nullptr, 16) >> (signal - 1) & 1u) != 0) return true;
    std::this_thread::yield();
  }
}

/// Waits until the program has opened a file; false if it ended without.
bool waitUntilOpen(const ChildProcess& child, const fs::path& file)
{
  const fs::path place = "/proc/" + std::to_string(child.id()) + "/fd";
  while (true) {
    std::error_code failure;
    fs::directory_iterator entries(place, failure);
    if (failure) return false;
    for (const auto& entry : entries)
      if (fs::read_symlink(entry.path(), failure) == file) return true;
    std::this_thread::yield();
  }
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
};

TEST_F(InterruptedReplay, EndsOnTheFirstSignalWhileItVerifies)
{
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    ChildProcess child(cliCall({"replay", recording, "--verify"}));
    ASSERT_TRUE(waitUntilOpen(child, recording));
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
  while (namesIn(folder.path()).size() < 2) std::this_thread::yield();
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
  ASSERT_TRUE(waitUntilOpen(child, recording));
  child.send(SIGHUP);
  const auto outcome = child.wait(std::chrono::minutes(1));
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("every bit the same"));
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
      {"devices", "--plugin", PERILYMPH_EXAMPLE_PLUGIN, "--json", out}};
  for (const auto& call : calls) {
    SCOPED_TRACE(call.front());
    ChildProcess child(cliCall(call));
    ASSERT_TRUE(waitForHandler(child, SIGTERM));
    child.send(SIGTERM);
    const auto outcome = child.wait(soon);
    EXPECT_EQ(outcome.status, 1) << outcome.out;
    EXPECT_THAT(outcome.err, HasSubstr("Interrupted"));
    EXPECT_EQ(namesIn(folder.path()), std::vector<std::string>{"scala.stl"});
  }
}

TEST(InterruptedCommand, EndsAtOnceOnTheSecondSignal)
{
  const TemporaryFolder folder;
  ChildProcess child(cliCall({"validate", "--runs", "100000", "--out", folder / "out"}));
  ASSERT_TRUE(child.waitForOutput("Repeating", std::chrono::minutes(1)));
  child.send(SIGINT);
  child.send(SIGTERM);
  const auto outcome = child.wait(soon);
  EXPECT_EQ(outcome.status, 1);
  EXPECT_THAT(outcome.err, StartsWith("Interrupted"));
}

}  // namespace
}  // namespace perilymph::test
