// SPDX-License-Identifier: BSD-3-Clause
#include "hid/ReportCount.h"

#include <gtest/gtest.h>

namespace perilymph::device {
namespace {

using Verdict = ReportCount::Verdict;

constexpr std::int64_t millisecond = 1'000'000;  // [ns]

/// A device at 1 kHz whose reports arrived in time up to `counter`.
ReportCount heardUpTo(std::uint64_t counter)
{
  ReportCount count(1e-3);
  for (std::uint64_t i = 1; i <= counter; ++i)
    count.classify(i, static_cast<std::int64_t>(i) * millisecond);
  return count;
}

TEST(ReportCount, CallsEveryNextReportFresh)
{
  ReportCount count(1e-3);
  for (std::uint64_t i = 1; i <= 5000; ++i) {
    ASSERT_EQ(count.classify(i, static_cast<std::int64_t>(i) * millisecond), Verdict::fresh);
    ASSERT_EQ(count.lost(), 0u);
  }
}

TEST(ReportCount, SeesARepeatedReport)
{
  ReportCount count = heardUpTo(10);
  EXPECT_EQ(count.classify(10, 11 * millisecond), Verdict::duplicate);
}

TEST(ReportCount, SeesAnOvertakenReport)
{
  ReportCount count = heardUpTo(10);
  EXPECT_EQ(count.classify(9, 11 * millisecond), Verdict::old);
  EXPECT_EQ(count.classify(11, 12 * millisecond), Verdict::fresh);
}

TEST(ReportCount, CountsTheReportsThatAreMissing)
{
  ReportCount count = heardUpTo(10);
  EXPECT_EQ(count.classify(14, 14 * millisecond), Verdict::fresh);
  EXPECT_EQ(count.lost(), 3u);  // 11, 12, 13
}

TEST(ReportCount, KnowsThatAReportWaited)
{
  // no reading for 300 ms; the report of millisecond 11 arrives at 310
  ReportCount count = heardUpTo(10);
  EXPECT_EQ(count.classify(11, 310 * millisecond), Verdict::old);
  EXPECT_EQ(count.classify(310, 311 * millisecond), Verdict::fresh);
}

TEST(ReportCount, AcceptsADeviceThatPausedWithoutCounting)
{
  for (const std::int64_t pause : {20, 50, 200, 1000}) {
    ReportCount count(1e-3);
    std::int64_t now = 0;
    std::uint64_t counter = 0;
    for (int i = 0; i < 100; ++i) {
      now += millisecond;
      count.classify(++counter, now, now);
    }
    // The queue was empty all the time, so the next report has just arrived.
    now += pause * millisecond;
    EXPECT_EQ(count.classify(++counter, now + millisecond, now), ReportCount::Verdict::fresh)
        << pause;
    // A report that waits in the queue afterwards is detected as before.
    now += millisecond;
    EXPECT_EQ(count.classify(++counter, now + 100 * millisecond, now), ReportCount::Verdict::old);
  }
}

TEST(ReportCount, FollowsCountersOfAllWidthsOverTheirEnd)
{
  for (const std::uint64_t end : {256ull, 65536ull, 4294967296ull}) {
    ReportCount count(1e-3);
    std::int64_t now = 0;
    for (int i = 0; i < 40; ++i, now += millisecond) {
      const std::uint64_t counter = (end - 20 + static_cast<std::uint64_t>(i)) % end;
      ASSERT_EQ(count.classify(counter, now), Verdict::fresh) << end << ", " << i;
      ASSERT_EQ(count.lost(), 0u) << end << ", " << i;
    }
  }
}

TEST(ReportCount, RestartsWithADeviceThatRestarts)
{
  ReportCount count = heardUpTo(5000);
  EXPECT_EQ(count.classify(1, 5001 * millisecond), Verdict::fresh);
  EXPECT_EQ(count.classify(2, 5002 * millisecond), Verdict::fresh);
  EXPECT_EQ(count.lost(), 0u);
}

TEST(ReportCount, AcceptsADeviceWithoutACounter)
{
  ReportCount count(1e-3);
  for (int i = 0; i < 100; ++i) ASSERT_EQ(count.classify(0, i * millisecond), Verdict::fresh);
}

TEST(ReportCount, ToleratesADeviceClockThatDiffersByOnePercent)
{
  for (const double fraction : {0.99, 1.01}) {
    ReportCount count(1e-3);
    for (std::uint64_t i = 1; i <= 100'000; ++i) {
      const auto now = static_cast<std::int64_t>(static_cast<double>(i) * fraction * 1e6);
      ASSERT_EQ(count.classify(i, now), Verdict::fresh) << fraction << ", " << i;
    }
  }
}

}  // namespace
}  // namespace perilymph::device
