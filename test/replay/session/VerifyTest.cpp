// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include <cmath>
#include <functional>
#include <stop_token>
#include <vector>

#include "ShortRun.h"
#include "perilymph/session/RecordedInsertion.h"
#include "perilymph/session/Replay.h"
#include "perilymph/test/Forgery.h"
#include "perilymph/test/TemporaryFolder.h"
#include "perilymph/test/waitUntil.h"

namespace perilymph::session {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

/// Copies a recording with each tick modified by `change`; ticks that it refuses are lost.
void recordAgain(const std::filesystem::path& from, const std::filesystem::path& to,
                 const std::function<bool(haptics::TickRecord&)>& change)
{
  const auto recorded = RecordedInsertion::open(from);
  ASSERT_TRUE(recorded) << recorded.error().message;
  auto recording = Recording::create(to, recorded->facts());
  ASSERT_TRUE(recording) << recording.error().message;
  std::vector<haptics::TickRecord> kept;
  ASSERT_TRUE(recorded->forEach([&](const haptics::TickRecord& record) {
    haptics::TickRecord changed = record;
    if (change(changed)) kept.push_back(changed);
    return true;
  }));
  ASSERT_TRUE((*recording)->append(kept));
  ASSERT_TRUE((*recording)->close());
}

Verification verified(const std::filesystem::path& file)
{
  auto verification = verify(file);
  EXPECT_TRUE(verification) << verification.error().message;
  return *verification;
}

TEST(Replay, GivesTheSameBitsThroughAWholeInsertion)
{
  const test::TemporaryFolder folder;
  std::uint64_t ticks = 0;
  ASSERT_TRUE(test::shortRun(folder / "run.insertion")->runToEnd([&](const haptics::TickRecord&) {
    return ++ticks > 0;
  }));
  const Verification verification = verified(folder / "run.insertion");
  EXPECT_TRUE(verification.isIdentical);
  EXPECT_EQ(verification.ticksCompared, ticks);
  EXPECT_THAT(verification.notes, testing::IsEmpty());
}

TEST(Replay, FollowsWithdrawalsPatientsAndSprings)
{
  const test::TemporaryFolder folder;
  const Overrides overrides = {
      {"withdraw", "true"}, {"patient", "left"}, {"coupling", "spring"}, {"dt_ms", "0.5"}};
  ASSERT_TRUE(test::shortRun(folder / "run.insertion", overrides)->runToEnd({}));
  EXPECT_TRUE(verified(folder / "run.insertion").isIdentical);
}

TEST(Replay, FollowsAnArrayThatRelaxes)
{
  const test::TemporaryFolder folder;
  const Overrides overrides = {{"relaxation_fraction", "[0.13, 0.28]"},
                               {"relaxation_time_s", "[0.03, 0.6]"},
                               {"film_relaxation_fraction", "0.4"},
                               {"film_relaxation_time_s", "0.1"},
                               {"stop_travel_mm", "8"},
                               {"withdraw", "true"}};
  ASSERT_TRUE(test::shortRun(folder / "run.insertion", overrides)->runToEnd({}));
  EXPECT_TRUE(verified(folder / "run.insertion").isIdentical);
}

TEST(Replay, FollowsAnArrayThatYields)
{
  const test::TemporaryFolder folder;
  const fs::path file = folder / "run.insertion";
  Overrides overrides = test::yieldingArray;
  overrides.insert(overrides.end(), {{"stop_travel_mm", "8"}, {"withdraw", "true"}});
  double work = 0.0;
  ASSERT_TRUE(test::shortRun(file, overrides)->runToEnd([&](const haptics::TickRecord& record) {
    EXPECT_GE(record.output.plasticWork, work);
    work = record.output.plasticWork;
    return true;
  }));
  EXPECT_GT(work, 1e-6);
  EXPECT_TRUE(verified(file).isIdentical);
  double recorded = 0.0;
  ASSERT_TRUE(RecordedInsertion::open(file)->forEach([&](const haptics::TickRecord& record) {
    recorded = record.output.plasticWork;
    return true;
  }));
  EXPECT_EQ(recorded, work);
  // one work that differs is found
  recordAgain(file, folder / "changed.insertion", [](haptics::TickRecord& record) {
    if (record.tick == 4500) record.output.plasticWork *= 2.0;
    return true;
  });
  const Verification verification = verified(folder / "changed.insertion");
  ASSERT_TRUE(verification.difference);
  EXPECT_EQ(verification.difference->field, "plasticWork");
}

TEST(Replay, FollowsThePublishedPointSet)
{
  const test::TemporaryFolder folder;
  const Overrides overrides = {
      {"model", "points"}, {"nodes", "12"}, {"stop_travel_mm", "8"}, {"withdraw", "true"}};
  for (const char* coupling : {"rigid", "spring"}) {
    Overrides coupled = overrides;
    coupled.emplace_back("coupling", coupling);
    const auto file = folder / (std::string(coupling) + ".insertion");
    ASSERT_TRUE(test::shortRun(file, coupled)->runToEnd({}));
    const Verification verification = verified(file);
    EXPECT_TRUE(verification.isIdentical) << coupling;
    EXPECT_GT(verification.ticksCompared, 8000u) << coupling;
  }
}

TEST(Replay, FollowsCommandsGivenByTheClock)
{
  const test::TemporaryFolder folder;
  {
    const auto insertion = test::shortRun(folder / "run.insertion");
    ASSERT_TRUE(insertion->start());
    for (const haptics::Command::Kind kind :
         {haptics::Command::Kind::arm, haptics::Command::Kind::pullStylet}) {
      haptics::Command command;
      command.kind = kind;
      command.value = 1e-3;
      ASSERT_TRUE(test::waitUntil([&] {
        insertion->refresh();
        return insertion->send(command);
      }));
    }
    insertion->device().move(device::ScriptedMotion::insert);
    ASSERT_TRUE(test::waitUntil([&] {
      insertion->refresh();
      return insertion->latest().output.travel >= 0.5e-3;
    }));
  }
  const Verification verification = verified(folder / "run.insertion");
  EXPECT_TRUE(verification.isIdentical);
  EXPECT_GT(verification.ticksCompared, 250u);  // half a millimeter at 2 mm/s
}

TEST(Replay, NamesTheFirstBitThatDiffers)
{
  const test::TemporaryFolder folder;
  const auto file = folder / "run.insertion";
  ASSERT_TRUE(test::shortRun(file)->runToEnd({}));
  recordAgain(file, folder / "changed.insertion", [](haptics::TickRecord& record) {
    if (record.tick == 123 || record.tick == 200)
      record.output.residual = std::nextafter(record.output.residual, 1.0);
    return true;
  });
  const Verification verification = verified(folder / "changed.insertion");
  EXPECT_FALSE(verification.isIdentical);
  ASSERT_TRUE(verification.difference);
  EXPECT_EQ(verification.difference->tick, 123u);
  EXPECT_EQ(verification.difference->field, "residual");
  EXPECT_NE(verification.difference->recorded, verification.difference->computed);
}

TEST(Replay, SaysWhenTheArrayFileOrTheBuildIsAnother)
{
  const test::TemporaryFolder folder;
  const auto file = folder / "run.insertion";
  ASSERT_TRUE(test::shortRun(file)->runToEnd({}));
  test::runSql(
      file,
      "UPDATE meta SET value = '0.0.1+other' WHERE key = 'build_id';"
      "UPDATE meta SET value = replace(value, 'array_fingerprint = \"', 'array_fingerprint = "
      "\"x') WHERE key = 'scenario'");
  test::rehash(file);
  const Verification verification = verified(file);
  EXPECT_TRUE(verification.isIdentical);
  EXPECT_THAT(verification.notes, testing::UnorderedElementsAre(HasSubstr("0.0.1+other"),
                                                                HasSubstr("array 'contour'")));
}

TEST(Replay, SaysWhenTheModelIsAnother)
{
  const test::TemporaryFolder folder;
  const auto file = folder / "run.insertion";
  ASSERT_TRUE(test::shortRun(file)->runToEnd({}));
  test::runSql(file, "UPDATE meta SET value = '1' WHERE key = 'model_fingerprint'");
  test::rehash(file);
  EXPECT_THAT(verified(file).notes,
              testing::Contains(HasSubstr("differs from the recorded model")));
}

TEST(Replay, ComparesUpToTheFirstLostTickAndReportsThatItIsIncomplete)
{
  const test::TemporaryFolder folder;
  const auto file = folder / "run.insertion";
  ASSERT_TRUE(test::shortRun(file)->runToEnd({}));
  recordAgain(file, folder / "gap.insertion", [](const haptics::TickRecord& record) {
    return record.tick < 100 || record.tick > 104;
  });
  const Verification verification = verified(folder / "gap.insertion");
  EXPECT_EQ(verification.damage, "");
  EXPECT_EQ(verification.ticksCompared, 100u);
  EXPECT_EQ(verification.missingTicks, 5u);
  EXPECT_FALSE(verification.isIdentical);
  EXPECT_THAT(verification.notes, testing::Contains(HasSubstr("5 ticks before tick 105")));
}

TEST(Replay, StopsWhereItIsToldTo)
{
  const test::TemporaryFolder folder;
  const auto file = folder / "run.insertion";
  ASSERT_TRUE(test::shortRun(file)->runToEnd({}));
  std::stop_source stop;
  const auto at50 = [&stop](std::uint64_t done, std::uint64_t) {
    if (done == 50) stop.request_stop();
  };
  const auto stopped = verify(file, at50, stop.get_token());
  ASSERT_FALSE(stopped);
  EXPECT_THAT(stopped.error().message, HasSubstr("Stopped after 50 of"));
}

}  // namespace
}  // namespace perilymph::session
