// SPDX-License-Identifier: BSD-3-Clause

// Malicious recordings.

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sqlite3.h>
#include <sys/stat.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "MakeEngine.h"
#include "perilymph/session/RecordedInsertion.h"
#include "perilymph/session/Replay.h"
#include "perilymph/session/Scenario.h"
#include "perilymph/test/ForgedJournal.h"
#include "perilymph/test/Forgery.h"
#include "perilymph/test/OddRecords.h"
#include "perilymph/test/TemporaryFolder.h"

namespace perilymph::session {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class ForgedSession : public testing::Test {
protected:
  ForgedSession()
  {
    fs::create_directory(sent);
    fs::create_directory(home);
    std::ofstream(treasure) << "what nobody may lose\n";
    auto recording = Recording::create(file, test::someFacts());
    EXPECT_TRUE(recording);
    EXPECT_TRUE((*recording)->append(test::quietRecords(0, 20)));
    EXPECT_TRUE((*recording)->close());
  }

  void runSql(const std::string& sql) const { test::runSql(file, sql); }
  void rehash() const { test::rehash(file); }

  std::string refusal() const
  {
    const auto opened = RecordedInsertion::open(file);
    return opened ? "opened" : opened.error().message;
  }

  static std::string contentOf(const fs::path& place)
  {
    std::ifstream stream(place, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
  }

  static std::vector<std::string> namesIn(const fs::path& place)
  {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(place))
      names.push_back(entry.path().filename());
    std::sort(names.begin(), names.end());
    return names;
  }

  void expectTreasure() const
  {
    EXPECT_EQ(contentOf(treasure), "what nobody may lose\n");
    EXPECT_THAT(namesIn(home), testing::ElementsAre("treasure.txt"));
  }

  void forgeJournal() const { test::forgeJournal(file, treasure); }

