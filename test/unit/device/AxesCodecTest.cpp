// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "Descriptors.h"
#include "codec/DeviceCodec.h"
#include "codec/DeviceProfile.h"
#include "perilymph/test/AllocationGuard.h"

namespace perilymph::device {
namespace {

using testing::HasSubstr;

constexpr const char* head = R"(
name = "Test"
maker = "nobody"
source = "test"
confidence = "high"
[[match]]
usage_page = 1
usage = 4
)";

DeviceProfile profileOf(const std::string& kind, const std::string& rest)
{
  const auto profile = parseProfile("kind = \"" + kind + "\"" + head + rest, "test.toml");
  EXPECT_TRUE(profile) << (profile ? "" : profile.error().message);
  return *profile;
}

DeviceProfile stickProfile()
{
  return profileOf("joystick", R"(
[capability]
nominal_period_ms = 10.0
[mount]
grasp_button = 3
[axes]
motion = "place"
x = "x"
z = "y"
travel_mm = 15.0
)");
}

DeviceProfile knobProfile()
{
  return profileOf("spacemouse", R"(
[capability]
nominal_period_ms = 8.0
workspace_radius_mm = 60.0
reporting = "on_change"
[axes]
motion = "rate"
x = "x"
y = "-z"
z = "y"
turn_x = "rx"
turn_y = "-rz"
turn_z = "ry"
speed_mm_s = 20.0
turn_deg_s = 45.0
dead_zone = 0.05
)");
}

struct AxesRig {
  AxesRig(const DeviceProfile& profile, const std::vector<std::uint8_t>& descriptor)
      : codec(*makeCodec(profile, *ReportDescriptor::parse(descriptor)))
  {
  }

  bool takes(const std::vector<std::uint8_t>& bytes)
  {
    RawReport report;
    report.size = bytes.size();
    std::copy(bytes.begin(), bytes.end(), report.bytes.begin());
    return codec->decode(report, hand).has_value();
  }
  /// A report with three numbers of 16 bits.
  bool takes(std::uint8_t number, int a, int b, int c)
  {
    std::vector<std::uint8_t> bytes{number};
    for (const int value : {a, b, c}) {
      bytes.push_back(static_cast<std::uint8_t>(value & 0xff));
      bytes.push_back(static_cast<std::uint8_t>((value >> 8) & 0xff));
    }
    return takes(bytes);
  }

