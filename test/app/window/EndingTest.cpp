// SPDX-License-Identifier: BSD-3-Clause

// The end of the program by a signal: the recording is complete, and the next start does not
// mention it.

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>

#include <fstream>
#include <iterator>

#include "WindowRig.h"
#include "ownCall.h"
#include "perilymph/session/RecordedInsertion.h"
#include "perilymph/test/TemporaryFolder.h"

namespace perilymph::test {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;

/// Size of the write-ahead log after some hundreds of ticks [bytes].
constexpr std::uintmax_t enough = 200'000;

/// The program with temporary folders.
class TheWorkstation : public testing::Test {
protected:
  ProgramCall call(std::vector<std::string> arguments) const
  {
    return ownCall(folder_, std::move(arguments));
  }
  fs::path sessions() const { return folder_ / "XDG_DATA_HOME" / "perilymph" / "sessions"; }
  fs::path state() const { return folder_ / "XDG_STATE_HOME" / "perilymph"; }
  /// The recording, as soon as it contains some ticks.
  fs::path recording() const
  {
    std::error_code ignored;
    for (const auto& entry : fs::directory_iterator(sessions(), ignored))
      if (entry.path().extension() == ".insertion" &&
          fs::file_size(entry.path().string() + "-wal", ignored) > enough && !ignored)
        return entry.path();
    return {};
  }
  std::string log() const
  {
    std::ifstream stream(state() / "perilymph.log");
    return {std::istreambuf_iterator<char>(stream), {}};
  }
  std::vector<std::string> marks() const
  {
    std::vector<std::string> found;
    for (const auto& entry : fs::directory_iterator(state()))
      if (entry.path().filename().string().rfind("running-", 0) == 0)
        found.push_back(entry.path().filename().string());
    return found;
  }

  const TemporaryFolder folder_;
};

class TheWorkstationTold : public TheWorkstation, public testing::WithParamInterface<int> {};

TEST_P(TheWorkstationTold, ToEndClosesItsRecordingAndSaysNothingAtTheNextStart)
{
  const int signal = GetParam();
  ChildProcess program(call({"--demo"}));
  ASSERT_TRUE(program.waitForOutput("first frame after", 120s));
  ASSERT_TRUE(WindowRig::waitUntil([&] { return !recording().empty(); }));
  const fs::path kept = recording();
  program.send(signal);
  const ProgramOutcome outcome = program.wait(60s);
  EXPECT_EQ(outcome.status, 128 + signal) << "signal " << outcome.signal << " " << outcome.err;

  const auto recorded = session::RecordedInsertion::open(kept);
  ASSERT_TRUE(recorded) << recorded.error().message;
  EXPECT_TRUE(recorded->wasClosed());
  EXPECT_GT(recorded->ticks(), 100u);
  EXPECT_THAT(marks(), testing::IsEmpty());
  std::ifstream settings(folder_ / "XDG_CONFIG_HOME" / "perilymph" / "perilymph.ini");
  EXPECT_THAT(std::string(std::istreambuf_iterator<char>(settings), {}),
              testing::HasSubstr("geometry"));

  const auto next = run(call({"--screenshot", (folder_ / "next.png").string(), "--after", "0.5"}));
  EXPECT_EQ(next.status, 0) << next.err;
  EXPECT_THAT(log(), testing::Not(testing::HasSubstr("ended while it was writing")));
}

INSTANTIATE_TEST_SUITE_P(BySignal, TheWorkstationTold, testing::Values(SIGTERM, SIGINT, SIGHUP));

TEST_F(TheWorkstation, KilledOffersItsRecordingAtTheNextStart)
{
  ChildProcess program(call({"--demo"}));
  ASSERT_TRUE(program.waitForOutput("first frame after", 120s));
  ASSERT_TRUE(WindowRig::waitUntil([&] { return !recording().empty(); }));
  program.send(SIGKILL);
  program.wait(60s);
  EXPECT_THAT(marks(), testing::SizeIs(1));
  const auto next = run(call({"--screenshot", (folder_ / "next.png").string(), "--after", "3"}));
  EXPECT_EQ(next.status, 0) << next.err;
  EXPECT_THAT(log(), testing::HasSubstr("ended while it was writing"));
}

TEST_F(TheWorkstation, AtABoothEndsWhenTold)
{
  ChildProcess program(
      call({"--kiosk", "--screenshot", (folder_ / "k.png").string(), "--after", "3000"}));
  ASSERT_TRUE(WindowRig::waitUntil([&] { return log().find("perilymph") != std::string::npos; }));
  program.send(SIGTERM);
  EXPECT_EQ(program.wait(60s).signal, 0);
}

}  // namespace
}  // namespace perilymph::test
