// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/session/RecordingSignature.h"

#include <gtest/gtest.h>
#include <sqlite3.h>

#include <fstream>

#include "perilymph/session/Recording.h"
#include "perilymph/test/TemporaryFolder.h"

namespace perilymph::session {
namespace {

namespace fs = std::filesystem;

TEST(RecordingSignature, IsInARecordingWhileItIsWrittenAndOnceItIsClosed)
{
  const test::TemporaryFolder folder;
  const fs::path file = folder / "run.database";
  auto recording = Recording::create(file, RecordingFacts());
  ASSERT_TRUE(recording) << recording.error().message;
  EXPECT_TRUE(isRecording(file));
  const haptics::TickRecord tick;
  ASSERT_TRUE((*recording)->append({&tick, 1}));
  EXPECT_TRUE(fs::exists(file.string() + "-wal"));
  EXPECT_TRUE(isRecording(file.string() + "-wal"));
  ASSERT_TRUE((*recording)->close());
  EXPECT_TRUE(isRecording(file));
}

TEST(RecordingSignature, IsSeenThroughALink)
{
  const test::TemporaryFolder folder;
  std::ofstream(folder / "run.insertion") << "damaged";
  fs::create_symlink("run.insertion", folder / "run.csv");
  EXPECT_TRUE(isRecording(folder / "run.insertion"));
  EXPECT_TRUE(isRecording(folder / "run.csv"));
}

TEST(RecordingSignature, IsInNothingElse)
{
  const test::TemporaryFolder folder;
  std::ofstream(folder / "text") << "SQLite format 3";
  std::ofstream(folder / "text-wal") << "x";
  sqlite3* database = nullptr;
  ASSERT_EQ(sqlite3_open((folder / "other.sqlite").c_str(), &database), SQLITE_OK);
  EXPECT_EQ(sqlite3_exec(database, "PRAGMA application_id=1; CREATE TABLE a(b)", nullptr, nullptr,
                         nullptr),
            SQLITE_OK);
  sqlite3_close(database);
  for (const char* name : {"text", "text-wal", "other.sqlite", "none.insertion"})
    EXPECT_FALSE(isRecording(folder / name)) << name;
  EXPECT_FALSE(isRecording(folder.path()));
  EXPECT_FALSE(isRecording("/dev/null"));
}

}  // namespace
}  // namespace perilymph::session
