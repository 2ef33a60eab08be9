// SPDX-License-Identifier: BSD-3-Clause

// Changes of the time of day during an insertion: manual, by NTP, by daylight saving time.

#include <gtest/gtest.h>

#include <ctime>
#include <functional>
#include <string>
#include <thread>
#include <vector>

#include "JumpingClock.h"
#include "perilymph/device/ScriptedDevice.h"
#include "perilymph/session/Insertion.h"
#include "perilymph/session/RecordedInsertion.h"
#include "perilymph/session/Replay.h"
#include "perilymph/session/SessionLibrary.h"
#include "perilymph/test/TemporaryFolder.h"
#include "perilymph/test/waitUntil.h"

namespace perilymph::session {
namespace {

namespace fs = std::filesystem;

constexpr long hour = 3600;

Scenario shortScenario()
{
  auto scenario = loadScenario("contour-published", {{"nodes", "20"}, {"stop_travel_mm", "0.4"}});
  EXPECT_TRUE(scenario);
  return *scenario;
}

/// Runs an insertion by the clock into a file; `meanwhile` is called while it moves.
void runByTheClock(const fs::path& file, const std::function<void(double)>& meanwhile)
{
  const Scenario scenario = shortScenario();
  auto insertion = Insertion::prepare(
      scenario, std::make_unique<device::ScriptedDevice>(scenario.speed().si(), 1e-3), file);
  ASSERT_TRUE(insertion) << insertion.error().message;
  ASSERT_TRUE((*insertion)->start());
  haptics::Command arm;
  arm.kind = haptics::Command::Kind::arm;
  ASSERT_TRUE((*insertion)->send(arm));
  (*insertion)->device().move(device::ScriptedMotion::insert);
  ASSERT_TRUE(test::waitUntil([&] {
    (*insertion)->refresh();
    meanwhile((*insertion)->latest().output.travel);
    return (*insertion)->latest().output.workflow == haptics::Workflow::finished;
  }));
  (*insertion)->stop();
  EXPECT_EQ((*insertion)->recordingError(), "");
}

class ClockThatJumps : public testing::Test {
protected:
  ~ClockThatJumps() override { test::setTimeOfDay(0); }
  const test::TemporaryFolder folder;
};

TEST_F(ClockThatJumps, IsSeenByThisProgram)
{
  const std::time_t before = std::time(nullptr);
  test::setTimeOfDay(-hour);
  const std::time_t after = std::time(nullptr);
  EXPECT_LT(after, before);
  EXPECT_GT(test::timeOfDayRequested(), 0);
}

TEST_F(ClockThatJumps, LeavesEveryTickItsPlaceAndItsTime)
{
  const fs::path file = folder / "jumps.insertion";
  runByTheClock(file, [](double travel) {
    // back an hour in the middle, forward a day near the end
    test::setTimeOfDay(travel < 0.1e-3 ? 0 : travel < 0.3e-3 ? -hour : 24 * hour);
  });
  const auto recorded = RecordedInsertion::open(file);
  ASSERT_TRUE(recorded) << recorded.error().message;
  EXPECT_EQ(recorded->lostRecords(), 0u);
  EXPECT_TRUE(recorded->wasClosed());
  std::uint64_t next = 0;
  double time = 0.0;
  double arrived = 0.0;
  ASSERT_TRUE(recorded->forEach([&](const haptics::TickRecord& record) {
    EXPECT_EQ(record.tick, next++);
    EXPECT_GE(record.output.time, time);
    EXPECT_LE(record.output.time, time + 1.001e-3);  // a tick is a millisecond, whatever the date
    time = record.output.time;
    if (record.output.workflow != haptics::Workflow::finished) arrived = time;
    return true;
  }));
  EXPECT_NEAR(arrived, 0.2, 0.01);  // 0.4 mm at 2 mm/s, a few ticks for the start
  const auto verified = verify(file);
  ASSERT_TRUE(verified) << verified.error().message;
  EXPECT_TRUE(verified->isIdentical);
}

TEST_F(ClockThatJumps, GivesSessionsTheirTimesAndKeepsThemAll)
{
  runByTheClock(folder / "first.insertion", [](double) {});
  test::setTimeOfDay(-hour);
  runByTheClock(folder / "second.insertion", [](double) {});
  const auto sessions = listSessions(folder.path());
  ASSERT_TRUE(sessions) << sessions.error().message;
  ASSERT_EQ(sessions->size(), 2u);
  // Newest first, by the clock at their start.
  EXPECT_EQ((*sessions)[0].file.filename(), "first.insertion");
  EXPECT_EQ((*sessions)[1].file.filename(), "second.insertion");
  for (const SessionSummary& session : *sessions) {
    EXPECT_EQ(session.error, "");
    // 0.4 mm at 2 mm/s, plus the time until it was stopped; not an hour.
    EXPECT_GE(session.highlights.duration, 0.19);
    EXPECT_LT(session.highlights.duration, 60.0);
  }
}

TEST_F(ClockThatJumps, FarBeforeTheFirstComputersStillGivesAName)
{
  test::setTimeOfDay(-60L * 365 * 24 * hour);
  runByTheClock(folder / "early.insertion", [](double) {});
  const auto recorded = RecordedInsertion::open(folder / "early.insertion");
  ASSERT_TRUE(recorded) << recorded.error().message;
  EXPECT_EQ(recorded->facts().startedUtc.substr(0, 3), "196");
}

}  // namespace
}  // namespace perilymph::session
