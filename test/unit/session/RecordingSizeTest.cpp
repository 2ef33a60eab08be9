// SPDX-License-Identifier: BSD-3-Clause

// What a recording takes on the disk and in memory, over an hour too.

#include <gtest/gtest.h>
#include <unistd.h>

#include <chrono>
#include <cmath>
#include <fstream>
#include <numbers>
#include <random>

#include "perilymph/device/ScriptedDevice.h"
#include "perilymph/session/Insertion.h"
#include "perilymph/session/RecordedInsertion.h"
#include "perilymph/session/Scenario.h"
#include "perilymph/test/AllocationGuard.h"
#include "perilymph/test/OddRecords.h"
#include "perilymph/test/TemporaryFolder.h"

namespace perilymph::session {
namespace {

namespace fs = std::filesystem;

constexpr double ticksOfAnHour = 3.6e6;  // at 1 kHz
constexpr double maxHour_bytes = 0.5e9;

/// A hand that holds a haptic device: it moves in at an even speed, with a tremor of 9 Hz and 0.1 mm
/// (physiological: 8 to 12 Hz) on each axis and the noise of the sensor, in steps of 10 um.
class TremblingHand final : public device::HapticDevice {
public:
  explicit TremblingHand(double speed) : speed_(speed) {}

  device::DeviceTraits traits() const override
  {
    device::DeviceTraits traits;
    traits.name = "Trembling hand";
    traits.rendersForce = true;
    traits.maxForce = 3.3;
    traits.actuatedTranslations = 3;
    traits.workspaceRadius = 0.08;
    traits.maxStiffness = 1000.0;
    return traits;
  }
  Result<void> open() override { return {}; }
  void close() noexcept override {}
  device::DeviceSample read() noexcept override
  {
    const double time = 1e-3 * static_cast<double>(++ticks_);
    device::DeviceSample sample;
    sample.sequence = ticks_;
    sample.buttons = device::graspButton;
    sample.isValid = 1;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double phase = 2.0 * std::numbers::pi * (9.0 * time + static_cast<double>(axis) / 3.0);
      const double place =
          1e-4 * std::sin(phase) + 2e-6 * noise_(random_) - (axis == 2 ? speed_ * time : 0.0);
      constexpr double quantum = 1e-5;
      sample.position_D[axis] = quantum * std::round(place / quantum);
    }
    return sample;
  }
  void write(const device::Wrench&) noexcept override {}

private:
  double speed_;
  std::uint64_t ticks_ = 0;
  std::mt19937_64 random_{9};
  std::normal_distribution<double> noise_;
};

/// Ticks of an insertion in virtual time, recorded into a file unless that is empty.
std::vector<haptics::TickRecord> insert(const std::string& name, bool isByHand,
                                        const fs::path& file, const Overrides& overrides = {})
{
  const auto scenario = loadScenario(name, overrides);
  EXPECT_TRUE(scenario) << scenario.error().message;
  std::shared_ptr<device::HapticDevice> device;
  if (isByHand)
    device = std::make_shared<TremblingHand>(scenario->speed().si());
  else
    device =
        std::make_shared<device::ScriptedDevice>(scenario->speed().si(), scenario->timeStep().si());
  const auto insertion = Insertion::prepare(
      *scenario, device, file.empty() ? std::nullopt : std::optional<fs::path>(file));
  EXPECT_TRUE(insertion) << insertion.error().message;
  std::vector<haptics::TickRecord> records;
  EXPECT_TRUE((*insertion)
                  ->runToEnd(
                      [&records](const haptics::TickRecord& record) {
                        records.push_back(record);
                        return true;
                      },
                      10'000));
  EXPECT_TRUE((*insertion)->closeRecording());
  return records;
}

class RecordingOfAnInsertion : public testing::TestWithParam<std::pair<const char*, bool>> {};

TEST_P(RecordingOfAnInsertion, TakesAtMostHalfAGigabyteAnHour)
{
  const auto& [scenario, isByHand] = GetParam();
  const test::TemporaryFolder folder;
  const fs::path file = folder / "some.insertion";
  const auto records = insert(scenario, isByHand, file);
  ASSERT_GT(records.size(), 5000u);
  const double bytes =
      static_cast<double>(fs::file_size(file)) / static_cast<double>(records.size());
  std::printf("%s%s: %.1f bytes a tick, %.3f GB an hour\n", scenario, isByHand ? " by hand" : "",
              bytes, bytes * ticksOfAnHour * 1e-9);
  RecordProperty("bytes_a_tick", static_cast<int>(std::lround(bytes)));
  EXPECT_LT(bytes * ticksOfAnHour, maxHour_bytes);
}

INSTANTIATE_TEST_SUITE_P(OfThePublishedScenarioAndByHand, RecordingOfAnInsertion,
                         testing::Values(std::pair("contour-published", false),
                                         std::pair("contour-published", true),
                                         std::pair("surgery-flex28", false),
                                         std::pair("surgery-flex28", true)));

long residentMemory_KiB()
{
  long all = 0, resident = 0;
  std::ifstream("/proc/self/statm") >> all >> resident;
  return resident * (::sysconf(_SC_PAGESIZE) / 1024);
}

/// In drains of 20 ticks, as the recorder writes them; the ticks of an insertion in and out again and
/// again.
TEST(RecordingOfAnHour, TakesNoMoreMemoryThanAMinute)
{
  const auto once = insert("contour-published", true, {}, {{"stop_travel_mm", "8"}});
  ASSERT_GT(once.size(), 3000u);
  const test::TemporaryFolder folder;
  const fs::path file = folder / "hour.insertion";
  constexpr std::uint64_t ticks = 3'600'000, minute = 60'000, drain = 20;
  long afterAMinute_KiB = 0;
  const auto began = std::chrono::steady_clock::now();
  {
    auto recording = Recording::create(file, test::someFacts());
    ASSERT_TRUE(recording) << recording.error().message;
    std::vector<haptics::TickRecord> waiting;
    for (std::uint64_t tick = 0; tick < ticks; ++tick) {
      const std::uint64_t place = tick % (2 * once.size());
      haptics::TickRecord record = once[place < once.size() ? place : 2 * once.size() - 1 - place];
      record.tick = tick;
      record.sample.sequence = tick;
      record.output.time = 1e-3 * static_cast<double>(tick);
      waiting.push_back(record);
      if (waiting.size() < drain) continue;
      ASSERT_TRUE((*recording)->append(waiting));
      waiting.clear();
      if (tick + 1 == minute) afterAMinute_KiB = residentMemory_KiB();
    }
    const long growth_KiB = residentMemory_KiB() - afterAMinute_KiB;
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - began;
    std::printf("written: %.1f s, %.1f us a tick, memory grown by %ld KiB since the first minute\n",
                took.count(), took.count() * 1e6 / static_cast<double>(ticks), growth_KiB);
    if (test::AllocationGuard::isAvailable()) {  // sanitizers keep what was freed for a while
      EXPECT_LE(growth_KiB, 2048);  // what the heap and SQLite keep at hand changes by some pages
    }
    ASSERT_TRUE((*recording)->close());
  }
  const double bytes = static_cast<double>(fs::file_size(file));
  std::printf("%.3f GB, %.1f bytes a tick\n", bytes * 1e-9, bytes / static_cast<double>(ticks));
  EXPECT_LT(bytes, maxHour_bytes);

  const auto recorded = RecordedInsertion::open(file);
  ASSERT_TRUE(recorded) << recorded.error().message;
  EXPECT_EQ(recorded->ticks(), ticks);
  const long before_KiB = residentMemory_KiB();
  std::uint64_t seen = 0;
  ASSERT_TRUE(recorded->forEach(
      [&seen](const haptics::TickRecord& record) { return record.tick == seen++; }));
  EXPECT_EQ(seen, ticks);
  if (test::AllocationGuard::isAvailable()) {
    EXPECT_LE(residentMemory_KiB() - before_KiB, 8192);
  }
}

}  // namespace
}  // namespace perilymph::session
