// SPDX-License-Identifier: BSD-3-Clause

// The measures, for logs with known results.

#include "StackMeasures.h"

#include <gtest/gtest.h>

#include <fstream>
#include <numeric>
#include <vector>

#include "perilymph/test/TemporaryFolder.h"
#include "perilymph/test/Tolerance.h"

namespace perilymph::hidstack {
namespace {

constexpr std::int64_t microsecond = 1000;       // [ns]
constexpr std::int64_t millisecond = 1'000'000;  // [ns]
constexpr double quantum = 1e-4;                 // [N]
const double rounding = test::tolerance(1e-12, "rounding");

std::vector<ReportRow> stream(const std::vector<std::int64_t>& sequences)
{
  std::vector<ReportRow> rows;
  for (const std::int64_t sequence : sequences)
    rows.push_back({static_cast<std::int64_t>(rows.size()) * millisecond, sequence});
  return rows;
}

TEST(Stream, OfAThousandASecondHasThatRate)
{
  const StreamMeasure measure = streamIn(stream({1, 2, 3, 4, 5}));
  EXPECT_NEAR(measure.rate, 1000.0, 1000.0 * rounding);
  EXPECT_EQ(measure.reports, 5);
}

TEST(Stream, WhoseCounterWrapsLostNothing)
{
  const StreamMeasure measure = streamIn(stream({65534, 65535, 0, 1}));
  EXPECT_EQ(measure.lost, 0);
  EXPECT_EQ(measure.repeated, 0);
}

TEST(Stream, WithAGapLostWhatIsMissing) { EXPECT_EQ(streamIn(stream({65534, 65535, 3})).lost, 3); }

TEST(Stream, ThatRepeatsOrReordersSaysSo)
{
  EXPECT_EQ(streamIn(stream({1, 2, 2, 3})).repeated, 1);
  EXPECT_EQ(streamIn(stream({1, 2, 4, 3, 5})).repeated, 1);
}

TEST(Spread, OfAThousandStepsHasEachFractionAtItsStep)
{
  std::vector<double> values(1000);
  std::iota(values.rbegin(), values.rend(), 1.0);
  const Spread spread = spreadOf(values);
  EXPECT_EQ(spread.median, 500.0);
  EXPECT_EQ(spread.p99, 990.0);
  EXPECT_EQ(spread.p999, 999.0);
  EXPECT_EQ(spread.maximum, 1000.0);
  EXPECT_EQ(spreadOf({}).maximum, 0.0);
}

/// A handle that ticks every millisecond, a loop that reads 30 us after each tick, computes for 20
/// us and whose force arrives 10 us later, with the tick's number in quanta.
struct Conversation {
  std::vector<HandleTick> handle;
  std::vector<LoopTick> loop;

