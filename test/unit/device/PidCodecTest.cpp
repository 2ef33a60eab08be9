// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "Descriptors.h"
#include "PidDevice.h"
#include "codec/DeviceCodec.h"
#include "codec/DeviceProfile.h"
#include "perilymph/test/AllocationGuard.h"
#include "perilymph/test/DeviceProfiles.h"

namespace perilymph::device {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

ReportDescriptor stick() { return *ReportDescriptor::parse(test::pidDescriptor()); }

DeviceProfile profileWith(const std::string& pid)
{
  const auto profile = parseProfile(
      perilymph::test::profileHead("pid", "contains_page = 0x0f\ncontains_usage = 0x21") +
          R"(max_force_N = 4.0
nominal_period_ms = 1.0
[axes]
motion = "place"
x = "x"
z = "y"
travel_mm = 40.0
[pid]
)" + pid,
      "stick.toml");
  EXPECT_TRUE(profile) << (profile ? "" : profile.error().message);
  return *profile;
}

struct PidRig {
  explicit PidRig(const std::string& pid) : codec(*makeCodec(profileWith(pid), stick())) {}

  void show(double x_N, double z_N)
  {
    Wrench wrench_D;
    wrench_D.force_D = {x_N, 0.0, z_N};
    ReportList reports;
    codec->encode(wrench_D, reports);
    for (std::size_t i = 0; i < reports.count; ++i)
      EXPECT_EQ(device.write(reports.reports[i]), Transfer::done);
  }

  test::PidDevice device;
  std::unique_ptr<DeviceCodec> codec;
};

constexpr const char* byAxes = "effects = \"axes\"";
constexpr const char* byPolar = "effects = \"polar\"\ndirections_deg = [270, 0, 0]";
constexpr const char* byDirection = "effects = \"direction\"";

// One step of a direction of 8 bits is 1.4 degrees; of a magnitude 1/10000.
constexpr double directionStep = 0.025;

TEST(PidDevice, IsQuietUntilItsActuatorsAreEnabledAsTheLastThing)
{
  PidRig rig(byPolar);
  ASSERT_TRUE(rig.codec->begin(rig.device));
  EXPECT_THAT(rig.device.story,
              ElementsAre("stop all", "reset", "gain", "create", "effect", "force", "start",
                          "create", "effect", "force", "start", "enable"));
  EXPECT_EQ(rig.device.gain, 255);
  EXPECT_EQ(rig.device.shown()[0], 0.0);
}

TEST(PidDevice, GetsUsagesInTheOrderOfItsDescriptor)
{
  // This device lists "disable" before "enable" and ramp before constant force.
  PidRig rig(byAxes);
  rig.device.actuatorsOn = false;
  ASSERT_TRUE(rig.codec->begin(rig.device));
  EXPECT_TRUE(rig.device.actuatorsOn);
  EXPECT_TRUE(rig.device.effects[1].isConstantForce);
  rig.codec->end(rig.device);
  EXPECT_FALSE(rig.device.actuatorsOn);
}

TEST(PidDevice, ShowsTheForceInEveryWayOfTellingADirection)
{
  for (const char* pid : {byAxes, byPolar, byDirection}) {
    PidRig rig(pid);
    ASSERT_TRUE(rig.codec->begin(rig.device)) << pid;
    for (const auto& [x, z] : {std::pair{2.0, 0.0},
                               {-2.0, 0.0},
                               {0.0, 1.0},
                               {0.0, -1.0},
                               {1.0, 1.0},
                               {-1.5, 0.5},
                               {0.3, -2.4}}) {
      rig.show(x, z);
      EXPECT_NEAR(rig.device.shown()[0] * 4.0, x, 4.0 * directionStep) << pid;
      EXPECT_NEAR(rig.device.shown()[1] * 4.0, z, 4.0 * directionStep) << pid;
    }
  }
}

TEST(PidDevice, KeepsTheDirectionOfAForceThatIsTooGreat)
{
  PidRig rig(byAxes);
  ASSERT_TRUE(rig.codec->begin(rig.device));
  rig.show(30.0, 40.0);
  EXPECT_NEAR(rig.device.shown()[0], 0.6, 1e-4);
  EXPECT_NEAR(rig.device.shown()[1], 0.8, 1e-4);
}

TEST(PidDevice, GetsNoForceThatIsNoNumber)
{
  PidRig rig(byAxes);
  ASSERT_TRUE(rig.codec->begin(rig.device));
  rig.show(2.0, 2.0);
  rig.show(std::numeric_limits<double>::quiet_NaN(), 1.0);
  EXPECT_EQ(rig.device.shown()[0], 0.0);
  EXPECT_EQ(rig.device.shown()[1], 0.0);
}

