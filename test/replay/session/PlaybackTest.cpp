// SPDX-License-Identifier: BSD-3-Clause

// A recording viewed tick by tick: after any jump the shape is that of the insertion.

#include <gmock/gmock.h>

#include <cmath>
#include <cstring>
#include <map>
#include <stop_token>

#include "ShortRun.h"
#include "perilymph/session/Playback.h"
#include "perilymph/test/Forgery.h"
#include "perilymph/test/TemporaryFolder.h"

namespace perilymph::session {
namespace {

using testing::HasSubstr;

/// The bits of the array's shape.
std::string shapeOf(const haptics::Snapshot& picture)
{
  return {reinterpret_cast<const char*>(picture.node_W.data()),
          picture.nodes * sizeof picture.node_W[0]};
}

/// With and without relaxation and yield, whose states a jump restores.
class APlayback : public testing::TestWithParam<Overrides> {
protected:
  void SetUp() override
  {
    auto insertion = test::shortRun(file_, GetParam());
    ASSERT_TRUE(insertion->runToEnd([&](const haptics::TickRecord& record) {
      haptics::Snapshot picture{};
      insertion->loop().engine().fill(picture);
      live_[record.tick] = shapeOf(picture);
      return true;
    }));
    insertion.reset();
  }

  std::unique_ptr<Playback> open()
  {
    auto opened = Playback::open(file_);
    EXPECT_TRUE(opened) << opened.error().message;
    return *std::move(opened);
  }

  test::TemporaryFolder folder_;
  std::filesystem::path file_ = folder_ / "run.insertion";
  std::map<std::uint64_t, std::string> live_;  ///< Recorded shapes by tick.
};

TEST_P(APlayback, ShowsTheShapesOfTheInsertionInWhateverOrder)
{
  const auto playback = open();
  ASSERT_EQ(playback->ticks(), live_.size());
  haptics::Snapshot picture{};
  for (const std::uint64_t place : {0u, 1u, 2u, 250u, 100u, 99u, 101u, 400u, 3u}) {
    ASSERT_TRUE(playback->show(place, picture));
    ASSERT_TRUE(live_.count(picture.tick)) << picture.tick;
    EXPECT_EQ(shapeOf(picture), live_[picture.tick]) << "place " << place;
  }
}

TEST_P(APlayback, ShowsTheSameOnceEverythingIsComputed)
{
  const auto playback = open();
  const auto verification = playback->compute();
  ASSERT_TRUE(verification);
  EXPECT_TRUE(verification->isIdentical);
  EXPECT_EQ(verification->ticksCompared, live_.size());
  EXPECT_EQ(playback->computedTicks(), live_.size());
  haptics::Snapshot picture{};
  for (const std::uint64_t place : {400u, 399u, 300u, 10u, 401u}) {
    ASSERT_TRUE(playback->show(place, picture));
    EXPECT_EQ(shapeOf(picture), live_[picture.tick]) << "place " << place;
  }
}

TEST_P(APlayback, BeyondTheEndShowsTheLastTick)
{
  const auto playback = open();
  haptics::Snapshot picture{};
  ASSERT_TRUE(playback->show(1'000'000'000, picture));
  EXPECT_EQ(picture.tick, live_.rbegin()->first);
  EXPECT_EQ(shapeOf(picture), live_.rbegin()->second);
}

TEST_P(APlayback, NamesTheFirstTickThatDiffersAndContinues)
{
  test::changeTicks(file_, [](std::vector<haptics::TickRecord>& records) {
    for (haptics::TickRecord& record : records)
      if (record.tick == 200) record.output.residual = std::nextafter(record.output.residual, 1.0);
  });
  const auto playback = open();
  const auto verification = playback->compute();
  ASSERT_TRUE(verification);
  ASSERT_TRUE(verification->difference);
  EXPECT_EQ(verification->difference->tick, 200u);
  EXPECT_EQ(playback->computedTicks(), live_.size());
}

TEST_P(APlayback, EndsWhereTicksWereLost)
{
  test::changeTicks(file_, test::withoutTicks(150, 159));
  const auto playback = open();
  EXPECT_EQ(playback->ticks(), 150u - live_.begin()->first);
  const auto verification = playback->compute();
  ASSERT_TRUE(verification);
  EXPECT_THAT(verification->notes, testing::Contains(HasSubstr("10 ticks before tick 160")));
}

TEST_P(APlayback, StopsComputingWhenAsked)
{
  const auto playback = open();
  std::stop_source stop;
  stop.request_stop();
  const auto stopped = playback->compute(stop.get_token());
  ASSERT_FALSE(stopped);
  EXPECT_LE(playback->computedTicks(), 1u);
  haptics::Snapshot picture{};
  ASSERT_TRUE(playback->show(300, picture));
  EXPECT_EQ(shapeOf(picture), live_[picture.tick]);
}

TEST_P(APlayback, OfNoTicksIsRefusedWithASentence)
{
  test::runSql(file_, "DELETE FROM block");
  const auto refused = Playback::open(file_);
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error().message, HasSubstr("contains no samples"));
}

INSTANTIATE_TEST_SUITE_P(AndWithMemory, APlayback,
                         testing::Values(Overrides{},
                                         Overrides{{"relaxation_fraction", "[0.3]"},
                                                   {"relaxation_time_s", "[0.05]"}},
                                         test::yieldingArray));

}  // namespace
}  // namespace perilymph::session
