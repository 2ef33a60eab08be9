// SPDX-License-Identifier: BSD-3-Clause

// An insertion into tissue with 100 nodes, by a hand on a 10 kHz HID device, in virtual time: each
// report is one tick. How many ticks a real clock leaves time for: test/bench, row loop/10kHz.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "perilymph/session/Insertion.h"
#include "perilymph/test/TenKilohertzHand.h"
#include "perilymph/test/waitUntil.h"

namespace perilymph::session {
namespace {

TEST(AnInsertionAtTenKilohertz, AnswersEveryReportWithAHundredNodesInTissue)
{
  const auto scenario = loadScenario(
      "surgery-flex28",
      {{"dt_ms", "0.1"}, {"nodes", "100"}, {"coupling", "spring"}, {"friction", "tissue"}});
  ASSERT_TRUE(scenario) << scenario.error().message;
  test::TenKilohertzHand hand;
  auto device = hand.device();
  device::HidDevice& host = *device;
  auto insertion = Insertion::prepare(*scenario, std::move(device), std::nullopt);
  ASSERT_TRUE(insertion) << insertion.error().message;

  constexpr std::uint64_t ticks = 23'000;  // to 18 mm: the array buckles at 19
  std::uint64_t sequence = 0, missed = 0, stale = 0, unbalanced = 0;
  double peak = 0.0;
  haptics::TickRecord last;
  hand.report();
  const auto done = (*insertion)
                        ->runToEnd(
                            [&](const haptics::TickRecord& record) {
                              if (sequence != 0 && record.sample.sequence != sequence + 1) ++missed;
                              sequence = record.sample.sequence;
                              stale += (record.output.status & haptics::staleSample) != 0 ? 1 : 0;
                              unbalanced +=
                                  (record.output.status & haptics::notConverged) != 0 ? 1 : 0;
                              peak = std::max(peak, record.output.axialForce);
                              last = record;
                              // rests for half a second, then goes in by 10 um a millisecond
                              if (record.tick > 5'000 && record.tick % 10 == 0) ++hand.inward_10um;
                              hand.report();
                              return true;
                            },
                            ticks);
  ASSERT_TRUE(done) << done.error().message;
  // Virtual time continues while the writer, a real thread, waits for a processor.
  if (host.health()->blockedWrites > 0)
    GTEST_SKIP() << "This machine gave the writer's thread no time.";
  EXPECT_EQ(last.tick + 1, ticks);
  EXPECT_EQ(missed, 0u);
  EXPECT_EQ(stale, 0u);
  EXPECT_EQ(host.health()->reading.lost, 0u);
  EXPECT_EQ(last.output.workflow, haptics::Workflow::inserting);
  EXPECT_GT(last.output.depth, 15e-3);
  EXPECT_GT(peak, 5e-3);
  // The device has the force of the newest tick, in its steps of 1 mN.
  const double shown = std::round(last.output.wrench_D.force_D[2] * 1e3) * 1e-3;
  EXPECT_TRUE(test::waitUntil([&] {
    const auto forces = hand.hid.forces();
    return !forces.empty() && std::abs(forces.back()[2] - shown) <= 0.5e-3;
  })) << shown;
  EXPECT_EQ(unbalanced, 0u);
}

}  // namespace
}  // namespace perilymph::session
