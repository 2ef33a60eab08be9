// SPDX-License-Identifier: BSD-3-Clause

// The force is off and the array rests when the window loses the keyboard focus, shows another page
// or closes.

#include "gui/run/SafetyStop.h"

#include <gtest/gtest.h>

#include <QTest>
#include <atomic>
#include <cmath>

#include "perilymph/device/ScriptedDevice.h"
#include "perilymph/session/RecordedInsertion.h"
#include "perilymph/test/TemporaryFolder.h"

namespace perilymph::test {
namespace {

using gui::InputSource;
using gui::InsertionControl;

constexpr int stopPatience_ms = 60'000;

/// The forces written to a device.
struct Told {
  std::atomic<bool> hasPushed{false};  ///< Some force other than zero was written.
  std::atomic<bool> isZero{true};      ///< The last force written is zero.
  std::atomic<std::uint64_t> writes{0};
};

/// A device with a motor that inserts automatically.
class PushingDevice : public device::HapticDevice {
public:
  PushingDevice(const session::Scenario& scenario, Told& told)
      : script_(scenario.speed().si(), scenario.timeStep().si()), told_(told)
  {
    script_.move(device::ScriptedDevice::Motion::insert);
  }
  device::DeviceTraits traits() const override
  {
    device::DeviceTraits traits = script_.traits();
    traits.name = "Pushing device";
    traits.rendersForce = true;
    traits.maxForce = 3.3;
    return traits;
  }
  Result<void> open() override { return script_.open(); }
  void close() noexcept override { script_.close(); }
  device::DeviceSample read() noexcept override { return script_.read(); }
  void write(const device::Wrench& wrench_D) noexcept override
  {
    double sum = 0.0;
    for (const double force : wrench_D.force_D) sum += std::fabs(force);
    if (sum > 0.0) told_.hasPushed = true;
    told_.isZero = sum == 0.0;
    ++told_.writes;
  }

private:
  device::ScriptedDevice script_;
  Told& told_;
};

session::Scenario scenario()
{
  const auto read = session::loadScenario("contour-published", {{"nodes", "40"}});
  EXPECT_TRUE(read) << read.error().message;
  return *read;
}

class TheSafetyStop : public testing::Test {
protected:
  TheSafetyStop() : control_(scenario(), folder_ / "it.insertion"), safety_(control_) {}

  void begin(InputSource hand)
  {
    ASSERT_TRUE(control_.prepare(hand));
    ASSERT_TRUE(control_.begin());
    ASSERT_TRUE(
        waitUntil([&] { return control_.now().output.workflow != haptics::Workflow::idle; }));
  }
  bool waitUntil(const std::function<bool()>& claim)
  {
    return QTest::qWaitFor(
        [&] {
          control_.update();
          return claim();
        },
        stopPatience_ms);
  }

  TemporaryFolder folder_;
  Told told_;
  InsertionControl control_;
  gui::SafetyStop safety_;
};

TEST_F(TheSafetyStop, AtTheEndLeavesTheDeviceWithoutForceAndTheLoopStopped)
{
  control_.choose([this] {
    return Result<std::unique_ptr<device::HapticDevice>>(
        std::make_unique<PushingDevice>(control_.scenario(), told_));
  });
  begin(InputSource::device);
  ASSERT_TRUE(waitUntil([&] { return told_.hasPushed.load(); }));
  safety_.end();
  EXPECT_TRUE(told_.isZero);
  const std::uint64_t writes = told_.writes;
  control_.update();  // the last snapshot
  EXPECT_FALSE(control_.update());
  EXPECT_EQ(told_.writes, writes);
}

TEST_F(TheSafetyStop, AtTheEndKeepsTheRecordingWhole)
{
  begin(InputSource::scripted);
  ASSERT_TRUE(waitUntil([&] { return control_.now().output.travel > 1e-4; }));
  safety_.end();
  ASSERT_TRUE(control_.prepare(InputSource::scripted));  // the insertion starts as in the window
  const auto recorded = session::RecordedInsertion::open(folder_ / "it.insertion");
  ASSERT_TRUE(recorded) << recorded.error().message;
  EXPECT_TRUE(recorded->wasClosed());
  EXPECT_GT(recorded->ticks(), 0u);
}

TEST_F(TheSafetyStop, WithoutAnInsertionDoesNothing)
{
  safety_.loseKeyboard();
  EXPECT_FALSE(safety_.onPageHidden());
  safety_.end();
  EXPECT_FALSE(control_.isRunning());
}

TEST_F(TheSafetyStop, LetsGoOfAnArrayHeldByTheMouseWhenTheKeyboardIsLost)
{
  begin(InputSource::pointer);
  control_.hold(true);
  ASSERT_TRUE(control_.isHeld());
  safety_.loseKeyboard();
  EXPECT_FALSE(control_.isHeld());
}

TEST_F(TheSafetyStop, LetsTheScriptGoOnWhenTheKeyboardIsLost)
{
  begin(InputSource::scripted);
  safety_.loseKeyboard();
  EXPECT_TRUE(control_.isMoving());
}

TEST_F(TheSafetyStop, PausesOrReleasesTheArrayOnAnotherPage)
{
  begin(InputSource::scripted);
  ASSERT_TRUE(control_.isMoving());
  EXPECT_TRUE(safety_.onPageHidden());
  EXPECT_FALSE(control_.isMoving());

  begin(InputSource::pointer);
  control_.hold(true);
  EXPECT_TRUE(safety_.onPageHidden());
  EXPECT_FALSE(control_.isHeld());
}

}  // namespace
}  // namespace perilymph::test
