// SPDX-License-Identifier: BSD-3-Clause

// Access to SQLite: which files are accepted, and limits of a query.

#include "perilymph/database/Database.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sqlite3.h>

#include <fstream>
#include <stop_token>
#include <thread>

#include "OwnFilesOnly.h"
#include "perilymph/test/ForgedJournal.h"
#include "perilymph/test/TemporaryFolder.h"

namespace perilymph::database {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

const FileKind notes = {"a book of notes",
                        "Choose a .notes file.",
                        "Use another copy.",
                        0x4e6f7465,
                        3,
                        {"CREATE TABLE note(number INTEGER PRIMARY KEY, text TEXT NOT NULL)"}};

class DatabaseFile : public testing::Test {
protected:
  DatabaseFile()
  {
    std::ofstream(file, std::ios::binary).flush();
    auto written = Database::openNew(file);
    EXPECT_TRUE(written);
    EXPECT_TRUE(written->run(creationOf(notes)));
    EXPECT_TRUE(written->run("INSERT INTO note VALUES(1, 'one'), (2, 'two'); COMMIT"));
  }

  std::string refusal() const
  {
    const auto opened = Database::open(file, notes);
    return opened ? "" : opened.error().message;
  }

  const test::TemporaryFolder folder;
  const fs::path file = folder / "some.notes";
};

TEST_F(DatabaseFile, AcceptsAFileOfItsKind)
{
  const auto opened = Database::open(file, notes);
  ASSERT_TRUE(opened) << opened.error().message;
  EXPECT_EQ(opened->version(), 3);
  auto rows = opened->prepare("SELECT number, text FROM note ORDER BY number");
  ASSERT_TRUE(rows);
  ASSERT_EQ(rows->step(), Statement::Step::row);
  EXPECT_EQ(rows->integer(0), 1);
  EXPECT_EQ(rows->text(1), "one");
  EXPECT_EQ(rows->type(1), Statement::Type::text);
}

TEST_F(DatabaseFile, OpensReadOnlyFilesForReading)
{
  auto opened = Database::open(file, notes);
  ASSERT_TRUE(opened);
  const auto written = opened->run("INSERT INTO note VALUES(3, 'three')");
  ASSERT_FALSE(written);
  EXPECT_THAT(written.error().message, HasSubstr("readonly"));
}

TEST_F(DatabaseFile, RefusesAnotherKindWithItsMessage)
{
  FileKind other = notes;
  other.applicationId = 5;
  const auto opened = Database::open(file, other);
  ASSERT_FALSE(opened);
  EXPECT_THAT(opened.error().message, HasSubstr("is not a book of notes. Choose a .notes file."));
}

TEST_F(DatabaseFile, RefusesANewerVersion)
{
  FileKind older = notes;
  older.newestVersion = 2;
  const auto opened = Database::open(file, older);
  ASSERT_FALSE(opened);
  EXPECT_THAT(opened.error().message, HasSubstr("has format 3; this program reads up to 2"));
}

TEST_F(DatabaseFile, RefusesAnExtraOrAMissingTable)
{
  FileKind more = notes;
  more.tables.push_back("CREATE TABLE other(x)");
  EXPECT_THAT(Database::open(file, more).error().message, HasSubstr("a table is missing"));
  FileKind fewer = notes;
  fewer.tables.clear();
  EXPECT_THAT(Database::open(file, fewer).error().message,
              HasSubstr("it has content that a book of notes does not have"));
}

TEST_F(DatabaseFile, StopsAQueryThatExceedsTheLimitOfTheFile)
{
  const auto opened = Database::open(file, notes);
  ASSERT_TRUE(opened);
  auto endless = opened->prepare(
      "WITH RECURSIVE n(x) AS (SELECT 1 UNION ALL SELECT x + 1 FROM n) SELECT max(x) FROM n");
  ASSERT_TRUE(endless) << endless.error().message;
  EXPECT_EQ(endless->step(), Statement::Step::failed);
  EXPECT_EQ(opened->lastError(), "reading it does not end");
}

TEST_F(DatabaseFile, StopsACanceledQuery)
{
  std::stop_source stop;
  const auto opened = Database::open(file, notes, stop.get_token());
  ASSERT_TRUE(opened) << opened.error().message;
  const std::jthread canceling([&stop] { stop.request_stop(); });
  auto long_ = opened->prepare(
      "WITH RECURSIVE n(x) AS (SELECT 1 UNION ALL SELECT x + 1 FROM n) SELECT max(x) FROM n");
  EXPECT_EQ(long_->step(), Statement::Step::failed);
  EXPECT_TRUE(opened->wasStopped());
  EXPECT_THAT(opened->readingError("").message, HasSubstr("was stopped"));
}

TEST_F(DatabaseFile, RefusesAJournalThatNamesAnotherFile)
{
  const fs::path treasure = folder / "treasure.txt";
  std::ofstream(treasure) << "what nobody may lose";
  test::forgeJournal(file, treasure);
  EXPECT_THAT(refusal(), HasSubstr("names a further file"));
  EXPECT_TRUE(fs::exists(treasure));
}

// Second line of defense: even if a journal passes the check above, SQLite cannot reach the file.
TEST_F(DatabaseFile, KeepsSqliteFromFilesNamedInAJournal)
{
  const fs::path treasure = folder / "treasure.txt";
  std::ofstream(treasure) << "what nobody may lose";
  test::forgeJournal(file, treasure);
  sqlite3* database = nullptr;
  ASSERT_EQ(sqlite3_open_v2(file.c_str(), &database, SQLITE_OPEN_READWRITE, ownFilesOnly()),
            SQLITE_OK);
  const int done = sqlite3_exec(database, "SELECT * FROM note", nullptr, nullptr, nullptr);
  // one newer than Debian 13's leaves the journal's file alone by itself, and reads
  if (sqlite3_libversion_number() <= 3'046'001) {
    EXPECT_NE(done, SQLITE_OK);
  }
  sqlite3_close(database);
  EXPECT_TRUE(fs::exists(treasure));
}

TEST_F(DatabaseFile, RefusesLinksBesideTheFile)
{
  const fs::path elsewhere = folder / "elsewhere";
  std::ofstream(elsewhere) << "somebody's own";
  for (const char* ending : {"-wal", "-shm", "-journal"}) {
    fs::create_symlink(elsewhere, file.string() + ending);
    EXPECT_THAT(refusal(), HasSubstr("is not a file but a link")) << ending;
    fs::remove(file.string() + ending);
  }
}

TEST_F(DatabaseFile, RefusesPipesFoldersAndOtherFiles)
{
  EXPECT_THAT(Database::open(folder.path(), notes).error().message, HasSubstr("is a folder"));
  EXPECT_THAT(Database::open(folder / "none", notes).error().message, HasSubstr("does not exist"));
  EXPECT_THAT(Database::open("/dev/null", notes).error().message, HasSubstr("is not a book"));
}

}  // namespace
}  // namespace perilymph::database
