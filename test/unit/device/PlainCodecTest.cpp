// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "codec/DeviceCodec.h"
#include "codec/DeviceProfile.h"
#include "perilymph/foundation/Resources.h"
#include "perilymph/test/AllocationGuard.h"
#include "perilymph/test/DeviceProfiles.h"

namespace perilymph::device {
namespace {

using testing::HasSubstr;

/// Report 2 of 8 bytes: a counter of 16 bits, x, y, z. Report 5 of 7 bytes: one byte, then forces.
DeviceProfile vectorProfile(const std::string& more = "")
{
  const auto profile = parseProfile(test::profileHead("vector") + R"(nominal_period_ms = 1.0
max_force_N = 2.0
[input]
report = 2
bytes = 9
bits = 16
first_bits = [16, 32, 48]
quantum_mm = [0.01, 0.01, 0.02]
counter_bit = 0
counter_bits = 16
buttons_bit = 64
buttons = 8
[output]
report = 5
bytes = 7
bits = 16
first_bits = [8, 24, 40]
quantum_N = [0.001, 0.001, 0.001]
)" + more,
                                    "vector.toml");
  EXPECT_TRUE(profile) << (profile ? "" : profile.error().message);
  return *profile;
}

DeviceProfile woodenHaptics()
{
  return *loadProfile(resource("plugins/devices/forsslund/woodenhaptics.toml"));
}

RawReport report(const std::vector<std::uint8_t>& bytes)
{
  RawReport raw;
  raw.size = bytes.size();
  std::copy(bytes.begin(), bytes.end(), raw.bytes.begin());
  return raw;
}

/// Number 0, then 16-bit numbers, lowest byte first.
RawReport shorts(const std::vector<int>& values)
{
  std::vector<std::uint8_t> bytes{0};
  for (const int value : values) {
    bytes.push_back(static_cast<std::uint8_t>(value & 0xff));
    bytes.push_back(static_cast<std::uint8_t>((value >> 8) & 0xff));
  }
  return report(bytes);
}

int shortAt(const RawReport& raw, std::size_t byte)
{
  return static_cast<std::int16_t>(raw.bytes[byte] | raw.bytes[byte + 1] << 8);
}

class Wire final : public Transport {
public:
  std::vector<RawReport> written;
  Transfer answer = Transfer::done;
  Transfer read(RawReport&, Duration) noexcept override { return Transfer::nothing; }
  Transfer write(const RawReport& raw) noexcept override
  {
    written.push_back(raw);
    return answer;
  }
  Transfer setFeature(const RawReport& raw) noexcept override { return write(raw); }
  Transfer getFeature(RawReport&) noexcept override { return Transfer::failed; }
};

TEST(VectorDevice, TellsPlaceButtonsAndItsOwnCount)
{
  const auto codec = *makeCodec(vectorProfile(), {});
  DeviceSample hand;
  const auto count =
      codec->decode(report({2, 0xff, 0xfe, 0x64, 0x00, 0x9c, 0xff, 0x01, 0x00, 0x01}), hand);
  EXPECT_EQ(count, 0xfeffu);
  EXPECT_NEAR(hand.position_D[0], 1e-3, 1e-15);
  EXPECT_NEAR(hand.position_D[1], -1e-3, 1e-15);
  EXPECT_NEAR(hand.position_D[2], 0.02e-3, 1e-15);
  EXPECT_EQ(hand.buttons, graspButton);
}

TEST(VectorDevice, IgnoresShortAndForeignReports)
{
  const auto codec = *makeCodec(vectorProfile(), {});
  DeviceSample hand;
  EXPECT_FALSE(codec->decode(report({2, 0, 0, 1, 1}), hand));
  EXPECT_FALSE(codec->decode(report({3, 0, 0, 1, 1, 1, 1, 1, 1, 1}), hand));
  EXPECT_FALSE(codec->decode(report({}), hand));
  EXPECT_EQ(hand.position_D, (std::array<double, 3>{}));
}

TEST(VectorDevice, GetsTheForceInItsResolution)
{
  const auto codec = *makeCodec(vectorProfile(), {});
  ReportList reports;
  codec->encode({{0.5, -0.25, 1.0}, {}}, reports);
  ASSERT_EQ(reports.count, 1u);
  EXPECT_EQ(reports.reports[0].size, 8u);
  EXPECT_EQ(reports.reports[0].bytes[0], 5);
  EXPECT_EQ(reports.reports[0].bytes[1], 0);
  EXPECT_EQ(shortAt(reports.reports[0], 2), 500);
  EXPECT_EQ(shortAt(reports.reports[0], 4), -250);
  EXPECT_EQ(shortAt(reports.reports[0], 6), 1000);
}

TEST(VectorDevice, GetsAtMostItsMaximumForceInTheSameDirection)
{
  const auto codec = *makeCodec(vectorProfile(), {});
  ReportList reports;
  codec->encode({{0.0, 300.0, -400.0}, {}}, reports);
  EXPECT_EQ(shortAt(reports.reports[0], 4), 1200);
  EXPECT_EQ(shortAt(reports.reports[0], 6), -1600);
  codec->encode({{std::numeric_limits<double>::infinity(), 0.0, 0.0}, {}}, reports);
  EXPECT_EQ(shortAt(reports.reports[0], 2), 0);
}

TEST(VectorDevice, FeelsTheForceWhereItsMountTurnedIt)
{
  // The device's x is D's y: what pushes along D's y goes out along the device's x.
  const auto codec =
      *makeCodec(vectorProfile("[mount]\nrotation = [0, -1, 0, 1, 0, 0, 0, 0, 1]"), {});
  DeviceSample hand;
  codec->decode(report({2, 0, 0, 0x64, 0, 0, 0, 0, 0, 0}), hand);
  EXPECT_NEAR(hand.position_D[1], 1e-3, 1e-15);
  ReportList reports;
  codec->encode({{0.0, 1.0, 0.0}, {}}, reports);
  EXPECT_EQ(shortAt(reports.reports[0], 2), 1000);
}

TEST(VectorDevice, StartsAndEndsWithZeroForce)
{
  const auto codec = *makeCodec(vectorProfile("[[on_open]]\nkind = \"feature\"\nbytes = [7, 1]\n"
                                              "[[on_close]]\nkind = \"output\"\nbytes = [7, 0]"),
                                {});
  Wire wire;
  ASSERT_TRUE(codec->begin(wire));
  ASSERT_EQ(wire.written.size(), 2u);
  EXPECT_EQ(wire.written[0].bytes[0], 7);
  EXPECT_EQ(wire.written[0].bytes[1], 1);
  EXPECT_EQ(shortAt(wire.written[1], 2), 0);
  wire.written.clear();
  codec->end(wire);
  ASSERT_GE(wire.written.size(), 2u);
  EXPECT_EQ(wire.written.front().bytes[0], 5);
  EXPECT_EQ(shortAt(wire.written.front(), 2), 0);
  EXPECT_EQ(wire.written.back().bytes[0], 7);
}

TEST(VectorDevice, ThatTakesNoReportIsAnsweredWithASentence)
{
  const auto codec = *makeCodec(vectorProfile(), {});
  Wire wire;
  wire.answer = Transfer::failed;
  const auto begun = codec->begin(wire);
  ASSERT_FALSE(begun);
  EXPECT_THAT(begun.error().message, HasSubstr("did not take a force of zero (report 5, 8 bytes)"));
}

TEST(VectorDevice, WithShorterReportsThanItsProfileIsRefused)
{
  const auto descriptor = *ReportDescriptor::parse(std::vector<std::uint8_t>{
      0x85, 0x02, 0x75, 0x08, 0x95, 0x04, 0x15, 0x00, 0x25, 0x7f, 0x81, 0x02});
  const auto codec = makeCodec(vectorProfile(), descriptor);
  ASSERT_FALSE(codec);
  EXPECT_THAT(codec.error().message, HasSubstr("input report 2 should have 9 bytes and has 4"));
}

TEST(WoodenHaptics, StandsAtTheOriginWhereItsArmIsAtRightAngles)
{
  // z = h + Lb cos b - Lc cos c with b = c = 90 deg is h; x = Lb + Lc = 450 mm, 230 past the
  // origin. B's x is D's z. A quarter turn of a 120 mm body is 3 turns of a 10 mm capstan.
  const auto codec = *makeCodec(woodenHaptics(), {});
  DeviceSample hand;
  ASSERT_TRUE(codec->decode(shorts({0, 6000, 6000, 0, 0, 0, 0}), hand));
  EXPECT_NEAR(hand.position_D[0], 0.0, 1e-12);
  EXPECT_NEAR(hand.position_D[1], 0.0, 1e-12);
  EXPECT_NEAR(hand.position_D[2], 0.230, 1e-12);
}

TEST(WoodenHaptics, PushesUpWithTheTorquesOfItsLevers)
{
  // At right angles only the links carry an upward force: torques -Lb F and Lc F; each motor turns
  // 12 times as fast, so I = torque / 12 / 0.0259 N.m/A.
  const auto codec = *makeCodec(woodenHaptics(), {});
  DeviceSample hand;
  codec->decode(shorts({0, 6000, 6000, 0, 0, 0, 0}), hand);
  ReportList reports;
  codec->encode({{0.0, 1.0, 0.0}, {}}, reports);
  ASSERT_EQ(reports.count, 1u);
  EXPECT_EQ(reports.reports[0].size, 15u);  // 14 bytes and the number 0
  EXPECT_EQ(shortAt(reports.reports[0], 1), 0);
  EXPECT_EQ(shortAt(reports.reports[0], 3), -std::lround(1000 * 0.205 / 12 / 0.0259));
  EXPECT_EQ(shortAt(reports.reports[0], 5), std::lround(1000 * 0.245 / 12 / 0.0259));
  EXPECT_EQ(shortAt(reports.reports[0], 7), 0) << "no command";
}

TEST(WoodenHaptics, GetsTheCommandToSetItsCountsOnceWhenItsButtonIsPressed)
{
  const auto codec = *makeCodec(woodenHaptics(), {});
  DeviceSample hand;
  codec->decode(shorts({1, 2, 3, 0, 0, 0, 1}), hand);
  ReportList reports;
  codec->encode({{0.0, 3.0, 0.0}, {}}, reports);
  EXPECT_EQ(shortAt(reports.reports[0], 7), 1) << "the command";
  EXPECT_EQ(shortAt(reports.reports[0], 9), 0);
  EXPECT_EQ(shortAt(reports.reports[0], 13), 6000);
  for (const std::size_t byte : {1u, 3u, 5u}) EXPECT_EQ(shortAt(reports.reports[0], byte), 0);
  codec->encode({{0.0, 3.0, 0.0}, {}}, reports);
  EXPECT_EQ(shortAt(reports.reports[0], 7), 0) << "only once";
}

TEST(WoodenHapticsTick, AllocatesNothing)
{
  if (!test::AllocationGuard::isAvailable()) GTEST_SKIP() << test::AllocationGuard::whyNot();
  const auto codec = *makeCodec(woodenHaptics(), {});
  const RawReport counts = shorts({10, 5000, 6000, 0, 0, 0, 1});
  DeviceSample hand;
  ReportList reports;
  const test::AllocationGuard guard;
  for (int i = 0; i < 100; ++i) {
    codec->decode(counts, hand);
    codec->encode({{0.1 * i, 1.0, -1.0}, {}}, reports);
  }
  EXPECT_EQ(guard.allocations(), 0u);
}

TEST(WoodenHapticsTraits, AreThoseOfItsMakers)
{
  const DeviceTraits traits = traitsOf(woodenHaptics());
  EXPECT_EQ(traits.maxForce, 5.0);
  EXPECT_EQ(traits.actuatedTranslations, 3);
  EXPECT_EQ(traits.reporting, Reporting::onWrite);
  EXPECT_EQ(traits.watchdog, 0.5);
  // The handle on a stretched arm of 450 mm moves 2 pi 450 / (2000 x 16) mm a count of the base.
  EXPECT_NEAR(traits.positionQuantum, 2 * 3.14159265 * 0.450 / 32000, 2e-8);
}

}  // namespace
}  // namespace perilymph::device
