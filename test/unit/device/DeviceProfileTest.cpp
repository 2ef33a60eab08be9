// SPDX-License-Identifier: BSD-3-Clause
#include "codec/DeviceProfile.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "Descriptors.h"
#include "perilymph/foundation/AtomicFile.h"
#include "perilymph/foundation/Resources.h"
#include "perilymph/test/DeviceProfiles.h"

namespace perilymph::device {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

const std::string good = perilymph::test::stickProfile();

std::string with(std::string text, const std::string& old, const std::string& now)
{
  const auto at = text.find(old);
  EXPECT_NE(at, std::string::npos) << old;
  return text.replace(at, old.size(), now);
}

std::string error(const std::string& text)
{
  const auto profile = parseProfile(text, "test.toml");
  return profile ? "it was accepted" : profile.error().message;
}

ReportDescriptor descriptorOf(const std::vector<std::uint8_t>& bytes)
{
  return *ReportDescriptor::parse(bytes);
}

/// Vendor-defined reports, which no usage identifies.
ReportDescriptor vendorDescriptor()
{
  return descriptorOf({0x06, 0xab, 0xff, 0x0a, 0x00, 0x02, 0xa1, 0x01, 0x15,
                       0x00, 0x26, 0xff, 0x00, 0x75, 0x08, 0x95, 0x0e, 0x09,
                       0x01, 0x81, 0x02, 0x09, 0x02, 0x91, 0x02, 0xc0});
}

TEST(DeviceProfile, IsReadInSi)
{
  const auto profile = parseProfile(good, "test.toml");
  ASSERT_TRUE(profile);
  EXPECT_EQ(profile->traits.nominalPeriod, 0.01);
  EXPECT_EQ(profile->axes.travel, 0.015);
  EXPECT_EQ(profile->file, "test.toml");
}

TEST(ShippedProfiles, CanAllBeReadAndHaveNamesOfTheirOwn)
{
  const ProfileCatalog catalog = shippedProfiles();
  EXPECT_THAT(catalog.broken, IsEmpty());
  std::set<std::string> names;
  for (const DeviceProfile& profile : catalog.profiles) names.insert(profile.name);
  EXPECT_EQ(names.size(), catalog.profiles.size());
  EXPECT_GE(names.size(), 5u);
}

TEST(ShippedProfiles, FitTheDevicesTheyAreFor)
{
  const ProfileCatalog catalog = shippedProfiles();
  const auto nameOf = [&](HidIdentity identity, const ReportDescriptor& descriptor) {
    const DeviceProfile* profile = matchingProfile(catalog.profiles, identity, descriptor);
    return profile == nullptr ? std::string("none") : profile->name;
  };
  EXPECT_EQ(nameOf({0x1234, 0x0006, 0}, vendorDescriptor()), "WoodenHaptics");
  EXPECT_EQ(nameOf({0x046d, 0xc626, 0}, descriptorOf(test::knobDescriptor())), "SpaceMouse");
  EXPECT_EQ(nameOf({0x256f, 0xc635, 0}, descriptorOf(test::knobDescriptor())), "SpaceMouse");
  EXPECT_EQ(nameOf({0x256f, 0xc632, 0}, descriptorOf(test::combinedKnobDescriptor())),
            "SpaceMouse Wireless");
  EXPECT_EQ(nameOf({0x0001, 0x0001, 0}, descriptorOf(test::joystickDescriptor())), "Joystick");
  EXPECT_EQ(nameOf({0x1209, 0xffb0, 2}, descriptorOf(test::pidDescriptor())),
            "Force-feedback joystick");
  EXPECT_EQ(nameOf({0x0001, 0x0001, 0}, vendorDescriptor()), "none");
  EXPECT_EQ(nameOf({0x0001, 0x0001, 0}, ReportDescriptor()), "none");
}

TEST(MatchingProfile, PrefersWhatAsksForMore)
{
  std::vector<DeviceProfile> profiles(3);
  for (DeviceProfile& profile : profiles) profile.matches.resize(1);
  profiles[0].matches[0].usage = Usage{1, 4};
  profiles[1].matches[0].vendor = 7;
  profiles[1].matches[0].product = 8;
  profiles[2].matches[0].vendor = 7;
  profiles[2].matches[0].interfaceNumber = 3;
  const auto descriptor = descriptorOf(test::joystickDescriptor());
  EXPECT_EQ(matchingProfile(profiles, {7, 8, 3}, descriptor), &profiles[1]);
  EXPECT_EQ(matchingProfile(profiles, {7, 9, 3}, descriptor), &profiles[2]);
  EXPECT_EQ(matchingProfile(profiles, {7, 9, 1}, descriptor), &profiles[0]);
  EXPECT_EQ(matchingProfile({}, {7, 9, 1}, descriptor), nullptr);
}

TEST(FaultyProfile, IsAnsweredWithFileLineKeyValueAndRange)
{
  EXPECT_THAT(error(with(good, "travel_mm = 15.0", "travel_mm = 9000.0")),
              HasSubstr("test.toml:14: axes.travel_mm is 9000; it must be between 0.1 and 500"));
  EXPECT_THAT(error(with(good, "\"joystick\"", "\"gloves\"")), HasSubstr("test.toml:3: kind"));
  EXPECT_THAT(error(with(good, "x = \"x\"", "x = \"q\"")),
              HasSubstr("test.toml:13: axes.x is 'q'; it must be one of none, x"));
  EXPECT_THAT(error(with(good, "x = \"x\"\n", "")), HasSubstr("[axes] moves nothing"));
  EXPECT_THAT(error(good + "wheels = 4\n"), HasSubstr("wheels"));
  EXPECT_THAT(error(with(good, "usage = 4", "")), HasSubstr("belong together"));
  EXPECT_THAT(error(with(good, "usage_page = 1\nusage = 4", "interface = 1")),
              HasSubstr("it would take every device"));
  EXPECT_THAT(error(with(good, "usage_page = 1\nusage = 4", "product_id = 1")),
              HasSubstr("product_id means nothing without vendor_id"));
  EXPECT_THAT(error(with(good, "[[match]]\nusage_page = 1\nusage = 4\n", "")),
              HasSubstr("[[match]] is missing"));
  EXPECT_THAT(
      error(with(good, "nominal_period_ms = 10.0", "nominal_period_ms = 10.0\nmost_force_N = 1.0")),
      HasSubstr("renders no force"));
}

TEST(FaultyProfile, CannotMirrorTheHand)
{
  const std::string mount = good + "[mount]\nrotation = ";
  EXPECT_THAT(error(mount + "[1,0,0, 0,1,0, 0,0,1]"), HasSubstr("accepted"));
  EXPECT_THAT(error(mount + "[-1,0,0, 0,1,0, 0,0,1]"), HasSubstr("right-handed"));
  EXPECT_THAT(error(mount + "[1,0,0, 1,0,0, 0,0,1]"), HasSubstr("not a rotation matrix"));
  EXPECT_THAT(error(mount + "[0.5,0,0, 0,1,0, 0,0,1]"), HasSubstr("not a rotation matrix"));
}

const std::string vector = perilymph::test::profileHead("vector") + R"(nominal_period_ms = 1.0
max_force_N = 1.0
[input]
report = 1
bytes = 6
bits = 16
first_bits = [0, 16, 32]
quantum_mm = [0.01, 0.01, 0.01]
[output]
report = 1
bytes = 6
bits = 16
first_bits = [0, 16, 32]
quantum_N = [0.01, 0.01, 0.01]
)";

