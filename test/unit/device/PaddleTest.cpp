// SPDX-License-Identifier: BSD-3-Clause

// The haptic paddle for teaching: the logic of its firmware against its profile, and both in one loop.

#include "PaddleLogic.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "VirtualTime.h"
#include "codec/DeviceCodec.h"
#include "codec/DeviceProfile.h"
#include "hid/HidDevice.h"
#include "perilymph/foundation/Resources.h"
#include "perilymph/foundation/Units.h"
#include "perilymph/test/FakeHid.h"
#include "perilymph/test/Tolerance.h"

namespace perilymph::device {
namespace {

using test::FakeHid;

// Dimensions of README.md, not those of the firmware.
constexpr double pulleyRadius = 4.8e-3, handleRadius = 70e-3, sectorRadius = 72e-3;  // [m]
const double travelPerTurn = 2.0 * pi * pulleyRadius * handleRadius / sectorRadius;  // [m]

DeviceProfile paddleProfile()
{
  auto read = loadProfile(resource("plugins/devices/paddle/paddle.toml"));
  EXPECT_TRUE(read) << (read ? "" : read.error().message);
  return *std::move(read);
}

ReportDescriptor paddleDescriptor()
{
  auto parsed = ReportDescriptor::parse(paddle::reportDescriptor);
  EXPECT_TRUE(parsed) << (parsed ? "" : parsed.error().message);
  return *std::move(parsed);
}

std::unique_ptr<DeviceCodec> paddleCodec()
{
  auto made = makeCodec(paddleProfile(), paddleDescriptor());
  EXPECT_TRUE(made) << (made ? "" : made.error().message);
  return *std::move(made);
}

RawReport reportOf(paddle::Paddle& state, bool isPressed)
{
  RawReport report;
  report.size = paddle::inputSize + 1;
  report.bytes[0] = paddle::inputNumber;
  paddle::fillReport(state, isPressed, report.bytes.data() + 1);
  return report;
}

DeviceSample sampleOf(paddle::Paddle& state, bool isPressed = false)
{
  DeviceSample sample;
  EXPECT_TRUE(paddleCodec()->decode(reportOf(state, isPressed), sample));
  return sample;
}

/// The duty cycle after the host requested a force.
int dutyFor(const Wrench& wrench_D)
{
  ReportList reports;
  paddleCodec()->encode(wrench_D, reports);
  paddle::Paddle state;
  EXPECT_EQ(reports.count, 1u);
  const RawReport& report = reports.reports[0];
  EXPECT_TRUE(
      paddle::takeReport(state, report.bytes.data(), static_cast<std::uint8_t>(report.size)));
  return paddle::duty(state);
}

TEST(Paddle, IsRecognizedByItsUsageOnAnyBoard)
{
  const ProfileCatalog shipped = shippedProfiles();
  for (const HidIdentity& board :
       {HidIdentity{0x2341, 0x8036, 2}, HidIdentity{0x1b4f, 0x9206, 2}}) {
    const DeviceProfile* const found = matchingProfile(shipped.profiles, board, paddleDescriptor());
    ASSERT_NE(found, nullptr);
    EXPECT_EQ(found->name, "Haptic paddle");
  }
}

TEST(Paddle, SendsReportsAsLongAsItsDescriptorAndProfileSay)
{
  EXPECT_TRUE(paddleDescriptor().isNumbered());
  EXPECT_EQ(paddleDescriptor().reportBytes(ReportKind::input, paddle::inputNumber),
            paddle::inputSize);
  EXPECT_EQ(paddleDescriptor().reportBytes(ReportKind::output, paddle::outputNumber),
            paddle::outputSize);
  EXPECT_EQ(paddleProfile().traits.watchdog, 1e-3 * paddle::watchdog);
}

TEST(Paddle, HasOneAxisTowardTheUser)
{
  const DeviceTraits traits = traitsOf(paddleProfile(), paddleDescriptor());
  EXPECT_EQ(traits.sensedTranslations, 1);
  EXPECT_EQ(traits.actuatedTranslations, 1);
  EXPECT_FALSE(traits.pushesAlong(0));
  EXPECT_FALSE(traits.pushesAlong(1));
  EXPECT_TRUE(traits.pushesAlong(2));
}

TEST(Paddle, IsWhereItsShaftWasTurnedTo)
{
  // A turn and a quarter in either direction, past the end of the sensor's range.
  for (const int direction : {1, -1}) {
    paddle::Paddle state;
    for (int i = 0; i <= 1280; i += 20)
      paddle::takeAngle(state, ((500 + direction * i) % 1024 + 1024) % 1024);
    const DeviceSample sample = sampleOf(state);
    // A step of the sensor is 29 um; the firmware's travel of a turn is rounded to 0.1 um.
    EXPECT_NEAR(sample.position_D[2], direction * 1.25 * travelPerTurn,
                test::tolerance(0.5e-6, "the rounding of travel and report"));
    EXPECT_EQ(sample.position_D[0], 0.0);
    EXPECT_EQ(sample.position_D[1], 0.0);
  }
}

TEST(Paddle, BeginsAtZeroWhereverItsSensorStands)
{
  paddle::Paddle state;
  paddle::takeAngle(state, 1023);
  EXPECT_EQ(sampleOf(state).position_D[2], 0.0);
}

TEST(Paddle, TellsItsButtonAndCountsItsReports)
{
  paddle::Paddle state;
  EXPECT_EQ(sampleOf(state, true).buttons, graspButton);
  EXPECT_EQ(sampleOf(state, false).buttons, 0u);
  state.counter = 0xffff;
  DeviceSample sample;
  EXPECT_EQ(paddleCodec()->decode(reportOf(state, false), sample), 0u);
  EXPECT_EQ(paddleCodec()->decode(reportOf(state, false), sample), 1u);
}

TEST(Paddle, DrivesItsMotorInProportionToTheForceAlongItsAxis)
{
  // 2 N at full duty cycle, of 255 steps
  EXPECT_EQ(dutyFor({{0.0, 0.0, 1.0}, {}}), 127);
  EXPECT_EQ(dutyFor({{0.0, 0.0, -1.0}, {}}), -127);
  EXPECT_EQ(dutyFor({}), 0);
  // A force along another axis is not rendered, and takes nothing from this one.
  EXPECT_EQ(dutyFor({{5.0, -5.0, 1.0}, {}}), 127);
  // The profile's maximum: 1.5 N.
  EXPECT_EQ(dutyFor({{0.0, 0.0, 80.0}, {}}), 191);
  EXPECT_EQ(dutyFor({{0.0, 0.0, std::nan("")}, {}}), 0);
}

TEST(Paddle, NeverDrivesItsMotorHarderThanItMayStall)
{
  paddle::Paddle state;
  for (const std::int16_t force : {std::int16_t{32767}, std::int16_t{-32768}}) {
    state.force = force;
    EXPECT_EQ(std::abs(paddle::duty(state)), paddle::greatestDuty);
  }
}

TEST(Paddle, DropsAForceThatIsNotRenewed)
{
  paddle::Paddle state;
  const std::uint8_t report[] = {paddle::outputNumber, 0, 0, 0, 0, 0x10, 0x27};  // 10000
  ASSERT_TRUE(paddle::takeReport(state, report, sizeof report));
  EXPECT_EQ(state.force, 10000);
  for (int i = 1; i < 50; ++i) paddle::passMillisecond(state);
  EXPECT_EQ(state.force, 10000);
  paddle::passMillisecond(state);
  EXPECT_EQ(state.force, 0);
}

TEST(Paddle, IgnoresReportsThatAreNotItsOwn)
{
  paddle::Paddle state;
  const std::uint8_t report[] = {3, 0, 0, 0, 0, 0x10, 0x27};
  EXPECT_FALSE(paddle::takeReport(state, report, sizeof report));
  const std::uint8_t shorter[] = {paddle::outputNumber, 0, 0, 0, 0, 0x10};
  EXPECT_FALSE(paddle::takeReport(state, shorter, sizeof shorter));
  EXPECT_EQ(state.force, 0);
}

/// The program's device with the firmware at the other end, in virtual time.
class PaddleInTheLoop : public testing::Test {
protected:
  PaddleInTheLoop()
  {
    virtualNow = 1000 * millisecond;
    hid_.whenWaiting([this](Duration) { tickPaddle(); });
  }
  /// A millisecond of the firmware: it takes new forces, then sends a report.
  void tickPaddle()
  {
    virtualNow += millisecond;
    const auto written = hid_.written();
    for (; taken_ < written.size(); ++taken_)
      paddle::takeReport(paddle_, written[taken_].bytes.data(),
                         static_cast<std::uint8_t>(written[taken_].size));
    paddle::passMillisecond(paddle_);
    paddle::takeAngle(paddle_, angle_);
    hid_.send(reportOf(paddle_, true));
  }
  DeviceSample turn(double newtons)
  {
    tickPaddle();
    const DeviceSample sample = device_.read();
    device_.write({{0.0, 0.0, newtons}, {}});
    return sample;
  }