  explicit Conversation(int ticks)
  {
    for (int i = 0; i < ticks; ++i) {
      const std::int64_t due = (i + 1) * millisecond;
      HandleTick tick;
      tick.due = due;
      tick.sent = due + 10 * microsecond;
      tick.answered = due + 60 * microsecond;
      tick.force = i;
      tick.outputs = 1;
      tick.sequence = i;
      tick.position = 1e-3 + 1e-6 * (i % 2);
      tick.passage = "rest";
      handle.push_back(tick);
      loop.push_back({due + 30 * microsecond, due + 50 * microsecond, i, 1, quantum * i});
    }
  }
};

TEST(Answers, AreTimedFromTheTickAndFromTheReport)
{
  const Conversation talk(100);
  const AnswerMeasure measure = answersIn(talk.handle, talk.loop, {"rest"}, quantum);
  EXPECT_EQ(measure.ticks, 98);  // except the first and the last
  EXPECT_EQ(measure.answered, 98);
  EXPECT_EQ(measure.caused, 98);
  EXPECT_NEAR(measure.fromTick.p999, 60e-6, rounding);
  EXPECT_NEAR(measure.fromReport.median, 50e-6, rounding);
  EXPECT_NEAR(measure.engine.maximum, 20e-6, rounding);
  EXPECT_NEAR(measure.besides.maximum, 40e-6, rounding);
}

TEST(Answers, WithTheForceOfAnotherTickAreNotCaused)
{
  Conversation talk(100);
  for (LoopTick& tick : talk.loop) tick.force += 2.0 * quantum;
  const AnswerMeasure measure = answersIn(talk.handle, talk.loop, {"rest"}, quantum);
  EXPECT_EQ(measure.answered, 98);
  EXPECT_EQ(measure.caused, 0);
}

TEST(Answers, FromALoopThatReadsBeforeTheReportAreNotCaused)
{
  Conversation talk(100);
  for (LoopTick& tick : talk.loop) tick.read -= 25 * microsecond;
  EXPECT_EQ(answersIn(talk.handle, talk.loop, {"rest"}, quantum).caused, 0);
}

TEST(Answers, ThatAreMissingOrDoubleAreCountedOut)
{
  Conversation talk(100);
  talk.handle[40].outputs = 2;
  talk.handle[50].outputs = 0;
  talk.handle[50].answered = 0;
  EXPECT_EQ(answersIn(talk.handle, talk.loop, {"rest"}, quantum).answered, 96);
}

TEST(Rest, IsTheMeanPlaceOfAPassageAndItsSwing)
{
  const Conversation talk(100);
  const auto rest = restIn(talk.handle, "rest");
  ASSERT_TRUE(rest);
  EXPECT_NEAR(rest->mean, 1.0005e-3, rounding);
  EXPECT_NEAR(rest->swing, 1e-6, rounding);
  EXPECT_FALSE(restIn(talk.handle, "slide"));
}

TEST(Silence, IsTimedFromTheLastReportToTheFirstForceThatIsNone)
{
  Conversation talk(100);
  for (std::size_t i = 60; i < 100; ++i) {
    talk.handle[i].passage = "silence";
    talk.handle[i].sent = 0;
    talk.handle[i].force = i < 63 ? 2000 : 0;
    talk.loop[i].force = i < 63 ? 0.2 : 0.4 * quantum;
  }
  talk.loop[58].force = talk.loop[59].force = 0.2;
  const SilenceMeasure measure = silenceIn(talk.handle, talk.loop, "silence", quantum);
  // The report of tick 59 went at 60.01 ms, the loop wrote at 64.05 ms, the device heard at 64.06.
  ASSERT_TRUE(measure.written && measure.heard);
  EXPECT_NEAR(*measure.written, 4.04e-3, rounding);
  EXPECT_NEAR(*measure.heard, 4.05e-3, rounding);
  EXPECT_EQ(measure.before, 0.2);
}

TEST(Silence, OfALoopThatNeverLetsGoHasNoEnd)
{
  Conversation talk(100);
  for (std::size_t i = 60; i < 100; ++i) talk.handle[i].passage = "silence";
  for (LoopTick& tick : talk.loop) tick.force = 0.2;
  for (HandleTick& tick : talk.handle) tick.force = 2000;
  const SilenceMeasure measure = silenceIn(talk.handle, talk.loop, "silence", quantum);
  EXPECT_FALSE(measure.written);
  EXPECT_FALSE(measure.heard);
}

TEST(TickLog, ReadsBackWhatWasWritten)
{
  const test::TemporaryFolder folder;
  const Conversation talk(3);
  ASSERT_TRUE(write(folder.path() / "handle", talk.handle));
  ASSERT_TRUE(write(folder.path() / "loop", talk.loop));
  const auto handle = readHandleLog(folder.path() / "handle");
  const auto loop = readLoopLog(folder.path() / "loop");
  ASSERT_TRUE(handle && loop);
  ASSERT_EQ(handle->size(), 3u);
  EXPECT_EQ((*handle)[2].answered, talk.handle[2].answered);
  EXPECT_EQ((*handle)[2].passage, "rest");
  EXPECT_EQ((*loop)[1].written, talk.loop[1].written);
  EXPECT_NEAR((*loop)[1].force, talk.loop[1].force, rounding);
}

TEST(TickLog, ThatIsCutOffIsRefusedWithItsLine)
{
  const test::TemporaryFolder folder;
  std::ofstream(folder.path() / "loop") << "1 2 3 1 0.5\n1 2 3\n";
  const auto loop = readLoopLog(folder.path() / "loop");
  ASSERT_FALSE(loop);
  EXPECT_NE(loop.error().message.find("line 2"), std::string::npos);
}

}  // namespace
}  // namespace perilymph::hidstack
