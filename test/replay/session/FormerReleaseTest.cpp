// SPDX-License-Identifier: BSD-3-Clause

// A recording made with release 0.1 (test/data/recordings/version-0.1), in format 1 and with the
// former names of keys, is read whole and played back; the replay says where it differs.

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "perilymph/session/Playback.h"
#include "perilymph/session/RecordedInsertion.h"
#include "perilymph/test/Places.h"

namespace perilymph::session {
namespace {

using testing::Contains;
using testing::HasSubstr;

constexpr std::uint64_t recordedTicks = 203;
constexpr double travelAtEnd = 10e-3;       ///< The scenario's stop travel [m].
constexpr double speed = 10e-3;             ///< The scenario's insertion speed [m/s].
constexpr double recordedPeak = 0.1060743;  ///< The key figure that release 0.1 stored [N].
constexpr const char* build = "0.1.0+b8cf1418446e";

std::filesystem::path recording()
{
  return test::testData() / "recordings/version-0.1/contour-published-rod.insertion";
}

TEST(ARecordingOfRelease01, IsReadWhole)
{
  const auto read = RecordedInsertion::open(recording());
  ASSERT_TRUE(read) << read.error().message;
  EXPECT_EQ(read->facts().buildId, build);
  EXPECT_TRUE(read->wasClosed());
  const auto check = read->check();
  ASSERT_TRUE(check) << check.error().message;
  EXPECT_EQ(check->damage, "");
  EXPECT_EQ(check->ticks, recordedTicks);

  double peak = 0.0;
  double travel = 0.0;
  ASSERT_TRUE(read->forEach([&](const haptics::TickRecord& record) {
    peak = std::max(peak, record.output.axialForce);
    travel = record.output.travel;
    // it has no force on the partition, which is not 0 therefore
    EXPECT_TRUE(std::isnan(record.output.partitionForce));
    return true;
  }));
  EXPECT_NEAR(peak, recordedPeak, 1e-7);
  EXPECT_NEAR(travel, travelAtEnd, 1e-6);
  const auto figures = read->highlights();
  ASSERT_TRUE(figures) << figures.error().message;
  EXPECT_NEAR(figures->peakForce, recordedPeak, 1e-7);
}

TEST(ARecordingOfRelease01, IsPlayedBackWithItsValuesAndTheArrayWhereTheTweezersWere)
{
  const auto playback = Playback::open(recording());
  ASSERT_TRUE(playback) << playback.error().message;
  ASSERT_EQ((*playback)->ticks(), recordedTicks);
  haptics::Snapshot picture{};
  double lastTravel = -1.0;
  for (std::uint64_t place = 0; place < recordedTicks; place += 50) {
    ASSERT_TRUE((*playback)->show(place, picture));
    EXPECT_GT(picture.nodes, 2u);
    EXPECT_GT(picture.output.travel, lastTravel);
    lastTravel = picture.output.travel;
  }
  ASSERT_TRUE((*playback)->show(recordedTicks - 1, picture));
  EXPECT_NEAR(picture.output.travel, travelAtEnd, speed * (*playback)->timeStep());
}

TEST(ARecordingOfRelease01, DiffersFromItsReplayWhichSaysThatItIsOfAnotherBuild)
{
  const auto verification = verify(recording());
  ASSERT_TRUE(verification) << verification.error().message;
  EXPECT_EQ(verification->damage, "");
  EXPECT_FALSE(verification->isIdentical);
  EXPECT_TRUE(verification->difference);
  EXPECT_EQ(verification->otherVersion, "0.1.0");
  EXPECT_THAT(verification->notes, Contains(HasSubstr(build)));
  EXPECT_THAT(verification->notes, Contains(HasSubstr("differs from the recorded model")));
}

}  // namespace
}  // namespace perilymph::session