TEST(FaultyVectorProfile, CannotReachBeyondItsReports)
{
  EXPECT_THAT(error(vector), HasSubstr("accepted"));
  EXPECT_THAT(error(with(vector, "[0, 16, 32]", "[0, 16, 33]")),
              HasSubstr("first_bits has 33; with 16 bits that ends behind the report's 48 bits"));
  EXPECT_THAT(error(with(vector, "[0, 16, 32]", "[0, 16.5, 32]")), HasSubstr("whole numbers"));
  EXPECT_THAT(error(with(vector, "bits = 16", "bits = 40")), HasSubstr("between 2 and 32"));
  EXPECT_THAT(error(with(vector, "[0, 16, 32]", "[0, 16]")), HasSubstr("first_bits"));
}

TEST(ForceProfile, MayNotBeOfADeviceThatIsSilentAtRest)
{
  EXPECT_THAT(error(with(vector, "nominal_period_ms = 1.0",
                         "nominal_period_ms = 1.0\nreporting = \"on_change\"")),
              HasSubstr("must report all the time"));
}

TEST(ForceProfile, MayNotSteerBySpeed)
{
  std::string text = with(good, "\"joystick\"", "\"pid\"");
  text = with(text, "nominal_period_ms = 10.0", "nominal_period_ms = 1.0\nmost_force_N = 1.0");
  text = with(text, "motion = \"place\"", "motion = \"rate\"");
  text = with(text, "travel_mm = 15.0", "speed_mm_s = 5.0\n[pid]\neffects = \"axes\"");
  EXPECT_THAT(error(text), HasSubstr("the force belongs to a place"));
}

/// The shipped force-feedback stick with one more line of capabilities.
std::string stickThatSays(const std::string& line)
{
  const auto file = findByName("device profile", "plugins/devices", "pid");
  EXPECT_TRUE(file);
  return with(*readWhole(*file), "max_force_N = 3.0\n", "max_force_N = 3.0\n" + line + "\n");
}

TEST(DeviceProfile, SaysWhatIsKnownOfTheHandle)
{
  const auto profile =
      parseProfile(stickThatSays("handle_damping_N_s_m = 1.5\nhandle_mass_kg = 0.2"), "test.toml");
  ASSERT_TRUE(profile) << profile.error().message;
  EXPECT_EQ(profile->traits.handleDamping, 1.5);
  EXPECT_EQ(profile->traits.handleMass, 0.2);
}

TEST(DeviceProfile, RefusesAnImpossibleHandle)
{
  EXPECT_THAT(error(stickThatSays("handle_mass_kg = 200.0")), HasSubstr("handle_mass_kg"));
  EXPECT_THAT(error(stickThatSays("handle_damping_N_s_m = -1.0")),
              HasSubstr("handle_damping_N_s_m"));
  EXPECT_THAT(error(stickThatSays("handle_mass = 0.2")), HasSubstr("handle_mass"));
}

}  // namespace
}  // namespace perilymph::device