  const test::TemporaryFolder folder;
  const fs::path sent = folder / "sent", home = folder / "home";
  const fs::path file = sent / "some.insertion", treasure = home / "treasure.txt";
};

TEST_F(ForgedSession, WithAJournalThatNamesAFileDoesNotDeleteThatFile)
{
  forgeJournal();
  EXPECT_THAT(refusal(), HasSubstr("some.insertion-journal names a further file"));
  expectTreasure();
}

TEST_F(ForgedSession, WithThatJournalWouldMakeSqliteDeleteTheFile)
{
  forgeJournal();
  sqlite3* database = nullptr;
  ASSERT_EQ(sqlite3_open(file.c_str(), &database), SQLITE_OK);
  sqlite3_exec(database, "SELECT * FROM meta", nullptr, nullptr, nullptr);
  sqlite3_close(database);
  constexpr int newestOfDebian13 = 3'046'001;
  if (fs::exists(treasure) && sqlite3_libversion_number() > newestOfDebian13)
    GTEST_SKIP() << "SQLite " << sqlite3_libversion() << " leaves the file alone.";
  EXPECT_FALSE(fs::exists(treasure)) << "the journal of this test is no danger: forge a better one";
}

TEST_F(ForgedSession, WithCompanionsThatAreLinksIsNotOpened)
{
  for (const char* ending : {"-wal", "-journal", "-shm"}) {
    const fs::path companion = file.string() + ending;
    fs::create_symlink(treasure, companion);
    EXPECT_THAT(refusal(), HasSubstr("is not a file but a link")) << ending;
    fs::remove(companion);
    expectTreasure();
  }
}

TEST_F(ForgedSession, WhoseTablesComputeWithoutEndIsRefused)
{
  runSql(
      "ALTER TABLE block RENAME TO other; CREATE VIEW block AS "
      "WITH RECURSIVE n(x) AS (SELECT 0 UNION ALL SELECT x + 1 FROM n) "
      "SELECT x AS tick, 1 AS ticks, zeroblob(10) AS packed FROM n");
  EXPECT_THAT(refusal(),
              HasSubstr("damaged (it has content that a recording of Perilymph does not have)"));
}

TEST_F(ForgedSession, WhoseFactsComputeWithoutEndIsRefused)
{
  runSql(
      "ALTER TABLE meta RENAME TO other; CREATE VIEW meta AS "
      "WITH RECURSIVE n(x) AS (SELECT 0 UNION ALL SELECT x + 1 FROM n) "
      "SELECT x AS key, x AS value FROM n");
  EXPECT_THAT(refusal(), HasSubstr("damaged"));
}

TEST_F(ForgedSession, IsReadWithoutAByteWrittenAnywhere)
{
  const std::string before = contentOf(file);
  const auto opened = RecordedInsertion::open(file);
  ASSERT_TRUE(opened) << opened.error().message;
  EXPECT_TRUE(opened->forEach([](const haptics::TickRecord&) { return true; }));
  EXPECT_THAT(namesIn(sent), testing::ElementsAre("some.insertion"));
  EXPECT_EQ(contentOf(file), before);
}

TEST_F(ForgedSession, WhoseScenarioNamesForeignFilesIsReplayedByNone)
{
  for (const std::string key : {"patient", "array", "friction", "calibration"}) {
    runSql("UPDATE meta SET value = '" + key + " = \"" + treasure.string() +
           "\"' WHERE key = 'scenario'");
    rehash();
    const auto verified = verify(file);
    ASSERT_FALSE(verified) << key;
    EXPECT_THAT(verified.error().message, testing::Not(HasSubstr("nobody may lose"))) << key;
    expectTreasure();
    EXPECT_THAT(namesIn(sent), testing::ElementsAre("some.insertion")) << key;
  }
}

TEST_F(ForgedSession, WhoseScenarioNamesAPipeIsNotWaitedFor)
{
  const fs::path pipe = sent / "pipe.toml";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  for (const std::string key : {"patient", "array", "friction", "calibration"}) {
    runSql("UPDATE meta SET value = '" + key + " = \"" + pipe.string() +
           "\"' WHERE key = 'scenario'");
    rehash();
    const auto verified = verify(file);
    ASSERT_FALSE(verified) << key;
    EXPECT_THAT(verified.error().message, HasSubstr("is a pipe or a device")) << key;
  }
}

TEST_F(ForgedSession, WithFactsThatNoDeviceHasIsRefusedOrRunsWithinTheLimits)
{
  const auto scenario = loadScenario("contour-published", {{"nodes", "20"}});
  ASSERT_TRUE(scenario) << scenario.error().message;
  const auto anatomy = buildAnatomy(*scenario);
  ASSERT_TRUE(anatomy);
  const auto model = buildModel(*scenario, *anatomy);
  ASSERT_TRUE(model);
  const double maxForce = scenario->engine().safety.maxForce;

  for (const char* key : {"dt_s", "sample_period_s", "max_force_N", "reach_m", "max_stiffness_N_m",
                          "max_damping_N_s_m", "rest_after_s", "device_delay_s"})
    for (const char* value : {"nan", "inf", "-inf", "-1", "0", "1e308", "", "x"}) {
      SCOPED_TRACE(std::string(key) + " = '" + value + "'");
      runSql(std::string("UPDATE meta SET value = '") + value + "' WHERE key = '" + key + "'");
      rehash();
      const auto opened = RecordedInsertion::open(file);
      if (!opened) continue;
      const auto engine = makeEngine(scenario->parameters(), *model, opened->facts().run);
      if (!engine) {
        EXPECT_THAT(engine.error().message, HasSubstr("cannot be run"));
        continue;
      }
      EXPECT_TRUE(opened->forEach([&](const haptics::TickRecord& record) {
        const auto& force_D = (*engine)->tick(record.sample, record.commands).wrench_D.force_D;
        EXPECT_LE(std::hypot(force_D[0], force_D[1], force_D[2]), maxForce);  // false for NaN
        return true;
      }));
    }
}

TEST_F(ForgedSession, ReachedThroughALinkIsRecoveredWhereItLies)
{
  const fs::path link = home / "link.insertion";
  fs::create_symlink(file, link);
  const auto opened = RecordedInsertion::open(link);
  ASSERT_TRUE(opened) << opened.error().message;
  EXPECT_EQ(opened->ticks(), 20u);
}

}  // namespace
}  // namespace perilymph::session
