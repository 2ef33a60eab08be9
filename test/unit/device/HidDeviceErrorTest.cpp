// SPDX-License-Identifier: BSD-3-Clause

// Errors of a HID device before and during its use, and polled devices. As in HidDeviceTest.cpp,
// the clock only moves when a test moves it.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <memory>
#include <thread>

#include "VirtualTime.h"
#include "hid/HidDevice.h"
#include "perilymph/test/FakeHid.h"

namespace perilymph::device {
namespace {

using test::FakeHid;
using test::FakeReport;
using testing::HasSubstr;

constexpr Wrench pushed(double newtons) { return Wrench{{newtons, 0.0, 0.0}, {}}; }

class FailingHidDevice : public testing::Test {
protected:
  FailingHidDevice() { virtualNow = 1000 * millisecond; }

  HidDevice& handOf(const DeviceTraits& traits)
  {
    hand_ = std::make_unique<HidDevice>(traits, std::make_unique<test::FakeCodec>(), hid.port(),
                                        virtualClock);
    return *hand_;
  }
  /// Whenever a thread waits for a report, the device sends one after a delay.
  void reportEvery(std::int64_t time)
  {
    hid.whenWaiting([this, time](Duration) {
      virtualNow += time;
      hid.send(next());
    });
  }
  FakeReport next()
  {
    FakeReport report;
    report.counter = ++counter_;
    report.place_10um[0] = static_cast<std::int16_t>(counter_);
    return report;
  }
  bool hasShownAForce() const
  {
    for (const auto& force : hid.forces())
      if (force[0] != 0.0) return true;
    return false;
  }

