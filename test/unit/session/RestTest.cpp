// SPDX-License-Identifier: BSD-3-Clause

// A waiting insertion costs nothing: neither disk nor time, and its replay is the same to the bit.

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "ShortScenario.h"
#include "perilymph/device/ScriptedDevice.h"
#include "perilymph/session/Insertion.h"
#include "perilymph/session/RecordedInsertion.h"
#include "perilymph/session/Replay.h"
#include "perilymph/test/TemporaryFolder.h"

namespace perilymph::session {
namespace {

namespace fs = std::filesystem;
using device::ScriptedDevice;
using haptics::Workflow;

/// A scripted hand that only the test moves.
class Hand : public device::HapticDevice {
public:
  Hand(double speed, double timeStep, bool rendersForce)
      : script_(speed, timeStep), rendersForce_(rendersForce)
  {
  }
  /// Moved by the test alone: what a script says does not reach it.
  void moveBy(ScriptedDevice::Motion motion) { script_.move(motion); }
  device::DeviceTraits traits() const override
  {
    device::DeviceTraits traits = script_.traits();
    traits.rendersForce = rendersForce_;
    if (rendersForce_) traits.maxForce = 3.3;
    return traits;
  }
  Result<void> open() override { return script_.open(); }
  void close() noexcept override { script_.close(); }
  device::DeviceSample read() noexcept override { return trembling(script_.read()); }
  void write(const device::Wrench& wrench_D) noexcept override
  {
    script_.write(wrench_D);
    const auto& force = wrench_D.force_D;
    force_ = std::hypot(force[0], force[1], force[2]);
  }

  double force() const { return force_; }  ///< The last one [N].
  /// Holds the button and trembles by 0.05 mm.
  void holdOn() { isHolding_ = true; }
  void letGo() { isHolding_ = false; }
  void shift(double distance) { shift_ = distance; }
  /// Repeats its last sample.
  void fallSilent() { isSilent_ = true; }

private:
  device::DeviceSample trembling(device::DeviceSample sample) noexcept
  {
    if (isSilent_) return last_;
    if (isHolding_) {
      sample.buttons |= device::graspButton;
      sample.position_D[0] += shift_ + (sample.sequence % 40 < 20 ? 0.05e-3 : 0.0);
    }
    return last_ = sample;
  }

  ScriptedDevice script_;
  device::DeviceSample last_;
  double force_ = 0.0, shift_ = 0.0;
  bool isHolding_ = false, isSilent_ = false, rendersForce_;
};

class AWaitingInsertion : public testing::Test {
protected:
  void begin(const std::string& name, bool rendersForce = false, const char* stop_mm = "0.2")
  {
    insertion_.reset();
    ticksRun_ = 0;
    file_ = folder_ / (name + ".insertion");
    // Keeps a little of its curl with the stylet in: its tip moves at once when that is pulled.
    const Scenario scenario = test::shortScenario({{"calibration", ""},
                                                   {"stiffness_scale", "1.22"},
                                                   {"residual_curvature_fraction", "0.024"},
                                                   {"stop_travel_mm", stop_mm}});
    speed_ = scenario.speed().si();
    stop_ = scenario.stopTravel().si();
    auto prepared = Insertion::prepare(
        scenario, std::make_unique<Hand>(speed_, scenario.timeStep().si(), rendersForce), file_);
    ASSERT_TRUE(prepared) << prepared.error().message;
    insertion_ = std::move(*prepared);
  }
  /// Runs for a time of the device, whatever of it is recorded.
  void run(double seconds)
  {
    const auto ticks = static_cast<std::uint64_t>(seconds * 1e3);
    while (insertion_->loop().statistics().ticks < ticksRun_ + ticks) {
      const auto ran = insertion_->runToEnd(
          [this](const haptics::TickRecord& record) {
            last_ = record.output;
            return true;
          },
          1);
      ASSERT_TRUE(ran) << ran.error().message;
    }
    ticksRun_ = insertion_->loop().statistics().ticks;
  }
  /// In to the stop; then the hand releases.
  void insert()
  {
    device().moveBy(ScriptedDevice::Motion::insert);
    ASSERT_TRUE(insertion_->runToEnd([this](const haptics::TickRecord& record) {
      arrival_ = record.output.time;
      return true;
    }));
    ASSERT_EQ(insertion_->loop().engine().workflow(), Workflow::finished);
    device().moveBy(ScriptedDevice::Motion::hold);
    ticksRun_ = insertion_->loop().statistics().ticks;
  }
  Hand& device() { return dynamic_cast<Hand&>(insertion_->device()); }
  std::uintmax_t closedSize()
  {
    EXPECT_TRUE(insertion_->closeRecording());
    insertion_.reset();
    return fs::file_size(file_);
  }
  std::uint64_t recordedTicks() const
  {
    const auto recorded = RecordedInsertion::open(file_);
    return recorded ? recorded->ticks() : 0;
  }
  void expectSameBits()
  {
    const auto verified = verify(file_);
    ASSERT_TRUE(verified) << verified.error().message;
    EXPECT_TRUE(verified->isIdentical);
    EXPECT_EQ(verified->missingTicks, 0u);
    if (verified->difference) {
      ADD_FAILURE() << verified->difference->field << " of tick " << verified->difference->tick;
    }
  }

