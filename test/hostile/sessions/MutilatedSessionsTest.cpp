// SPDX-License-Identifier: BSD-3-Clause

// Recordings that were changed, by accident or on purpose: verification detects every change.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <functional>
#include <string>

#include "perilymph/session/RecordedInsertion.h"
#include "perilymph/session/Replay.h"
#include "perilymph/test/Forgery.h"
#include "perilymph/test/OddRecords.h"
#include "perilymph/test/Places.h"
#include "perilymph/test/TemporaryFolder.h"

namespace perilymph::session {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

constexpr std::uint64_t ticks = 400;

class Mutilated : public testing::Test {
protected:
  Mutilated()
  {
    auto records = test::quietRecords(0, ticks);
    records[5].commands.count = 1;
    records[5].commands.items[0].kind = haptics::Command::Kind::arm;
    for (std::uint64_t i = 50; i < ticks; ++i) records[i].output.axialForce = 1e-3;
    auto recording = Recording::create(file, test::someFacts());
    EXPECT_TRUE(recording);
    EXPECT_TRUE((*recording)->append(records));
    EXPECT_TRUE((*recording)->close());
  }

  /// Result of the verification: the damage, or the error message.
  std::string verdict() const
  {
    const auto verified = verify(file);
    if (!verified) return verified.error().message;
    EXPECT_EQ(verified->isIdentical, verified->damage.empty());
    return verified->damage;
  }

  std::string checked() const
  {
    const auto recorded = RecordedInsertion::open(file);
    if (!recorded) return recorded.error().message;
    const auto check = recorded->check();
    return check ? check->damage : check.error().message;
  }

  void runSql(const std::string& sql) const { test::runSql(file, sql); }
  void change(const std::function<void(std::vector<haptics::TickRecord>&)>& of) const
  {
    test::changeTicks(file, of);
  }

