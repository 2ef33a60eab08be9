// SPDX-License-Identifier: BSD-3-Clause

// The loop in its thread, paced by the clock. No result depends on the speed of the machine.

#include <gtest/gtest.h>

#include <thread>

#include "perilymph/haptics/HapticLoop.h"
#include "perilymph/test/InsertionRig.h"
#include "perilymph/test/PlainModels.h"
#include "perilymph/test/waitUntil.h"

namespace perilymph::haptics {
namespace {

using device::ScriptedDevice;
using Kind = Command::Kind;

/// Reads snapshots until one fulfills the condition and returns it.
template <class Pleases>
const Snapshot& waitFor(HapticLoop& loop, Pleases pleases)
{
  EXPECT_TRUE(test::waitUntil([&] { return loop.refresh() && pleases(loop.latest()); }));
  return loop.latest();
}

TEST(RunningLoop, InsertsByTheClockAndGivesEveryTickToTheRecorder)
{
  test::InsertionRig rig(test::insertionInTube(), {}, millimetersPerSecond(20));
  HapticLoop& loop = rig.loop();
  rig.start();
  loop.start();
  const std::uint64_t seen =
      waitFor(loop, [](const Snapshot& now) { return now.output.travel > 2e-3; }).tick;
  loop.stop();

  std::uint64_t expected = 0;
  TickRecord record;
  while (loop.take(record)) ASSERT_EQ(record.tick, expected++);
  const LoopStatistics statistics = loop.statistics();
  EXPECT_EQ(expected + statistics.lostRecords, statistics.ticks);
  EXPECT_GT(statistics.ticks, seen);
  EXPECT_GT(statistics.tickTimeMedian, 0.0);
  EXPECT_LE(statistics.tickTimeMedian, statistics.tickTimeP99);
  EXPECT_LE(statistics.tickTimeP99, statistics.tickTimeMax);
}

TEST(RunningLoop, ReplaysItsRecordInVirtualTimeBitForBit)
{
  const auto model = test::insertionInRing();
  test::InsertionRig rig(model, {}, millimetersPerSecond(20));
  HapticLoop& loop = rig.loop();
  rig.start();
  loop.start();
  waitFor(loop, [](const Snapshot& now) { return now.output.travel > 4e-3; });
  Command pull;
  pull.kind = Kind::withdraw;
  ASSERT_TRUE(test::waitUntil([&] { return loop.send(pull); }));
  rig.device().move(ScriptedDevice::Motion::withdraw);
  waitFor(loop, [](const Snapshot& now) { return now.output.travel < 3e-3; });
  loop.stop();

  InsertionEngine again(model, {});
  TickRecord record;
  while (loop.take(record)) {
    const TickOutput output = again.tick(record.sample, record.commands);
    ASSERT_EQ(output.force_W, record.output.force_W) << record.tick;
    ASSERT_EQ(output.wrench_D.force_D, record.output.wrench_D.force_D) << record.tick;
  }
  EXPECT_EQ(again.fingerprint(), loop.engine().fingerprint());
}

TEST(RunningLoop, TellsItsRateOnceASecondHasPassed)
{
  test::InsertionRig rig(test::insertionInTube());
  rig.loop().start();
  const Snapshot& picture =
      waitFor(rig.loop(), [](const Snapshot& now) { return now.measuredRate > 0.0; });
  EXPECT_LE(picture.measuredRate, 1100.0);  // no bursts
  rig.loop().stop();
}

TEST(RunningLoop, StartsAndStopsAgainAndAgain)
{
  test::InsertionRig rig(test::insertionInTube());
  for (int i = 0; i < 5; ++i) {
    const std::uint64_t before = rig.loop().statistics().ticks;
    rig.loop().start();
    rig.loop().start();  // a second start changes nothing
    waitFor(rig.loop(), [before](const Snapshot& now) { return now.tick > before; });
    rig.loop().stop();
    rig.loop().stop();
  }
  EXPECT_GT(rig.loop().statistics().ticks, 5u);
}

}  // namespace
}  // namespace perilymph::haptics