  FakeHid hid_;
  paddle::Paddle paddle_;
  std::size_t taken_ = 0;
  int angle_ = 0;
  HidDevice device_{traitsOf(paddleProfile(), paddleDescriptor()), paddleCodec(), hid_.port(),
                    virtualClock};
};

TEST_F(PaddleInTheLoop, IsReadMovedAndPushed)
{
  const auto opened = device_.open();
  ASSERT_TRUE(opened) << opened.error().message;
  EXPECT_NEAR(device_.traits().nominalPeriod, 1e-3, 1e-9);
  EXPECT_EQ(paddle::duty(paddle_), 0);
  const DeviceSample before = turn(0.5);
  EXPECT_EQ(before.isValid, 1u);
  EXPECT_EQ(before.buttons, graspButton);
  angle_ = 256;  // a quarter of a turn
  const DeviceSample after = turn(0.5);
  EXPECT_NEAR(after.position_D[2] - before.position_D[2], 0.25 * travelPerTurn,
              test::tolerance(0.5e-6, "the rounding of travel and report"));
  expectSoon([this] {
    turn(0.5);
    return paddle::duty(paddle_) == 63;  // 0.5 N of 2 N, of 255 steps
  });
  device_.close();
  tickPaddle();
  EXPECT_EQ(paddle::duty(paddle_), 0);
}

TEST_F(PaddleInTheLoop, IsNotPushedOnAfterTheProgramFallsSilent)
{
  ASSERT_TRUE(device_.open());
  expectSoon([this] {
    turn(0.5);
    return paddle::duty(paddle_) == 63;
  });
  // Whatever the program's own guards do: the firmware alone ends it within its watchdog.
  taken_ = std::numeric_limits<std::size_t>::max();
  for (int i = 0; i < paddle::watchdog; ++i) {
    virtualNow += millisecond;
    paddle::passMillisecond(paddle_);
  }
  EXPECT_EQ(paddle::duty(paddle_), 0);
}

}  // namespace
}  // namespace perilymph::device