TEST(PidDevice, GetsNothingBeforeItsEffectsExist)
{
  PidRig rig(byAxes);
  ReportList reports;
  rig.codec->encode({{1.0, 0.0, 0.0}, {}}, reports);
  EXPECT_EQ(reports.count, 0u);
}

TEST(PidDevice, NeedsAReportForEachAxisAndTick)
{
  PidRig rig(byAxes);
  ASSERT_TRUE(rig.codec->begin(rig.device));
  ReportList reports;
  rig.codec->encode({{1.0, 0.0, 0.0}, {}}, reports);
  EXPECT_EQ(reports.count, 2u);
}

TEST(PidDevice, RunsItsEffectsWithoutEndAtFullGain)
{
  PidRig rig(byPolar);
  ASSERT_TRUE(rig.codec->begin(rig.device));
  EXPECT_EQ(rig.device.effects[1].duration, 0xffff);
  EXPECT_EQ(rig.device.effects[1].gain, 255);
}

TEST(PidDevice, IsLeftWithoutForceEffectsOrActuators)
{
  PidRig rig(byAxes);
  ASSERT_TRUE(rig.codec->begin(rig.device));
  rig.show(2.0, 1.0);
  rig.device.story.clear();
  rig.codec->end(rig.device);
  EXPECT_THAT(rig.device.story,
              ElementsAre("force", "force", "stop all", "free", "free", "disable"));
  EXPECT_FALSE(rig.device.effects[1].exists);
}

TEST(PidDevice, MayAnswerSlowly)
{
  PidRig rig(byAxes);
  rig.device.slowAnswers = 5;
  EXPECT_TRUE(rig.codec->begin(rig.device));
}

TEST(PidDevice, WithoutFreeMemoryIsAnErrorAndLeftWithoutForce)
{
  PidRig rig(byAxes);
  rig.device.capacity = 1;
  const auto begun = rig.codec->begin(rig.device);
  ASSERT_FALSE(begun);
  EXPECT_THAT(begun.error().message, HasSubstr("no room for effect 2"));
  EXPECT_FALSE(rig.device.actuatorsOn);
  EXPECT_FALSE(rig.device.effects[1].exists);
}

TEST(PidDevice, UnpluggedWhileItIsPreparedIsAnsweredWithASentence)
{
  for (int writes = 0; writes < 10; ++writes) {
    PidRig rig(byAxes);
    rig.device.writesBeforeUnplug = writes;
    const auto begun = rig.codec->begin(rig.device);
    ASSERT_FALSE(begun) << writes;
    EXPECT_THAT(begun.error().message, HasSubstr("went away"));
  }
}

TEST(PidProfile, IsRefusedWhereTheDescriptorLacksWhatItNeeds)
{
  const auto joystick = *ReportDescriptor::parse(test::joystickDescriptor());
  const auto codec = makeCodec(profileWith(byAxes), joystick);
  ASSERT_FALSE(codec);
  EXPECT_THAT(codec.error().message, HasSubstr("lacks Create New Effect"));
  EXPECT_THAT(codec.error().message, HasSubstr("stick.toml"));
}

TEST(PidTraits, TellTheStepOfForceAndPlaceFromTheDescriptor)
{
  const DeviceTraits traits = traitsOf(profileWith(byAxes), stick());
  EXPECT_TRUE(traits.rendersForce);
  EXPECT_EQ(traits.actuatedTranslations, 2);
  EXPECT_DOUBLE_EQ(traits.forceQuantum, 4.0 / 10000);
  EXPECT_DOUBLE_EQ(traits.positionQuantum, 0.040 / 32767);
  EXPECT_EQ(traits.buttons, 8);
}

TEST(PidTick, AllocatesNothing)
{
  if (!perilymph::test::AllocationGuard::isAvailable())
    GTEST_SKIP() << perilymph::test::AllocationGuard::whyNot();
  PidRig rig(byDirection);
  ASSERT_TRUE(rig.codec->begin(rig.device));
  RawReport report;
  report.bytes = {1, 0, 1, 0, 2, 1};
  report.size = 6;
  DeviceSample hand;
  ReportList reports;
  const perilymph::test::AllocationGuard guard;
  for (int i = 0; i < 100; ++i) {
    rig.codec->decode(report, hand);
    rig.codec->encode({{1.0, 0.0, 0.5 * i}, {}}, reports);
  }
  EXPECT_EQ(guard.allocations(), 0u);
}

}  // namespace
}  // namespace perilymph::device