  const test::TemporaryFolder folder_;
  fs::path file_;
  double speed_ = 0.0;    // [m/s]
  double stop_ = 0.0;     // [m]
  double arrival_ = 0.0;  // at the stop, since the first motion [s]
  std::uint64_t ticksRun_ = 0;
  std::unique_ptr<Insertion> insertion_;
  haptics::TickOutput last_;
};

TEST_F(AWaitingInsertion, OfAMinuteAtFullDepthIsNoLargerThanOneOfThreeSeconds)
{
  begin("three");
  insert();
  run(recordedWait);
  const std::uintmax_t three = closedSize();

  begin("sixty");
  insert();
  run(60.0);
  EXPECT_LE(closedSize(), three + 8192);  // two pages of SQLite
  expectSameBits();

  const auto recorded = RecordedInsertion::open(file_);
  ASSERT_TRUE(recorded);
  const auto highlights = recorded->highlights();
  ASSERT_TRUE(highlights);
  EXPECT_NEAR(highlights->duration, arrival_, 1.1e-3);  // one tick
}

TEST_F(AWaitingInsertion, HeldAtFullDepthIsNoLargerThanOneOfThreeSeconds)
{
  begin("held-three");
  insert();
  device().holdOn();
  run(recordedWait);
  const std::uintmax_t three = closedSize();

  begin("held-sixty");
  insert();
  device().holdOn();
  run(60.0);
  EXPECT_EQ(last_.workflow, Workflow::finished);
  EXPECT_GT(device().force(), 0.0);       // the hand feels the array all the time
  EXPECT_LE(closedSize(), three + 8192);  // two pages of SQLite
  EXPECT_NEAR(static_cast<double>(recordedTicks()), 1e3 * (arrival_ + recordedWait), 30.0);
  expectSameBits();
}

TEST_F(AWaitingInsertion, HeldAtFullDepthContinuesWhenTheHandReleasesMovesOrWithdraws)
{
  begin("held-on");
  insert();
  device().holdOn();
  run(10.0);
  const std::uint64_t rested = recordedTicks();
  device().shift(5e-3);
  run(1.0);
  EXPECT_NEAR(static_cast<double>(recordedTicks() - rested), 1e3, 2.0);
  run(10.0);
  const std::uint64_t restedAgain = recordedTicks();
  device().letGo();
  run(1.0);
  EXPECT_EQ(device().force(), 0.0);
  EXPECT_NEAR(static_cast<double>(recordedTicks() - restedAgain), 1e3, 2.0);
  device().holdOn();
  run(10.0);
  device().moveBy(ScriptedDevice::Motion::withdraw);
  haptics::Command command;
  command.kind = haptics::Command::Kind::withdraw;
  ASSERT_TRUE(insertion_->send(command));
  run(1.5 * arrival_);
  EXPECT_NEAR(last_.travel, 0.0, 1e-5);
  closedSize();
  expectSameBits();
}

TEST_F(AWaitingInsertion, HeldStillInTheMiddleIsRecordedForThreeSecondsOnly)
{
  begin("middle", true, "2.0");
  device().moveBy(ScriptedDevice::Motion::insert);
  run(0.5);
  device().moveBy(ScriptedDevice::Motion::hold);
  device().holdOn();
  run(60.0);
  ASSERT_EQ(last_.workflow, Workflow::inserting);
  EXPECT_GT(last_.travel, 0.0);
  EXPECT_LT(last_.travel, 0.9 * stop_);
  closedSize();
  EXPECT_LT(static_cast<double>(recordedTicks()), 1e3 * (0.5 + recordedWait + 1.0));
  expectSameBits();
}

TEST_F(AWaitingInsertion, HeldStillInTheMiddleContinuesWithTheHand)
{
  begin("middle-on", true, "2.0");
  device().moveBy(ScriptedDevice::Motion::insert);
  run(0.5);
  device().moveBy(ScriptedDevice::Motion::hold);
  device().holdOn();
  run(20.0);
  const double travel = last_.travel;
  const std::uint64_t rested = recordedTicks();
  device().moveBy(ScriptedDevice::Motion::insert);
  run(0.3);
  EXPECT_GT(recordedTicks(), rested + 200);
  EXPECT_GT(last_.travel, travel + 0.1 * speed_);
  device().letGo();
  device().moveBy(ScriptedDevice::Motion::hold);
  run(0.1);
  EXPECT_EQ(last_.workflow, Workflow::paused);
  closedSize();
  expectSameBits();
}

TEST_F(AWaitingInsertion, InTheMiddleOfAScriptIsRecordedAsItIs)
{
  begin("waiting-script", false, "2.0");
  device().moveBy(ScriptedDevice::Motion::insert);
  run(0.5);
  device().moveBy(ScriptedDevice::Motion::hold);
  device().holdOn();  // a robot waits: its script says how long
  run(10.0);
  EXPECT_EQ(last_.workflow, Workflow::inserting);
  closedSize();
  EXPECT_NEAR(static_cast<double>(recordedTicks()), 10.5e3, 30.0);
  expectSameBits();
}

TEST_F(AWaitingInsertion, OfADeviceThatFallsSilentWhileHeldHasNoForce)
{
  begin("silent");
  insert();
  device().holdOn();
  run(10.0);
  ASSERT_GT(device().force(), 0.0);
  device().fallSilent();
  run(0.02);
  EXPECT_EQ(device().force(), 0.0);
  closedSize();
  expectSameBits();
}

TEST_F(AWaitingInsertion, RecordsTheWithdrawalThatFollows)
{
  begin("withdrawn");
  insert();
  run(60.0);
  const std::uint64_t before = recordedTicks();
  device().moveBy(ScriptedDevice::Motion::withdraw);
  haptics::Command command;
  command.kind = haptics::Command::Kind::withdraw;
  ASSERT_TRUE(insertion_->send(command));
  run(1.5 * arrival_);
  EXPECT_NEAR(last_.travel, 0.0, 1e-5);
  EXPECT_EQ(last_.workflow, Workflow::finished);
  closedSize();
  EXPECT_NEAR(static_cast<double>(recordedTicks() - before), 1.5e3 * arrival_, 2.0);
  expectSameBits();
}

TEST_F(AWaitingInsertion, ContinuesAfterALongPauseAsAfterAShortOne)
{
  begin("paused");
  device().moveBy(ScriptedDevice::Motion::insert);
  run(0.05);
  device().moveBy(ScriptedDevice::Motion::hold);
  run(20.0);
  EXPECT_EQ(last_.workflow, Workflow::paused);
  EXPECT_NEAR(last_.time, 0.05 + recordedWait, 0.01);
  insert();  // the rest of the way
  closedSize();
  EXPECT_NEAR(static_cast<double>(recordedTicks()), 1e3 * arrival_, 3.0);  // the wait included
  expectSameBits();
}

TEST_F(AWaitingInsertion, RecordsNothingBeforeItsFirstMotion)
{
  begin("late");
  run(20.0);  // armed
  insert();
  closedSize();
  std::uint64_t before = 0;
  const auto recorded = RecordedInsertion::open(file_);
  ASSERT_TRUE(recorded);
  ASSERT_TRUE(recorded->forEach([&](const haptics::TickRecord& record) {
    if (record.output.workflow < Workflow::inserting) ++before;
    return true;
  }));
  EXPECT_EQ(before, 1u);  // the tick that arms
  expectSameBits();
}

TEST_F(AWaitingInsertion, IsReadableWhileItRests)
{
  begin("crashed");
  insert();
  run(10.0);
  const auto recorded = RecordedInsertion::open(file_);
  ASSERT_TRUE(recorded) << recorded.error().message;
  EXPECT_FALSE(recorded->wasClosed());
  EXPECT_NEAR(static_cast<double>(recorded->ticks()), 1e3 * (arrival_ + recordedWait), 3.0);
}

}  // namespace
}  // namespace perilymph::session
