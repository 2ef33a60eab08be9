// SPDX-License-Identifier: BSD-3-Clause
#include "hid/ReportReader.h"

#include <gtest/gtest.h>

#include <cmath>

#include "VirtualTime.h"
#include "perilymph/test/AllocationGuard.h"
#include "perilymph/test/FakeHid.h"

namespace perilymph::device {
namespace {

using test::FakeHid;
using test::FakeReport;

/// A reader of a device that reports every millisecond of a simulated time.
class Reading : public testing::Test {
protected:
  Reading() { virtualNow = 1000 * millisecond; }

  /// Sends report `number`, whose position along x is number x 10 um.
  void send(std::uint16_t number)
  {
    FakeReport report;
    report.counter = number;
    report.place_10um[0] = static_cast<std::int16_t>(number);
    hid.send(report);
  }
  /// The next report at the next millisecond.
  void sendNext()
  {
    virtualNow += millisecond;
    send(++counter);
  }
  double placeInSteps() const { return reader.newest().position_D[0] / 1e-5; }

  FakeHid hid;
  test::FakeCodec codec;
  std::unique_ptr<Transport> transport = hid.open();
  ReportReader reader{codec, 1e-3, virtualClock};
  std::uint16_t counter = 0;
};

TEST_F(Reading, TakesTheNewestOfManyReports)
{
  for (int i = 0; i < 7; ++i) sendNext();
  EXPECT_EQ(reader.drain(*transport), Transfer::done);
  EXPECT_NEAR(placeInSteps(), 7.0, 1e-9);
  EXPECT_EQ(reader.newest().sequence, 7u);
}

TEST_F(Reading, GivesNoSampleWithoutAReport)
{
  EXPECT_EQ(reader.drain(*transport), Transfer::nothing);
  sendNext();
  EXPECT_EQ(reader.drain(*transport), Transfer::done);
  EXPECT_EQ(reader.drain(*transport), Transfer::nothing);
  EXPECT_EQ(reader.newest().sequence, 1u);
}

TEST_F(Reading, LosesAndRepeatsNothingInFiveThousandReports)
{
  for (int i = 0; i < 5000; ++i) {
    sendNext();
    reader.drain(*transport);
  }
  EXPECT_EQ(reader.figures().fresh, 5000u);
  EXPECT_EQ(reader.figures().lost + reader.figures().duplicates + reader.figures().old, 0u);
  EXPECT_NEAR(reader.figures().rate, 1000.0, 1.0);
}

TEST_F(Reading, ShowsAHoleInTheTimingOfTheWholeTestThoughTheLastSecondIsRegular)
{
  const auto run = [this](int reports) {
    for (int i = 0; i < reports; ++i) {
      sendNext();
      reader.drain(*transport);
    }
  };
  run(1000);
  virtualNow += 700 * millisecond;
  reader.reset();  // reconnected
  run(2500);
  const ReadingFigures figures = reader.figures();
  EXPECT_NEAR(figures.intervalMax, 1e-3, 1e-5);
  EXPECT_NEAR(figures.overall.intervalMax, 0.7, 0.01);
  EXPECT_NEAR(figures.overall.intervalMedian, 1e-3, 5e-5);
  EXPECT_NEAR(figures.overall.rate, 3499.0 / 4.2, 2.0);
}

TEST_F(Reading, RejectsAnOverflowedQueue)
{
  for (int i = 0; i < 10; ++i) {
    sendNext();
    reader.drain(*transport);
  }
  // not read for 300 ms: the 63 oldest reports are kept
  for (int i = 0; i < 300; ++i) sendNext();
  EXPECT_EQ(reader.drain(*transport), Transfer::nothing);
  EXPECT_NEAR(placeInSteps(), 10.0, 1e-9);
  EXPECT_EQ(reader.figures().old, 63u);

  sendNext();
  EXPECT_EQ(reader.drain(*transport), Transfer::done);
  EXPECT_NEAR(placeInSteps(), 311.0, 1e-9);
}

TEST_F(Reading, RejectsAnOverflowedQueueWithoutACounter)
{
  for (int i = 0; i < 100; ++i) send(0);
  EXPECT_EQ(reader.drain(*transport), Transfer::nothing);
  EXPECT_EQ(reader.newest().sequence, 0u);
  send(0);
  EXPECT_EQ(reader.drain(*transport), Transfer::done);
}

TEST_F(Reading, IgnoresAnOvertakenReport)
{
  for (int i = 0; i < 5; ++i) sendNext();
  send(3);
  EXPECT_EQ(reader.drain(*transport), Transfer::done);
  EXPECT_NEAR(placeInSteps(), 5.0, 1e-9);
  EXPECT_EQ(reader.figures().old, 1u);
}

TEST_F(Reading, CallsARepeatedReportNotFresh)
{
  sendNext();
  reader.drain(*transport);
  send(counter);
  EXPECT_EQ(reader.drain(*transport), Transfer::nothing);
  EXPECT_EQ(reader.figures().duplicates, 1u);
}

TEST_F(Reading, DoesNotUseGarbage)
{
  sendNext();
  reader.drain(*transport);
  RawReport garbage;
  garbage.bytes.fill(0xff);
  for (const std::size_t size : {std::size_t{0}, std::size_t{1}, std::size_t{9}, longestReport}) {
    garbage.size = size;
    hid.send(garbage);
  }
  EXPECT_EQ(reader.drain(*transport), Transfer::nothing);
  EXPECT_NEAR(placeInSteps(), 1.0, 1e-9);
  EXPECT_EQ(reader.figures().foreign, 4u);
}

TEST_F(Reading, KeepsAnAwaitedReportForTheTick)
{
  hid.whenWaiting([this](Duration) { sendNext(); });
  EXPECT_EQ(reader.await(*transport, Duration::fromSi(2e-3)), Transfer::done);
  EXPECT_EQ(reader.newest().sequence, 0u);  // not yet processed
  EXPECT_EQ(reader.drain(*transport), Transfer::done);
  EXPECT_EQ(reader.newest().sequence, 1u);
}

TEST_F(Reading, CountsTheAwaitedReportIntoAQueueThatRanOver)
{
  for (int i = 0; i < 63; ++i) sendNext();
  EXPECT_EQ(reader.await(*transport, Duration::fromSi(2e-3)), Transfer::done);
  EXPECT_EQ(reader.drain(*transport), Transfer::nothing);
}

TEST_F(Reading, SaysThatTheDeviceIsGone)
{
  sendNext();
  hid.unplug();
  EXPECT_EQ(reader.drain(*transport), Transfer::gone);
  hid.plugIn();
  EXPECT_EQ(reader.drain(*transport), Transfer::gone);  // this handle stays invalid
}

TEST_F(Reading, AllocatesNothing)
{
  if (!test::AllocationGuard::isAvailable()) GTEST_SKIP() << test::AllocationGuard::whyNot();
  for (int i = 0; i < 60; ++i) sendNext();
  const test::AllocationGuard guard;
  reader.drain(*transport);
  EXPECT_EQ(guard.allocations(), 0u);
}

}  // namespace
}  // namespace perilymph::device