  FakeHid hid;

private:
  std::uint16_t counter_ = 0;
  std::unique_ptr<HidDevice> hand_;
};

TEST_F(FailingHidDevice, SaysThatTheDeviceIsSilentOnceATenthOfASecondPassed)
{
  reportEvery(millisecond);
  HidDevice& hand = handOf(test::fakeTraits());
  ASSERT_TRUE(hand.open());
  hand.read();
  hid.send(next());
  hand.read();
  EXPECT_EQ(hand.health()->error, "");
  virtualNow += 250 * millisecond;
  hand.read();
  EXPECT_THAT(hand.health()->error, HasSubstr("has sent nothing for 0.25 s. The force is off."));
}

TEST_F(FailingHidDevice, SaysThatTheDeviceNeverSentAReport)
{
  hid.whenWaiting([](Duration) { virtualNow += millisecond; });
  HidDevice& hand = handOf(test::fakeTraits());
  ASSERT_TRUE(hand.open());
  hand.read();
  virtualNow += 250 * millisecond;
  hand.read();
  EXPECT_THAT(hand.health()->error,
              HasSubstr("has sent no report since it was opened, 0.25 s ago. The force is off."));
}

TEST_F(FailingHidDevice, HasNoHealthAndCannotBeWaitedForWhileItIsClosed)
{
  HidDevice& hand = handOf(test::fakeTraits());
  EXPECT_FALSE(hand.health());
  EXPECT_EQ(hand.await(Duration::fromSi(1e-3)), Awaited::cannot);
  reportEvery(millisecond);
  ASSERT_TRUE(hand.open());
  // no thread has taken the handle
  EXPECT_EQ(hand.await(Duration::fromSi(1e-3)), Awaited::cannot);
}

TEST_F(FailingHidDevice, ThatReportsOnlyChangesDoesNotPaceTheLoop)
{
  DeviceTraits traits = test::fakeTraits();
  traits.rendersForce = false;
  traits.reporting = Reporting::onChange;
  HidDevice& hand = handOf(traits);
  ASSERT_TRUE(hand.open());
  hand.read();
  EXPECT_EQ(hand.await(Duration::fromSi(1e-3)), Awaited::cannot);
}

TEST_F(FailingHidDevice, IsNotOpenedToBeReadWhereItCannotBeWritten)
{
  hid.maxOpen(1);
  const auto opened = handOf(test::fakeTraits()).open();
  ASSERT_FALSE(opened);
  EXPECT_EQ(opened.error().message, "The fake device is held by another.");
}

TEST_F(FailingHidDevice, IsNotOpenedWhereItsActuatorsStayOff)
{
  hid.refuseActuators(true);
  HidDevice& hand = handOf(test::fakeTraits());
  const auto opened = hand.open();
  ASSERT_FALSE(opened);
  EXPECT_THAT(opened.error().message, HasSubstr("does not turn its actuators on"));
  EXPECT_EQ(hand.read().isValid, 0u);
}

TEST_F(FailingHidDevice, WithoutAReportWhileItIsOpenedKeepsTheProfilesPeriod)
{
  hid.whenWaiting([](Duration time) { virtualNow += std::int64_t(time.si() * 1e9); });
  HidDevice& hand = handOf(test::fakeTraits());
  ASSERT_TRUE(hand.open());
  EXPECT_FALSE(hand.health()->isPeriodMeasured);
  EXPECT_EQ(hand.traits().nominalPeriod, 1e-3);
}

TEST_F(FailingHidDevice, WhosePeriodIsFarFromTheProfilesKeepsTheProfiles)
{
  for (const std::int64_t period : {3 * millisecond, 3 * millisecond / 10, std::int64_t{0}}) {
    reportEvery(period);
    HidDevice& hand = handOf(test::fakeTraits());
    ASSERT_TRUE(hand.open());
    EXPECT_FALSE(hand.health()->isPeriodMeasured) << period;
    EXPECT_EQ(hand.traits().nominalPeriod, 1e-3) << period;
    hand.close();
  }
}

TEST_F(FailingHidDevice, PulledOutWhileItIsOpenedIsInvalid)
{
  hid.whenWaiting([this](Duration) { hid.unplug(); });
  HidDevice& hand = handOf(test::fakeTraits());
  ASSERT_TRUE(hand.open());
  EXPECT_EQ(hand.read().isValid, 0u);
}

TEST_F(FailingHidDevice, ThatTakesNoReportWhileItIsOpenedHasNoMeasuredDelay)
{
  hid.refuseWrites(true);
  reportEvery(millisecond);
  DeviceTraits traits = test::fakeTraits();
  for (const Reporting reporting : {Reporting::periodic, Reporting::onWrite}) {
    traits.reporting = reporting;
    HidDevice& hand = handOf(traits);
    ASSERT_TRUE(hand.open());
    EXPECT_FALSE(hand.health()->isRoundTripMeasured);
    EXPECT_EQ(hand.traits().transportDelay, 0.0);
    hand.close();
  }
}

TEST_F(FailingHidDevice, ThatAnswersWithoutAForceOfItsOwnIsWrittenToAllTheSame)
{
  reportEvery(millisecond);
  DeviceTraits traits = test::fakeTraits();
  traits.rendersForce = false;
  traits.reporting = Reporting::onWrite;
  HidDevice& hand = handOf(traits);
  ASSERT_TRUE(hand.open());
  const std::size_t before = hid.written().size();
  expectSoon([&] {
    hand.read();
    hand.write(pushed(1.0));
    return hid.written().size() > before;
  });
  EXPECT_FALSE(hasShownAForce());
}

TEST_F(FailingHidDevice, IsFreshUntilItIsRead)
{
  reportEvery(millisecond);
  HidDevice& hand = handOf(test::fakeTraits());
  ASSERT_TRUE(hand.open());
  hand.read();
  EXPECT_EQ(hand.await(Duration::fromSi(2e-3)), Awaited::fresh);
  const std::int64_t then = virtualNow;
  EXPECT_EQ(hand.await(Duration::fromSi(2e-3)), Awaited::fresh);
  EXPECT_EQ(virtualNow, then);  // without waiting
}

TEST_F(FailingHidDevice, IsToldZeroAgainUntilItTakesIt)
{
  reportEvery(millisecond);
  HidDevice& hand = handOf(test::fakeTraits());
  ASSERT_TRUE(hand.open());
  hand.read();
  hid.send(next());
  hand.read();
  hand.write(pushed(0.5));
  expectSoon([this] { return hasShownAForce(); });
  // The loop stops calling, and the device refuses the zero force that is sent in response.
  hid.refuseWrites(true);
  virtualNow += 100 * millisecond;
  expectSoon([&hand] {
    virtualNow += millisecond;
    hand.read();
    return hand.health()->isBlocked;
  });
  hid.refuseWrites(false);
  expectSoon([this] { return hid.forces().back()[0] == 0.0; });
}

TEST_F(FailingHidDevice, ThatShouldAnswerButDoesNotHasNoMeasuredDelay)
{
  DeviceTraits traits = test::fakeTraits();
  hid.whenWaiting([](Duration time) { virtualNow += std::int64_t(time.si() * 1e9); });
  for (const Reporting reporting : {Reporting::onWrite, Reporting::polled}) {
    traits.reporting = reporting;
    HidDevice& hand = handOf(traits);
    ASSERT_TRUE(hand.open());
    EXPECT_FALSE(hand.health()->isRoundTripMeasured);
    hand.close();
  }
}

/// A polled device: it answers requests for feature report 4.
class PolledHidDevice : public FailingHidDevice {
protected:
  PolledHidDevice()
  {
    traits.reporting = Reporting::polled;
    traits.polledReport = 4;
    hid.whenRequested([this](RawReport& report) {
      EXPECT_EQ(report.bytes[0], 4);
      virtualNow += answerTime;
      if (!answers) return Transfer::failed;
      report = next().raw();
      return Transfer::done;
    });
  }

