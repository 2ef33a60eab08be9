// SPDX-License-Identifier: BSD-3-Clause

// A HidDevice with a simulated device. The clock only moves when a test moves it; where another
// thread has work to do, the test waits until it is done.

#include "hid/HidDevice.h"

#include <gtest/gtest.h>

#include <atomic>
#include <thread>

#include "VirtualTime.h"
#include "perilymph/test/AllocationGuard.h"
#include "perilymph/test/FakeHid.h"

namespace perilymph::device {
namespace {

using test::FakeHid;
using test::FakeReport;

constexpr Wrench pushing(double newtons) { return Wrench{{newtons, 0.0, 0.0}, {}}; }

class HidDeviceOnAFake : public testing::Test {
protected:
  HidDeviceOnAFake()
  {
    virtualNow = 1000 * millisecond;
    hid.whenWaiting([this](Duration) { tickDevice(); });
  }

  void tickDevice()
  {
    virtualNow += millisecond;
    FakeReport report;
    report.counter = ++counter;
    report.place_10um[0] = static_cast<std::int16_t>(counter);
    report.buttons = graspButton;
    hid.send(report);
  }
  /// One cycle of a haptic loop: a report arrives, it is read, a force is written.
  DeviceSample turn(double newtons)
  {
    tickDevice();
    const DeviceSample sample = hand.read();
    hand.write(pushing(newtons));
    return sample;
  }
  void open() { ASSERT_TRUE(hand.open()) << "the fake opens"; }
  bool hasShown(double newtons) const
  {
    const auto forces = hid.forces();
    return !forces.empty() && forces.back()[0] == newtons;
  }

