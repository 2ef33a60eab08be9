#include <gmock/gmock.h>
#include <sqlite3.h>

#include "ShortRun.h"
#include "perilymph/session/RecordedInsertion.h"
#include "perilymph/session/Replay.h"
#include "perilymph/test/TemporaryFolder.h"

namespace perilymph::session {
namespace {

using testing::HasSubstr;

void runSql(const std::filesystem::path& file, const std::string& sql)
{
  sqlite3* database = nullptr;
  ASSERT_EQ(sqlite3_open(file.c_str(), &database), SQLITE_OK);
  ASSERT_EQ(sqlite3_exec(database, sql.c_str(), nullptr, nullptr, nullptr), SQLITE_OK) << sql;
  sqlite3_close(database);
}

/// Flips one byte of the record of a tick, counted from the end of the record.
void flipByte(const std::filesystem::path& file, int tick, int fromEnd)
{
  sqlite3* database = nullptr;
  ASSERT_EQ(sqlite3_open(file.c_str(), &database), SQLITE_OK);
  sqlite3_blob* blob = nullptr;
  ASSERT_EQ(sqlite3_blob_open(database, "main", "tick", "record", tick, 1, &blob), SQLITE_OK);
  const int place = sqlite3_blob_bytes(blob) - fromEnd;
  unsigned char byte = 0;
  ASSERT_EQ(sqlite3_blob_read(blob, &byte, 1, place), SQLITE_OK);
  byte = static_cast<unsigned char>(byte ^ 1u);
  ASSERT_EQ(sqlite3_blob_write(blob, &byte, 1, place), SQLITE_OK);
  sqlite3_blob_close(blob);
  sqlite3_close(database);
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
      while (!insertion->send(command)) insertion->refresh();
    }
    dynamic_cast<device::ScriptedHand&>(insertion->hand())
        .move(device::ScriptedHand::Motion::insert);
    while (insertion->latest().output.travel < 0.5e-3) insertion->refresh();
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
  // The record ends with the residual, eight bytes; its lowest bit is in the first of them.
  flipByte(file, 123, 8);
  flipByte(file, 200, 8);
  const Verification verification = verified(file);
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
  runSql(file,
         "UPDATE meta SET value = '0.0.1+other' WHERE key = 'build_id';"
         "UPDATE meta SET value = replace(value, 'array_fingerprint = \"', 'array_fingerprint = "
         "\"x') WHERE key = 'scenario'");
  const Verification verification = verified(file);
  EXPECT_TRUE(verification.isIdentical);
  EXPECT_THAT(verification.notes, testing::UnorderedElementsAre(HasSubstr("0.0.1+other"),
                                                                HasSubstr("array 'contour'")));
}

TEST(Replay, ComparesAsFarAsNothingWasLost)
{
  const test::TemporaryFolder folder;
  const auto file = folder / "run.insertion";
  ASSERT_TRUE(test::shortRun(file)->runToEnd({}));
  runSql(file, "DELETE FROM tick WHERE tick BETWEEN 100 AND 104");
  const Verification verification = verified(file);
  EXPECT_TRUE(verification.isIdentical);
  EXPECT_EQ(verification.ticksCompared, 100u);
  EXPECT_THAT(verification.notes, testing::Contains(HasSubstr("5 ticks before tick 105")));
}

}  // namespace
}  // namespace perilymph::session