  DeviceTraits traits = test::fakeTraits();
  std::atomic<bool> answers{true};
  std::int64_t answerTime = 200'000;  // [ns]
};

TEST_F(PolledHidDevice, GivesItsPositionAndTheTimeOfAnAnswer)
{
  HidDevice& hand = handOf(traits);
  ASSERT_TRUE(hand.open());
  EXPECT_TRUE(hand.health()->isRoundTripMeasured);
  EXPECT_NEAR(hand.health()->roundTrip, 200e-6, 0.032 * 200e-6);  // a bin of the histogram
  expectSoon([&hand] { return hand.read().sequence > 2; });
  const DeviceSample before = hand.read();
  EXPECT_EQ(before.isValid, 1u);
  expectSoon([&hand, &before] { return hand.read().sequence > before.sequence; });
  EXPECT_GT(hand.read().position_D[0], before.position_D[0]);
}

TEST_F(PolledHidDevice, ThatIsSlowIsMeasured)
{
  answerTime = 20 * millisecond;
  HidDevice& hand = handOf(traits);
  ASSERT_TRUE(hand.open());
  EXPECT_NEAR(hand.health()->roundTrip, 20e-3, 0.032 * 20e-3);
}

TEST_F(PolledHidDevice, FeelsAForceWhileItAnswersAndNoneAfterwards)
{
  HidDevice& hand = handOf(traits);
  ASSERT_TRUE(hand.open());
  expectSoon([&] {
    hand.read();
    hand.write(pushed(0.25));
    return hasShownAForce();
  });
  answers = false;
  expectSoon([&] {
    hand.read();
    hand.write(pushed(0.25));
    return hid.forces().back()[0] == 0.0;
  });
}

TEST_F(PolledHidDevice, PulledOutWhileItIsAskedIsInvalid)
{
  HidDevice& hand = handOf(traits);
  ASSERT_TRUE(hand.open());
  expectSoon([&hand] { return hand.read().isValid == 1; });
  hid.unplug();
  // No thread reads; the polling thread detects it.
  expectSoon([&hand] { return !hand.health()->isConnected; });
  EXPECT_EQ(hand.read().isValid, 0u);
}

TEST_F(PolledHidDevice, WithoutAForceIsPolled)
{
  traits.rendersForce = false;
  HidDevice& hand = handOf(traits);
  ASSERT_TRUE(hand.open());
  expectSoon([&hand] { return hand.read().sequence > 2; });
  hand.write(pushed(1.0));
  hand.close();
  EXPECT_FALSE(hasShownAForce());
}

}  // namespace
}  // namespace perilymph::device
