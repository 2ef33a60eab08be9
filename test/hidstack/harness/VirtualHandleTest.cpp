// SPDX-License-Identifier: BSD-3-Clause

// Reports of the virtual handle, their timing, and its response to received ones.

#include "VirtualHandle.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "perilymph/test/Tolerance.h"

namespace perilymph::hidstack {
namespace {

constexpr std::int64_t millisecond = 1'000'000;  // [ns]

VirtualHandle handleOf(const std::string& script)
{
  return VirtualHandle(*scriptNamed(script), HandleBody{});
}

InputReport said(const VirtualHandle& handle) { return *decodeInput(handle.report()); }

/// Runs until a passage, with a host that writes zero force; false if it is never reached.
bool goTo(VirtualHandle& handle, const std::string& passage, std::int64_t& now)
{
  for (int i = 0; i < 10'000; ++i) {
    now += millisecond;
    if (!handle.tick(now)) return false;
    if (handle.ticks().back().passage == passage) return true;
    handle.take(OutputReport{}, now + millisecond / 10);
  }
  return false;
}

TEST(HandleReport, StandsInBytesAsTheDescriptorSays)
{
  InputReport report;
  report.sequence = 0x1234;
  report.place = {1, -1, 0x01020304};
  report.buttons = 1;
  // Number, then each field with its lowest byte first (HID 1.11, section 5.8).
  const std::array<std::uint8_t, inputSize> expected{1,    0x34, 0x12, 1,    0,    0,    0,    0xFF,
                                                     0xFF, 0xFF, 0xFF, 0x04, 0x03, 0x02, 0x01, 1};
  EXPECT_EQ(encode(report), expected);
  const std::array<std::uint8_t, outputSize> force{2, 0xFE, 0xFF, 0, 0, 0x10, 0x27};
  EXPECT_EQ(decodeOutput(force)->force, (std::array<std::int16_t, 3>{-2, 0, 10000}));
}

TEST(HandleReport, IsNotTakenFromOtherBytes)
{
  std::array<std::uint8_t, outputSize> force{2};
  force[0] = 3;
  EXPECT_FALSE(decodeOutput(force));
  force[0] = 2;
  EXPECT_FALSE(decodeOutput({force.data(), outputSize - 1}));
  EXPECT_FALSE(decodeInput(force));
}

TEST(VirtualHandle, CountsItsReports)
{
  VirtualHandle handle = handleOf("stream");
  handle.tick(millisecond);
  const std::uint16_t first = said(handle).sequence;
  handle.tick(2 * millisecond);
  EXPECT_EQ(said(handle).sequence, first + 1);
}

TEST(VirtualHandle, WaitsUntilTheHostIsHeard)
{
  VirtualHandle handle = handleOf("session");
  for (int i = 1; i <= 3000; ++i) handle.tick(i * millisecond);
  EXPECT_EQ(handle.ticks().back().passage, "greeting");
  handle.take(OutputReport{}, 3000 * millisecond + 1);
  handle.tick(3001 * millisecond);
  EXPECT_NE(handle.ticks().back().passage, "greeting");
}

TEST(VirtualHandle, SlidesTowardMinusZWhileTheHandPushes)
{
  VirtualHandle handle = handleOf("session");
  std::int64_t now = 0;
  ASSERT_TRUE(goTo(handle, "slide", now));
  EXPECT_EQ(said(handle).place[2], 0);
  EXPECT_EQ(said(handle).buttons, 1);
  handle.tick(now + 10 * millisecond);
  // x = F t^2 / 2 m while damping is negligible.
  const double way = 0.5 * pushAtRest / HandleBody{}.mass * 0.01 * 0.01;
  EXPECT_NEAR(-said(handle).place[2] * placeQuantum, way,
              test::tolerance(0.03 * way, "the bearings"));
}

TEST(VirtualHandle, IsHeldBackByAForceTowardTheUser)
{
  VirtualHandle handle = handleOf("session");
  std::int64_t now = 0;
  ASSERT_TRUE(goTo(handle, "slide", now));
  OutputReport force;
  force.force[2] = static_cast<std::int16_t>(std::lround(pushAtRest / forceQuantum));
  handle.take(force, now);
  handle.tick(now + 10 * millisecond);
  EXPECT_EQ(said(handle).place[2], 0);
}

TEST(VirtualHandle, WithAFlippedForceIsDrawnOn)
{
  VirtualHandle handle = handleOf("flipped");
  std::int64_t now = 0;
  ASSERT_TRUE(goTo(handle, "slide", now));
  OutputReport force;
  force.force[2] = static_cast<std::int16_t>(std::lround(pushAtRest / forceQuantum));
  handle.take(force, now);
  handle.tick(now + 10 * millisecond);
  const double way = pushAtRest / HandleBody{}.mass * 0.01 * 0.01;
  EXPECT_NEAR(-said(handle).place[2] * placeQuantum, way,
              test::tolerance(0.03 * way, "the bearings"));
}

TEST(VirtualHandle, LosesOneReportOrSendsOneTwice)
{
  for (const auto& [script, expected] : {std::pair{"lost", -1}, std::pair{"repeated", 1}}) {
    VirtualHandle handle = handleOf(script);
    int reports = 0, ticks = 0;
    while (handle.tick((ticks + 1) * millisecond)) {
      ++ticks;
      reports += handle.reportsDue();
    }
    EXPECT_EQ(reports, ticks + expected) << script;
  }
}

TEST(VirtualHandle, IsBackAtItsStartAfterAnUnplug)
{
  VirtualHandle handle = handleOf("session");
  std::int64_t now = 0;
  ASSERT_TRUE(goTo(handle, "unplugged", now));
  EXPECT_EQ(handle.reportsDue(), 0);
  EXPECT_EQ(handle.slider().force(), 0.0);
  ASSERT_TRUE(goTo(handle, "greeting", now));
  EXPECT_EQ(said(handle).place[2], 0);
  EXPECT_EQ(said(handle).buttons, 0);
  EXPECT_TRUE(goTo(handle, "rest_again", now));
}

TEST(HandleScript, OfAnotherNameIsRefusedWithTheNamesThereAre)
{
  const auto script = scriptNamed("dance");
  ASSERT_FALSE(script);
  EXPECT_NE(script.error().message.find("'dance'"), std::string::npos);
  EXPECT_NE(script.error().message.find("doubled"), std::string::npos);
}

}  // namespace
}  // namespace perilymph::hidstack
