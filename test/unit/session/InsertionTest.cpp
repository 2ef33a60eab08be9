// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/session/Insertion.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <chrono>
#include <csignal>
#include <thread>

#include "ShortScenario.h"
#include "perilymph/device/ScriptedDevice.h"
#include "perilymph/foundation/AtomicFile.h"
#include "perilymph/session/RecordedInsertion.h"
#include "perilymph/test/TemporaryFolder.h"
#include "perilymph/test/waitUntil.h"

namespace perilymph::session {
namespace {

using testing::HasSubstr;

std::unique_ptr<Insertion> prepared(const Scenario& scenario,
                                    std::optional<std::filesystem::path> record = std::nullopt)
{
  auto insertion = Insertion::prepare(
      scenario,
      std::make_unique<device::ScriptedDevice>(scenario.speed().si(), scenario.timeStep().si()),
      std::move(record));
  EXPECT_TRUE(insertion) << insertion.error().message;
  return std::move(*insertion);
}

TEST(InsertionInVirtualTime, EndsAtTheStopTravel)
{
  const Scenario scenario = test::shortScenario();
  haptics::TickRecord last;
  const auto ran = prepared(scenario)->runToEnd([&](const haptics::TickRecord& record) {
    last = record;
    return true;
  });
  ASSERT_TRUE(ran) << ran.error().message;
  EXPECT_EQ(last.output.workflow, haptics::Workflow::finished);
  // less than one tick's travel beyond it
  EXPECT_NEAR(last.output.travel, scenario.stopTravel().si(),
              scenario.speed().si() * scenario.timeStep().si());
  EXPECT_GE(last.output.time,
            scenario.stopTravel() / (1.0 * Length::fromSi(scenario.speed().si())) -
                2.0 * scenario.timeStep().si());
}

TEST(InsertionInVirtualTime, ComesBackWhenTheScenarioWithdraws)
{
  const Scenario scenario = test::shortScenario({{"withdraw", "true"}});
  double farthest = 0.0;
  haptics::TickRecord last;
  const auto ran = prepared(scenario)->runToEnd([&](const haptics::TickRecord& record) {
    farthest = std::max(farthest, record.output.travel);
    last = record;
    return true;
  });
  ASSERT_TRUE(ran) << ran.error().message;
  EXPECT_EQ(last.output.workflow, haptics::Workflow::finished);
  const double tickWay = scenario.speed().si() * scenario.timeStep().si();
  EXPECT_NEAR(farthest, scenario.stopTravel().si(), tickWay);
  EXPECT_NEAR(last.output.travel, 0.0, 2.0 * tickWay);
}

TEST(InsertionInVirtualTime, StopsWhenTheCallerHasSeenEnough)
{
  std::uint64_t seen = 0;
  const auto insertion = prepared(test::shortScenario());
  ASSERT_TRUE(insertion->runToEnd([&](const haptics::TickRecord&) { return ++seen < 10; }));
  EXPECT_EQ(seen, 10u);
  ASSERT_TRUE(insertion->runToEnd({}, 5));
  EXPECT_EQ(insertion->loop().statistics().ticks, 15u);
}

TEST(InsertionInVirtualTime, IsTheSameToTheLastBitEveryTime)
{
  const auto fingerprint = [] {
    const auto insertion = prepared(test::shortScenario());
    EXPECT_TRUE(insertion->runToEnd({}));
    return insertion->loop().engine().fingerprint();
  };
  EXPECT_EQ(fingerprint(), fingerprint());
}

TEST(RecordedInVirtualTime, HoldsEveryTickThatRan)
{
  const test::TemporaryFolder folder;
  std::uint64_t ran = 0;
  {
    const auto insertion = prepared(test::shortScenario(), folder / "run.insertion");
    ASSERT_TRUE(insertion->runToEnd([&](const haptics::TickRecord&) { return ++ran > 0; }));
    EXPECT_TRUE(insertion->closeRecording());
  }
  const auto recorded = RecordedInsertion::open(folder / "run.insertion");
  ASSERT_TRUE(recorded) << recorded.error().message;
  EXPECT_EQ(recorded->ticks(), ran);
  EXPECT_EQ(recorded->lostRecords(), 0u);
  EXPECT_TRUE(recorded->wasClosed());
  EXPECT_EQ(recorded->facts().device, "Scripted insertion");
}

TEST(PreparingAnInsertion, RefusesANameWithTheLogOfAFormerFile)
{
  const test::TemporaryFolder folder;
  for (const std::string ending : {"-wal", "-journal"}) {
    const auto log = folder / ("run.insertion" + ending);
    ASSERT_TRUE(writeWhole(log, "of a recording that was removed"));
    const auto refused = Insertion::prepare(test::shortScenario(),
                                            std::make_unique<device::ScriptedDevice>(2e-3, 1e-3),
                                            folder / "run.insertion");
    ASSERT_FALSE(refused);
    EXPECT_THAT(refused.error().message,
                testing::AllOf(HasSubstr(ending), HasSubstr("Move it away")));
    const auto kept = readWhole(log);
    EXPECT_TRUE(kept && *kept == "of a recording that was removed");
    EXPECT_FALSE(std::filesystem::exists(folder / "run.insertion"));
    std::filesystem::remove(log);
  }
}

TEST(PreparingAnInsertion, RefusesToRecordOverAFile)
{
  const test::TemporaryFolder folder;
  const Scenario scenario = test::shortScenario();
  prepared(scenario, folder / "run.insertion");
  const auto again = Insertion::prepare(
      scenario, std::make_unique<device::ScriptedDevice>(2e-3, 1e-3), folder / "run.insertion");
  ASSERT_FALSE(again);
  EXPECT_THAT(again.error().message, HasSubstr("never overwritten"));
}

TEST(PreparingAnInsertion, RefusesLongTimeStepsWithADeviceThatRendersForce)
{
  class Handle : public device::HapticDevice {
  public:
    device::DeviceTraits traits() const override
    {
      device::DeviceTraits traits;
      traits.name = "Handle";
      traits.rendersForce = true;
      traits.maxForce = 3.3;
      return traits;
    }
    Result<void> open() override { return {}; }
    void close() noexcept override {}
    device::DeviceSample read() noexcept override { return {}; }
    void write(const device::Wrench&) noexcept override {}
  };
  const auto slow = Insertion::prepare(test::shortScenario({{"dt_ms", "5"}}),
                                       std::make_unique<Handle>(), std::nullopt);
  ASSERT_FALSE(slow);
  EXPECT_THAT(slow.error().message, HasSubstr("at most 2"));
}

TEST(InsertionByTheClock, RunsRecordsAndStops)
{
  const test::TemporaryFolder folder;
  std::uint64_t ticks = 0;
  {
    const auto insertion = prepared(test::shortScenario(), folder / "clock.insertion");
    device::HapticDevice& hand = insertion->device();
    haptics::Command arm;
    arm.kind = haptics::Command::Kind::arm;
    ASSERT_TRUE(insertion->send(arm));
    hand.move(device::ScriptedDevice::Motion::insert);
    ASSERT_TRUE(insertion->start());  // armed in the first tick: none rests, which is not recorded
    ASSERT_TRUE(test::waitUntil([&] {
      insertion->refresh();
      return insertion->latest().output.workflow == haptics::Workflow::finished;
    }));
    insertion->stop();
    ticks = insertion->loop().statistics().ticks;
    EXPECT_EQ(insertion->recordingError(), "");
  }
  const auto recorded = RecordedInsertion::open(folder / "clock.insertion");
  ASSERT_TRUE(recorded) << recorded.error().message;
  EXPECT_EQ(recorded->ticks() + recorded->lostRecords(), ticks);
  EXPECT_TRUE(recorded->wasClosed());
}

TEST(InsertionByTheClock, IsARecordingOnceItHasEndedAndAWithdrawalIsAddedToIt)
{
  const test::TemporaryFolder folder;
  const std::filesystem::path file = folder / "clock.insertion";
  const auto insertion = prepared(test::shortScenario(), file);
  ASSERT_TRUE(insertion->start());
  const auto send = [&](haptics::Command::Kind kind) {
    haptics::Command command;
    command.kind = kind;
    return insertion->send(command);
  };
  const auto hasFinished = [&] {
    insertion->refresh();
    return insertion->latest().output.workflow == haptics::Workflow::finished;
  };
  const auto isResting = [&] {
    insertion->refresh();
    return (insertion->latest().output.status & haptics::resting) != 0;
  };
  const auto ticksOfClosed = [&]() -> std::uint64_t {
    const auto recorded = RecordedInsertion::open(file);
    EXPECT_TRUE(recorded) << recorded.error().message;
    if (!recorded) return 0;
    EXPECT_TRUE(recorded->wasClosed());
    EXPECT_EQ(recorded->check()->damage, "");
    return recorded->ticks();
  };
  ASSERT_TRUE(send(haptics::Command::Kind::arm));
  insertion->device().move(device::ScriptedDevice::Motion::insert);
  ASSERT_TRUE(test::waitUntil(hasFinished));
  insertion->device().move(device::ScriptedDevice::Motion::hold);
  ASSERT_TRUE(test::waitUntil(isResting));
  EXPECT_FALSE(insertion->isRecordingConcluded());
  insertion->concludeRecording();
  ASSERT_TRUE(test::waitUntil([&] { return insertion->isRecordingConcluded(); }));
  const std::uint64_t inserted = ticksOfClosed();
  EXPECT_GT(inserted, 0u);

  ASSERT_TRUE(send(haptics::Command::Kind::withdraw));
  insertion->device().move(device::ScriptedDevice::Motion::withdraw);
  ASSERT_TRUE(test::waitUntil([&] { return !insertion->isRecordingConcluded(); }));
  ASSERT_TRUE(test::waitUntil(hasFinished));
  insertion->stop();
  EXPECT_TRUE(insertion->closeRecording());
  EXPECT_GT(ticksOfClosed(), inserted);
  EXPECT_EQ(insertion->recordingError(), "");
}

TEST(ARecordingDeletedWhileItIsWritten, IsReportedAndTheInsertionGoesOn)
{
  const test::TemporaryFolder folder;
  const auto insertion = prepared(test::shortScenario(), folder / "gone.insertion");
  ASSERT_TRUE(insertion->start());
  haptics::Command arm;
  arm.kind = haptics::Command::Kind::arm;
  ASSERT_TRUE(insertion->send(arm));
  std::filesystem::remove(folder / "gone.insertion");
  ASSERT_TRUE(test::waitUntil([&] { return !insertion->recordingError().empty(); }));
  EXPECT_THAT(insertion->recordingError(), HasSubstr("gone.insertion was moved or deleted"));
  const std::uint64_t before = insertion->latest().tick;
  ASSERT_TRUE(test::waitUntil([&] {
    insertion->refresh();
    return insertion->latest().tick >= before + 10;
  }));
  insertion->stop();
  const auto closed = insertion->closeRecording();
  ASSERT_FALSE(closed);
  EXPECT_EQ(closed.error().message, insertion->recordingError());
}

TEST(FailingDisk, EndsTheRecordingAndNotTheInsertion)
{
  const test::TemporaryFolder folder;
  // Files of this process may grow to 200 kB, like on a full disk.
  ASSERT_NE(std::signal(SIGXFSZ, SIG_IGN), SIG_ERR);
  rlimit usual{};
  ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &usual), 0);
  rlimit small = usual;
  small.rlim_cur = 200'000;

  const auto insertion =
      prepared(test::shortScenario({{"stop_travel_mm", "2"}}), folder / "full.insertion");
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &small), 0);
  haptics::TickRecord last;
  const auto ran = insertion->runToEnd([&](const haptics::TickRecord& record) {
    last = record;
    return true;
  });
  const std::string error = insertion->recordingError();
  const auto closed = insertion->closeRecording();
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &usual), 0);

  EXPECT_TRUE(ran);
  EXPECT_EQ(last.output.workflow, haptics::Workflow::finished);
  EXPECT_THAT(error, HasSubstr("full.insertion"));
  ASSERT_FALSE(closed);
  EXPECT_EQ(closed.error().message, error);
  const auto recorded = RecordedInsertion::open(folder / "full.insertion");
  ASSERT_TRUE(recorded) << recorded.error().message;
  EXPECT_GT(recorded->ticks(), 0u);
  EXPECT_LT(recorded->ticks(), last.tick);
  EXPECT_EQ(recorded->ticks() % 20, 0u);  // complete drains only
  // There may be space to close the recording, but not for these ticks: they are missing.
  EXPECT_FALSE(recorded->wasClosed());
}

}  // namespace
}  // namespace perilymph::session
