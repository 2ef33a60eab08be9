// SPDX-License-Identifier: BSD-3-Clause

// A long day: insertion after insertion, recorded, with nothing lost, nothing growing, and the last
// the same as the first, to the bit.

#include <gtest/gtest.h>
#include <unistd.h>

#include <bit>
#include <cstdlib>
#include <deque>
#include <fstream>
#include <optional>
#include <string>

#include "PacedDevice.h"
#include "perilymph/foundation/Hash.h"
#include "perilymph/session/Csv.h"
#include "perilymph/session/Insertion.h"
#include "perilymph/session/RecordedInsertion.h"
#include "perilymph/session/Replay.h"
#include "perilymph/test/AllocationGuard.h"
#include "perilymph/test/TemporaryFolder.h"

namespace perilymph::session {
namespace {

namespace fs = std::filesystem;
using test::PacedDevice;

constexpr int restTicks = 20;  // before an insertion
constexpr std::size_t sessionsKept = 3;
// A thousandth of what a leak of one record a tick would be after eight hours. What the heap and
// SQLite keep at hand changes by some pages.
constexpr long maxGrowth_KiB = 2048;

std::uint64_t ticksWanted()
{
  const char* asked = std::getenv("PERILYMPH_SOAK_TICKS");
  return asked != nullptr ? std::stoull(asked) : std::uint64_t{SOAK_TICKS};
}

/// Memory of this process that is really there.
long residentMemory_KiB()
{
  long all = 0, resident = 0;
  std::ifstream("/proc/self/statm") >> all >> resident;
  return resident * (::sysconf(_SC_PAGESIZE) / 1024);
}

/// One insertion, in and out again, as it comes out of the loop.
class Cycle {
public:
  void add(const haptics::TickRecord& record)
  {
    for (const double value : columnValues(record)) hash_.add(std::bit_cast<std::uint64_t>(value));
    for (const double part : record.output.wrench_D.force_D)
      hash_.add(std::bit_cast<std::uint64_t>(part));
    hash_.add(record.output.status);
    hash_.add(record.output.iterations);
    hash_.add(std::bit_cast<std::uint64_t>(record.output.residual));
  }
  std::uint64_t bits() const { return hash_.value(); }

private:
  Hash hash_;
};

class Soak : public testing::Test {
protected:
  void SetUp() override
  {
    auto read = loadScenario(
        "contour-published",
        {{"nodes", SOAK_NODES}, {"stop_travel_mm", SOAK_TRAVEL_MM}, {"withdraw", "true"}});
    ASSERT_TRUE(read) << read.error().message;
    scenario = *read;
    auto built = buildAnatomy(scenario);
    ASSERT_TRUE(built) << built.error().message;
    anatomy = *built;
  }

  /// In to the stop, out, home; false where something went wrong.
  bool runCycle(Insertion& insertion, Cycle& cycle)
  {
    auto& hand = dynamic_cast<PacedDevice&>(insertion.device());
    std::uint64_t ticks = 0;
    const auto count = [&ticks](const haptics::TickRecord&) { return ++ticks > 0; };
    for (int i = 0; i < restTicks; ++i)
      if (!insertion.runToEnd(count, 1)) return false;

    hand.go(PacedDevice::Direction::in);
    bool isOut = false;
    const auto ran = insertion.runToEnd([&](const haptics::TickRecord& record) {
      cycle.add(record);
      ++ticks;
      if (record.output.workflow != haptics::Workflow::finished) return true;
      if (isOut) return false;
      // The withdrawal that the scenario asks for is sent at the stop.
      isOut = true;
      hand.go(PacedDevice::Direction::out);
      return true;
    });
    if (!ran) ADD_FAILURE() << ran.error().message;
    if (!ran || !isOut) return false;

    hand.go(PacedDevice::Direction::home);
    while (!hand.isHome())
      if (!insertion.runToEnd(count, 1)) return false;
    ticksRun += ticks;
    ticksOfSession += ticks;
    return true;
  }

  void checkRecording(const fs::path& file)
  {
    const auto recorded = RecordedInsertion::open(file);
    ASSERT_TRUE(recorded) << recorded.error().message;
    EXPECT_EQ(recorded->ticks(), ticksOfSession);
    EXPECT_EQ(recorded->lostRecords(), 0u);
    EXPECT_TRUE(recorded->wasClosed());
  }

  Scenario scenario;
  std::shared_ptr<const anatomy::ScalaTympani> anatomy;
  std::uint64_t ticksRun = 0, ticksOfSession = 0;
};

TEST_F(Soak, EndsAsItBegan)
{
  const test::TemporaryFolder folder;
  const std::uint64_t wanted = ticksWanted();
  std::deque<fs::path> kept;
  std::optional<std::uint64_t> first;
  long memoryBefore_KiB = 0;
  std::uint64_t sessions = 0;

  while (ticksRun < wanted && !HasFailure()) {
    const fs::path file = folder / ("session-" + std::to_string(sessions) + ".insertion");
    auto insertion = Insertion::prepare(
        scenario, std::make_unique<PacedDevice>(scenario.speed().si() * scenario.timeStep().si()),
        file, anatomy);
    ASSERT_TRUE(insertion) << insertion.error().message;
    ticksOfSession = 0;
    Cycle cycle;
    ASSERT_TRUE(runCycle(**insertion, cycle)) << "session " << sessions;
    if (!first) first = cycle.bits();
    ASSERT_EQ(cycle.bits(), *first) << "session " << sessions << " differs from the first";
    ASSERT_TRUE((*insertion)->closeRecording());
    EXPECT_EQ((*insertion)->loop().statistics().lostRecords, 0u);
    insertion->reset();
    checkRecording(file);
    kept.push_back(file);
    if (kept.size() > sessionsKept) {
      fs::remove(kept.front());
      kept.pop_front();
    }
    if (++sessions == 2) memoryBefore_KiB = residentMemory_KiB();
  }

  const long growth_KiB = residentMemory_KiB() - memoryBefore_KiB;
  std::printf("%llu ticks, %llu recorded insertions, memory grown by %ld KiB\n",
              static_cast<unsigned long long>(ticksRun), static_cast<unsigned long long>(sessions),
              growth_KiB);
  EXPECT_GE(ticksRun, wanted);
  ASSERT_GE(sessions, 2u);
  // Sanitizers keep what was freed for a while.
  if (test::AllocationGuard::isAvailable()) {
    EXPECT_LE(growth_KiB, maxGrowth_KiB);
  }

  const auto verified = verify(kept.back());
  ASSERT_TRUE(verified) << verified.error().message;
  EXPECT_TRUE(verified->isIdentical);
}

}  // namespace
}  // namespace perilymph::session