  FakeHid hid;
  std::uint16_t counter = 0;
  HidDevice hand{test::fakeTraits(), std::make_unique<test::FakeCodec>(), hid.port(), virtualClock};
};

TEST_F(HidDeviceOnAFake, OpensOneHandleToReadAndOneToWrite)
{
  open();
  EXPECT_EQ(hid.opened(), 2);
  EXPECT_TRUE(hid.areActuatorsOn());
}

TEST_F(HidDeviceOnAFake, ShowsNoForceBeforeItIsAskedFor)
{
  open();
  for (const auto& force : hid.forces()) EXPECT_EQ(force[0], 0.0);
}

TEST_F(HidDeviceOnAFake, MeasuresThePeriodOfItsReports)
{
  open();
  EXPECT_NEAR(hand.traits().nominalPeriod, 1e-3, 1e-9);
  EXPECT_TRUE(hand.health()->isPeriodMeasured);
}

TEST_F(HidDeviceOnAFake, MeasuresThePeriodAlthoughTheFirstOrTheLastReportIsReadLate)
{
  for (const int late : {1, 40, 64}) {
    int waits = 0;
    hid.whenWaiting([&](Duration) {
      tickDevice();
      if (++waits == late) tickDevice();  // both are read now, the first of them a period late
    });
    open();
    EXPECT_TRUE(hand.health()->isPeriodMeasured) << late;
    EXPECT_NEAR(hand.traits().nominalPeriod, 1e-3, 1e-9) << late;
    hand.close();
  }
}

TEST_F(HidDeviceOnAFake, SaysWhyItCannotBeOpened)
{
  hid.unplug();
  const auto opened = hand.open();
  ASSERT_FALSE(opened);
  EXPECT_EQ(opened.error().message, "The fake device is not plugged in.");
}

TEST_F(HidDeviceOnAFake, GivesFreshSamplesAndShowsForces)
{
  open();
  const DeviceSample one = turn(0.25);
  const DeviceSample next = turn(0.25);
  EXPECT_EQ(next.sequence, one.sequence + 1);
  EXPECT_EQ(next.isValid, 1u);
  EXPECT_EQ(next.buttons, graspButton);
  EXPECT_NEAR(next.position_D[0] - one.position_D[0], 1e-5, 1e-12);
  expectSoon([this] { return hasShown(0.25); });
}

TEST_F(HidDeviceOnAFake, GoesOnReadingWhileAWriteIsStuck)
{
  open();
  hid.holdWrites(true);
  turn(0.1);
  expectSoon([this] { return hid.isWriteWaiting(); });
  const DeviceSample before = turn(0.2);
  const DeviceSample after = turn(0.3);
  EXPECT_EQ(after.sequence, before.sequence + 1);
  hid.holdWrites(false);
}

TEST_F(HidDeviceOnAFake, ShowsTheNewestForceAfterAPauseOfTheDevice)
{
  open();
  hid.holdWrites(true);
  turn(0.1);
  expectSoon([this] { return hid.isWriteWaiting(); });
  const std::size_t before = hid.forces().size();
  turn(0.2);
  turn(0.3);
  hid.holdWrites(false);
  expectSoon([this] { return hasShown(0.3); });
  const auto forces = hid.forces();
  ASSERT_EQ(forces.size(), before + 2);  // 0.2 N was overwritten in the mailbox
  EXPECT_EQ(forces[before][0], 0.1);
}

TEST_F(HidDeviceOnAFake, IsInvalidOnceNoForceWasTakenForFiveMilliseconds)
{
  open();
  hid.holdWrites(true);
  turn(0.1);
  expectSoon([this] { return hid.isWriteWaiting(); });
  for (int i = 0; i < 4; ++i) EXPECT_EQ(turn(0.1).isValid, 1u) << i;
  EXPECT_EQ(turn(0.1).isValid, 0u);
  EXPECT_TRUE(hand.health()->isBlocked);
  EXPECT_NE(hand.health()->error.find("takes no force"), std::string::npos);
  hid.holdWrites(false);
}

TEST_F(HidDeviceOnAFake, ComesBackFromABlockWithNoForce)
{
  open();
  hid.holdWrites(true);
  turn(0.1);
  expectSoon([this] { return hid.isWriteWaiting(); });
  while (turn(0.4).isValid != 0) {
  }
  hid.holdWrites(false);
  expectSoon([this] { return turn(0.0).isValid == 1; });
  const auto forces = hid.forces();
  for (std::size_t i = forces.size() - 1; forces[i][0] != 0.1; --i) EXPECT_EQ(forces[i][0], 0.0);
  EXPECT_EQ(hand.health()->blockedWrites, 1u);
}

TEST_F(HidDeviceOnAFake, IsBlockedByADeviceThatRefusesToo)
{
  open();
  hid.refuseWrites(true);
  expectSoon([this] { return turn(0.1).isValid == 0; });
  hid.refuseWrites(false);
  expectSoon([this] { return turn(0.0).isValid == 1; });
}

TEST_F(HidDeviceOnAFake, ShowsNoForceToAHandItHasNotHeardOfForThreePeriods)
{
  open();
  turn(0.5);
  expectSoon([this] { return hasShown(0.5); });
  virtualNow += 2 * millisecond;
  hand.read();
  hand.write(pushing(0.6));
  expectSoon([this] { return hasShown(0.6); });
  virtualNow += millisecond;
  hand.read();
  hand.write(pushing(0.7));
  expectSoon([this] { return hasShown(0.0); });
}

TEST_F(HidDeviceOnAFake, SendsZeroByItselfWhenTheLoopFallsSilent)
{
  open();
  turn(0.5);
  expectSoon([this] { return hasShown(0.5); });
  virtualNow += 31 * millisecond;
  expectSoon([this] { return hasShown(0.0); });
}

TEST_F(HidDeviceOnAFake, SurvivesUnpluggingDuringAWrite)
{
  open();
  hid.holdWrites(true);
  turn(0.5);
  expectSoon([this] { return hid.isWriteWaiting(); });
  hid.unplug();
  hid.holdWrites(false);
  EXPECT_EQ(turn(0.5).isValid, 0u);
  expectSoon([this] { return !hand.health()->error.empty() || turn(0.5).isValid != 0; });
  EXPECT_FALSE(hand.health()->isConnected);
  EXPECT_NE(hand.health()->error.find("not plugged in"), std::string::npos);
}

TEST_F(HidDeviceOnAFake, IsOpenedAgainWhenItIsPluggedIn)
{
  open();
  const DeviceSample before = turn(0.5);
  hid.unplug();
  while (turn(0.5).isValid != 0) {
  }
  hid.plugIn();
  expectSoon([this] { return turn(0.0).isValid == 1; });
  const DeviceSample after = turn(0.0);
  EXPECT_GT(after.sequence, before.sequence);
  EXPECT_TRUE(hid.areActuatorsOn());
  EXPECT_EQ(hand.health()->reconnections, 1u);
  turn(0.25);
  expectSoon([this] { return hasShown(0.25); });
}

TEST_F(HidDeviceOnAFake, ComesBackAsOftenAsItIsPluggedIn)
{
  open();
  for (int i = 0; i < 20; ++i) {
    hid.unplug();
    while (turn(0.5).isValid != 0) {
    }
    hid.plugIn();
    expectSoon([this] { return turn(0.5).isValid == 1; });
  }
  EXPECT_EQ(hand.health()->reconnections, 20u);
}

TEST_F(HidDeviceOnAFake, LeavesZeroForceAndNoActuatorsBehind)
{
  open();
  turn(0.5);
  expectSoon([this] { return hasShown(0.5); });
  hand.close();
  EXPECT_TRUE(hasShown(0.0));
  EXPECT_FALSE(hid.areActuatorsOn());
}

TEST_F(HidDeviceOnAFake, OpensAgainAfterItWasClosed)
{
  open();
  hand.close();
  hand.close();
  EXPECT_EQ(hand.read().isValid, 0u);
  hand.write(pushing(1.0));
  open();
  EXPECT_EQ(turn(0.0).isValid, 1u);
}

TEST_F(HidDeviceOnAFake, CanBeWaitedFor)
{
  open();
  hand.read();  // takes the handle
  const std::uint64_t before = hand.read().sequence;
  EXPECT_EQ(hand.await(Duration::fromSi(2e-3)), Awaited::fresh);
  EXPECT_EQ(hand.read().sequence, before + 1);
  hid.whenWaiting([](Duration) {});
  EXPECT_EQ(hand.await(Duration::fromSi(2e-3)), Awaited::nothing);
  hid.unplug();
  EXPECT_EQ(hand.await(Duration::fromSi(2e-3)), Awaited::cannot);
}

TEST_F(HidDeviceOnAFake, AllocatesNothingInReadAndWrite)
{
  if (!test::AllocationGuard::isAvailable()) GTEST_SKIP() << test::AllocationGuard::whyNot();
  open();
  turn(0.1);
  for (int i = 0; i < 50; ++i) tickDevice();
  const test::AllocationGuard guard;
  for (int i = 0; i < 1000; ++i) {
    hand.read();
    hand.write(pushing(0.1));
  }
  EXPECT_EQ(guard.allocations(), 0u);
}

TEST_F(HidDeviceOnAFake, AssumesARoundTripOfOnePeriodPlusTheTimeOfAWrite)
{
  open();
  const DeviceHealth health = *hand.health();
  EXPECT_FALSE(health.isRoundTripMeasured);
  EXPECT_NEAR(health.roundTrip, 1e-3, 1e-9);  // the fake takes a force in no time
}

TEST(HidDeviceThatAnswers, MeasuresTheTimeFromAForceToItsAnswer)
{
  virtualNow = 1000 * millisecond;
  FakeHid hid;
  std::size_t answered = 0;
  std::uint16_t counter = 0;
  // It only answers reports, each after 300 us.
  hid.whenWaiting([&](Duration timeout) {
    const std::size_t taken = hid.written().size();
    virtualNow += taken > answered ? 300'000 : std::int64_t(timeout.si() * 1e9);
    if (taken <= answered) return;
    answered = taken;
    FakeReport report;
    report.counter = ++counter;
    hid.send(report);
  });
  DeviceTraits traits = test::fakeTraits();
  traits.reporting = Reporting::onWrite;
  HidDevice hand(traits, std::make_unique<test::FakeCodec>(), hid.port(), virtualClock);
  ASSERT_TRUE(hand.open());
  const DeviceHealth health = *hand.health();
  EXPECT_TRUE(health.isRoundTripMeasured);
  EXPECT_NEAR(health.roundTrip, 300e-6, 0.032 * 300e-6);  // a bin of the histogram
  EXPECT_EQ(hand.traits().transportDelay, health.roundTrip);
}

TEST_F(HidDeviceOnAFake, ReportsThatItIsUnguardedWhereNoOtherProcessCanOpenTheDevice)
{
  open();
  EXPECT_FALSE(hand.health()->isGuarded);
  EXPECT_NE(hand.health()->guardObstacle.find("watchdog"), std::string::npos);
}

TEST(HidDeviceWithoutForce, IsNeverWritten)
{
  virtualNow = 1000 * millisecond;
  FakeHid hid;
  hid.whenWaiting([](Duration timeout) { virtualNow += std::int64_t(timeout.si() * 1e9); });
  DeviceTraits traits = test::fakeTraits();
  traits.rendersForce = false;
  traits.reporting = Reporting::onChange;
  HidDevice hand(traits, std::make_unique<test::FakeCodec>(), hid.port(), virtualClock);
  ASSERT_TRUE(hand.open());
  hand.read();
  hand.write(pushing(1.0));
  hand.close();
  EXPECT_TRUE(hid.written().empty());
  EXPECT_EQ(hid.opened(), 1);
}

TEST(HidDeviceThatReportsOnChange, StandsStillWhileItIsSilent)
{
  virtualNow = 1000 * millisecond;
  FakeHid hid;
  DeviceTraits traits = test::fakeTraits();
  traits.rendersForce = false;
  traits.reporting = Reporting::onChange;
  HidDevice hand(traits, std::make_unique<test::FakeCodec>(), hid.port(), virtualClock);
  ASSERT_TRUE(hand.open());
  hand.read();
  FakeReport report;
  report.counter = 1;
  report.place_10um[1] = 500;
  hid.send(report);
  std::uint64_t sequence = hand.read().sequence;
  for (int i = 0; i < 10; ++i) {
    const DeviceSample sample = hand.read();
    EXPECT_EQ(sample.sequence, ++sequence);
    EXPECT_NEAR(sample.position_D[1], 5e-3, 1e-12);
  }
}

}  // namespace
}  // namespace perilymph::device