  DeviceSample hand;
  std::unique_ptr<DeviceCodec> codec;
};

/// Report 1 of the stick: two numbers of 10 bits, then the buttons in the fourth byte.
std::vector<std::uint8_t> stickReport(unsigned x, unsigned y, std::uint8_t buttons)
{
  const unsigned packed = x | y << 10;
  return {1, static_cast<std::uint8_t>(packed), static_cast<std::uint8_t>(packed >> 8),
          static_cast<std::uint8_t>(packed >> 16), buttons};
}

TEST(Joystick, MovesFromEndToEndOfItsTravel)
{
  AxesRig rig(stickProfile(), test::joystickDescriptor());
  ASSERT_TRUE(rig.takes(stickReport(0, 1023, 0)));
  EXPECT_NEAR(rig.hand.position_D[0], -15e-3, 1e-15);
  EXPECT_NEAR(rig.hand.position_D[2], 15e-3, 1e-15);
  EXPECT_EQ(rig.hand.position_D[1], 0.0);
}

TEST(Joystick, StandsHalfAStepFromTheMiddleOfAnEvenRange)
{
  AxesRig rig(stickProfile(), test::joystickDescriptor());
  ASSERT_TRUE(rig.takes(stickReport(512, 511, 0)));
  EXPECT_NEAR(rig.hand.position_D[0], 15e-3 * 0.5 / 511.5, 1e-15);
  EXPECT_NEAR(rig.hand.position_D[2], -15e-3 * 0.5 / 511.5, 1e-15);
}

TEST(Joystick, PutsTheGraspButtonFirstAndLosesNoOther)
{
  AxesRig rig(stickProfile(), test::joystickDescriptor());
  rig.takes(stickReport(0, 0, 0b0000'0100));
  EXPECT_EQ(rig.hand.buttons, graspButton);
  rig.takes(stickReport(0, 0, 0b0000'0011));
  EXPECT_EQ(rig.hand.buttons, 0b0110u);
  rig.takes(stickReport(0, 0, 0b1111'1000));
  EXPECT_EQ(rig.hand.buttons, 0b1111'1000u);
  rig.takes(stickReport(0, 0, 0));
  EXPECT_EQ(rig.hand.buttons, 0u);
}

TEST(Joystick, IgnoresReportsThatAreShortOrOfAnotherNumber)
{
  AxesRig rig(stickProfile(), test::joystickDescriptor());
  ASSERT_TRUE(rig.takes(stickReport(1023, 1023, 0xff)));
  const DeviceSample before = rig.hand;
  EXPECT_FALSE(rig.takes(std::vector<std::uint8_t>{1, 0, 0, 0}));
  EXPECT_FALSE(rig.takes(std::vector<std::uint8_t>{2, 0, 0, 0, 0}));
  EXPECT_FALSE(rig.takes(std::vector<std::uint8_t>{}));
  EXPECT_EQ(rig.hand.position_D, before.position_D);
  EXPECT_EQ(rig.hand.buttons, before.buttons);
}

TEST(Joystick, ShowsNoForce)
{
  AxesRig rig(stickProfile(), test::joystickDescriptor());
  ReportList reports;
  rig.codec->encode({{1.0, 1.0, 1.0}, {}}, reports);
  EXPECT_EQ(reports.count, 0u);
}

TEST(JoystickTraits, CountAxesAndButtonsOfTheDevice)
{
  const auto descriptor = *ReportDescriptor::parse(test::joystickDescriptor());
  const DeviceTraits traits = traitsOf(stickProfile(), descriptor);
  EXPECT_EQ(traits.sensedTranslations, 2);
  EXPECT_EQ(traits.sensedRotations, 0);
  EXPECT_EQ(traits.buttons, 8);
  EXPECT_FALSE(traits.rendersForce);
  EXPECT_NEAR(traits.positionQuantum, 30e-3 / 1023, 1e-12);
}

TEST(JoystickProfile, IsRefusedForADeviceWithoutItsAxis)
{
  const auto mouse = *ReportDescriptor::parse(
      std::vector<std::uint8_t>{0x05, 0x01, 0x09, 0x04, 0xa1, 0x01, 0x09, 0x30, 0x15, 0x00, 0x25,
                                0x7f, 0x75, 0x08, 0x95, 0x01, 0x81, 0x02, 0xc0});
  const auto codec = makeCodec(stickProfile(), mouse);
  ASSERT_FALSE(codec);
  EXPECT_THAT(codec.error().message, HasSubstr("moves 'z'"));
  EXPECT_FALSE(makeCodec(stickProfile(), ReportDescriptor()));
}

TEST(Knob, DriftsWithASpeedWhileItIsPushed)
{
  AxesRig rig(knobProfile(), test::knobDescriptor());
  // Fully away from the user (-Y) for one second: 125 reports of 8 ms at 20 mm/s.
  for (int i = 0; i < 125; ++i) ASSERT_TRUE(rig.takes(1, 0, -350, 0));
  EXPECT_NEAR(rig.hand.position_D[2], -20e-3, 1e-12);
  EXPECT_EQ(rig.hand.position_D[0], 0.0);
}

TEST(Knob, RestsWhileReleasedOrWithinItsDeadZone)
{
  AxesRig rig(knobProfile(), test::knobDescriptor());
  for (int i = 0; i < 100; ++i) rig.takes(1, 17, -17, 17);  // within 5 % of 350
  EXPECT_EQ(rig.hand.position_D, (std::array<double, 3>{}));
}

TEST(Knob, LiftsWhenPulledUpWhichItsMakerCountsDownward)
{
  AxesRig rig(knobProfile(), test::knobDescriptor());
  rig.takes(1, 0, 0, -350);
  EXPECT_GT(rig.hand.position_D[1], 0.0);
}

TEST(Knob, DoesNotShiftByReportsOfRotationOrButtons)
{
  AxesRig rig(knobProfile(), test::knobDescriptor());
  rig.takes(1, 350, 0, 0);
  const double once = rig.hand.position_D[0];
  rig.takes(2, 0, 0, 0);
  rig.takes(std::vector<std::uint8_t>{3, 1});
  EXPECT_EQ(rig.hand.position_D[0], once);
  EXPECT_EQ(rig.hand.buttons, graspButton);
}

TEST(Knob, TurnsByTheAngleOfItsSpeedAndStaysARotation)
{
  AxesRig rig(knobProfile(), test::knobDescriptor());
  // 250 reports of 8 ms at 45 deg/s about D's z (the device's Ry): a quarter turn.
  for (int i = 0; i < 250; ++i) rig.takes(2, 0, 350, 0);
  EXPECT_NEAR(rig.hand.rotation_D[0], std::sqrt(0.5), 1e-12);
  EXPECT_NEAR(rig.hand.rotation_D[3], std::sqrt(0.5), 1e-12);
}

TEST(Knob, GivesTheSameMotionInOneReportAsInTwo)
{
  AxesRig two(knobProfile(), test::knobDescriptor());
  AxesRig one(knobProfile(), test::combinedKnobDescriptor());
  two.takes(1, 100, -200, 50);
  two.takes(2, 30, -300, 70);
  std::vector<std::uint8_t> bytes{1};
  for (const int value : {100, -200, 50, 30, -300, 70}) {
    bytes.push_back(static_cast<std::uint8_t>(value & 0xff));
    bytes.push_back(static_cast<std::uint8_t>((value >> 8) & 0xff));
  }
  one.takes(bytes);
  EXPECT_EQ(one.hand.position_D, two.hand.position_D);
  EXPECT_EQ(one.hand.rotation_D, two.hand.rotation_D);
}

TEST(Knob, AllocatesNothingInATick)
{
  using perilymph::test::AllocationGuard;
  if (!AllocationGuard::isAvailable()) GTEST_SKIP() << AllocationGuard::whyNot();
  AxesRig rig(knobProfile(), test::knobDescriptor());
  RawReport report;
  report.size = 7;
  const AllocationGuard guard;
  for (std::uint8_t i = 0; i < 100; ++i) {
    report.bytes = {static_cast<std::uint8_t>(1 + i % 2), i, 1, i, 0, i, 0};
    rig.codec->decode(report, rig.hand);
  }
  EXPECT_EQ(guard.allocations(), 0u);
}

TEST(Knob, StopsAtTheEdgeOfItsWorkspace)
{
  AxesRig rig(knobProfile(), test::knobDescriptor());
  for (int i = 0; i < 1000; ++i) rig.takes(1, 350, 0, 0);
  EXPECT_DOUBLE_EQ(rig.hand.position_D[0], 60e-3);
}

}  // namespace
}  // namespace perilymph::device