  const test::TemporaryFolder folder;
  const fs::path file = folder / "some.insertion";
};

TEST_F(Mutilated, NotAtAllIsWhole) { EXPECT_EQ(checked(), ""); }

TEST_F(Mutilated, ByTheLossOfItsEndIsNoticed)
{
  change(test::withoutTicks(11, ticks));
  EXPECT_THAT(verdict(), HasSubstr("it holds 11 of the 400 ticks"));
}

TEST_F(Mutilated, ByTheLossOfItsBeginningIsNoticed)
{
  change(test::withoutTicks(0, 9));
  EXPECT_THAT(verdict(), HasSubstr("it holds 390 of the 400 ticks"));
}

TEST_F(Mutilated, ByAHoleIsNoticed)
{
  change(test::withoutTicks(100, 200));
  EXPECT_THAT(verdict(), HasSubstr("it holds 299 of the 400 ticks"));
  // even if the count is adjusted
  runSql("UPDATE meta SET value = '299' WHERE key = 'ticks'");
  EXPECT_THAT(verdict(), HasSubstr("events"));
  // and a loss is claimed
  runSql("INSERT INTO event VALUES(201, 0.201, 'lost', 101)");
  EXPECT_THAT(verdict(), HasSubstr("hash"));
}

TEST_F(Mutilated, ByAChangedForceIsNoticed)
{
  change([](auto& records) { records[77].output.axialForce = 0.5; });
  EXPECT_THAT(verdict(), HasSubstr("hash"));
}

TEST_F(Mutilated, ByBlocksPackedInAnotherWayIsNoticed)
{
  runSql(
      "UPDATE block SET packed = CAST(packed || x'28b52ffd2000010000' AS BLOB)");  // an empty frame of zstd
  EXPECT_EQ(checked(), "its hash is that of other ticks or other facts");
}

TEST_F(Mutilated, ByAnEventThatIsMissingChangedOrInventedIsNoticed)
{
  for (const char* change :
       {"DELETE FROM event", "UPDATE event SET tick = 6", "UPDATE event SET time_s = 1",
        "UPDATE event SET kind = 'reset'", "UPDATE event SET value = 1",
        "INSERT INTO event VALUES(7, 0.007, 'reset', 0.0)"}) {
    const fs::path whole = folder / "whole";
    fs::copy_file(file, whole);
    runSql(change);
    EXPECT_THAT(verdict(), HasSubstr("events")) << change;
    fs::rename(whole, file);
  }
}

TEST_F(Mutilated, ByAChangedFactIsNoticed)
{
  for (const char* key : {"device", "started_utc", "seed", "lost_records", "peak_force_N"}) {
    runSql(std::string("UPDATE meta SET value = '5' WHERE key = '") + key + "'");
    EXPECT_THAT(verdict(), HasSubstr("hash")) << key;
  }
  runSql("INSERT INTO meta VALUES('more', '1')");
  EXPECT_THAT(verdict(), HasSubstr("hash"));
}

TEST_F(Mutilated, ByARecordPutInPlaceOfAnotherIsNoticed)
{
  runSql("UPDATE block SET tick = tick + 1000");
  EXPECT_THAT(verdict(), HasSubstr("the block of tick 1000 cannot be read"));
}

TEST_F(Mutilated, ByTheLossOfItsHashIsNoticed)
{
  runSql("DELETE FROM meta WHERE key = 'content_sha256'");
  EXPECT_THAT(verdict(), HasSubstr("its hash is missing"));
}

TEST_F(Mutilated, AndPassedOffAsAnOlderFormatIsNoticed)
{
  runSql("PRAGMA user_version=2");
  EXPECT_THAT(verdict(), HasSubstr("it has content that a recording of Perilymph does not have"));
}

/// A recording of release 0.2, in format 2.
class MutilatedFormat2 : public Mutilated {
protected:
  MutilatedFormat2()
  {
    fs::copy_file(test::testData() / "recordings/version-0.2/contour-published-rod.insertion", file,
                  fs::copy_options::overwrite_existing);
    EXPECT_EQ(checked(), "");
  }
};

TEST_F(MutilatedFormat2, ByAChangedColumnIsNoticed)
{
  runSql("UPDATE tick SET force_axial_N = 0.5 WHERE tick = 77");
  EXPECT_THAT(verdict(), HasSubstr("force_axial_N of tick 77"));
}

TEST_F(MutilatedFormat2, ByALostOrMovedRecordIsNoticed)
{
  runSql("DELETE FROM tick WHERE tick = 77");
  EXPECT_THAT(verdict(), HasSubstr("ticks it was closed with"));
  runSql("UPDATE tick SET tick = tick + 1000 WHERE tick >= 100");
  EXPECT_THAT(verdict(), HasSubstr("the record of tick 1100 cannot be read"));
}

TEST_F(MutilatedFormat2, PassedOffAsANewerOrOlderFormatIsNoticed)
{
  runSql("PRAGMA user_version=3");
  EXPECT_THAT(verdict(), HasSubstr("it has content that a recording of Perilymph does not have"));
  runSql("PRAGMA user_version=1");
  EXPECT_THAT(verdict(), HasSubstr("its format has no hash, and there is one"));
}

TEST_F(MutilatedFormat2, ByTheLossOfItsHashAndPassedOffAsAnOlderFormatIsNoticed)
{
  runSql(
      "PRAGMA user_version=1; DELETE FROM meta WHERE key = 'content_sha256'; "
      "UPDATE meta SET value = '0.2.0+abc' WHERE key = 'build_id'");
  EXPECT_THAT(verdict(), HasSubstr("its hash is missing"));
}

TEST_F(Mutilated, ByGeneratedColumnsIsRefusedBeforeTheyAreGenerated)
{
  runSql(
      "CREATE TABLE other(key TEXT PRIMARY KEY, value TEXT GENERATED ALWAYS AS "
      "(hex(zeroblob(30000000))) VIRTUAL);"
      "INSERT INTO other(key) SELECT key FROM meta; DROP TABLE meta;"
      "ALTER TABLE other RENAME TO meta");
  EXPECT_THAT(verdict(),
              HasSubstr("damaged (it has content that a recording of Perilymph does not have)"));
}

TEST_F(Mutilated, ByWhatNoRecordingHoldsIsRefused)
{
  const fs::path whole = folder / "whole";
  fs::copy_file(file, whole);
  for (const char* change :
       {"CREATE TABLE more(x)", "CREATE INDEX i ON block(ticks)",
        "CREATE INDEX i ON block(ticks + 1)", "CREATE VIEW v AS SELECT 1",
        "CREATE TRIGGER t AFTER INSERT ON block BEGIN DELETE FROM block; END",
        "ALTER TABLE meta ADD COLUMN more", "ALTER TABLE event RENAME COLUMN value TO other",
        "DROP TABLE event"}) {
    fs::copy_file(whole, file, fs::copy_options::overwrite_existing);
    runSql(change);
    EXPECT_THAT(verdict(), HasSubstr("damaged")) << change;
  }
}

TEST_F(Mutilated, ByFactsWithoutEndIsRefused)
{
  runSql(
      "WITH RECURSIVE n(x) AS (SELECT 1 UNION ALL SELECT x + 1 FROM n WHERE x < 20000)"
      "INSERT INTO meta SELECT 'k' || x, 'v' FROM n");
  EXPECT_THAT(verdict(), HasSubstr("it says more about itself than a recording does"));
}

TEST_F(Mutilated, ByFactsOfMegabytesIsRefused)
{
  runSql(
      "UPDATE meta SET value = hex(zeroblob(1500000)) WHERE key = 'scenario';"
      "INSERT INTO meta VALUES('more', hex(zeroblob(1500000)))");
  EXPECT_THAT(verdict(), HasSubstr("it says more about itself than a recording does"));
}

TEST_F(Mutilated, ByAFactOfAnotherTypeIsRefused)
{
  runSql("UPDATE meta SET value = CAST(value AS BLOB) WHERE key = 'device'");
  EXPECT_THAT(verdict(), HasSubstr("a fact about it is not text"));
}

}  // namespace
}  // namespace perilymph::session
