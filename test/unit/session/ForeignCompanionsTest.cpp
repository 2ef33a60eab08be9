// SPDX-License-Identifier: BSD-3-Clause

// Logs and journals of other files beside a recording, and reading while another process records.

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sqlite3.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <fstream>
#include <functional>
#include <iterator>
#include <map>

#include "perilymph/session/RecordedInsertion.h"
#include "perilymph/session/TickTable.h"
#include "perilymph/test/OddRecords.h"
#include "perilymph/test/TemporaryFolder.h"

namespace perilymph::session {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::HasSubstr;

std::string contentOf(const fs::path& file)
{
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

std::map<std::string, std::string> folderContent(const fs::path& folder)
{
  std::map<std::string, std::string> files;
  for (const auto& entry : fs::directory_iterator(folder))
    files[entry.path().filename()] = contentOf(entry.path());
  return files;
}

RecordingFacts factsNamed(const std::string& name)
{
  RecordingFacts facts = test::someFacts();
  facts.scenarioName = name;
  return facts;
}

void record(const fs::path& file, const std::string& name, std::uint64_t ticks)
{
  auto recording = Recording::create(file, factsNamed(name));
  ASSERT_TRUE(recording) << recording.error().message;
  ASSERT_TRUE((*recording)->append(test::quietRecords(0, ticks)));
  ASSERT_TRUE((*recording)->close());
}

/// Runs something in a process that is then killed, as a crash would.
void killedAfter(const std::function<bool()>& work)
{
  const pid_t child = ::fork();
  if (child == 0) {
    if (!work()) ::_exit(1);
    ::raise(SIGKILL);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  EXPECT_TRUE(WIFSIGNALED(status));
}

/// A recording whose program was killed after these ticks.
void crash(const fs::path& file, const std::string& name, std::uint64_t ticks)
{
  killedAfter([&] {
    auto recording = Recording::create(file, factsNamed(name));
    if (!recording) return false;
    bool isWritten = true;
    for (std::uint64_t tick = 0; tick < ticks; tick += 20)
      isWritten = isWritten && (*recording)->append(test::quietRecords(tick, 20));
    if (isWritten) ::raise(SIGKILL);
    return isWritten;
  });
}

/// Leaves the journal of an unfinished change beside a copy of a database.
void leaveJournal(const fs::path& file, const std::string& sql)
{
  killedAfter([&] {
    sqlite3* database = nullptr;
    return sqlite3_open(file.c_str(), &database) == SQLITE_OK &&
           sqlite3_exec(database, ("PRAGMA cache_size=1; BEGIN; " + sql).c_str(), nullptr, nullptr,
                        nullptr) == SQLITE_OK;
  });
}

class ForeignCompanion : public testing::Test {
protected:
  /// The recording reads as 500 ticks that are those recorded, and nothing in its folder changes.
  void expectUntouched(const std::string& companion, const std::string& name = "mine",
                       bool isClosed = true)
  {
    const auto before = folderContent(place);
    {
      const auto opened = RecordedInsertion::open(file);
      ASSERT_TRUE(opened) << opened.error().message;
      EXPECT_EQ(opened->facts().scenarioName, name);
      EXPECT_EQ(opened->ticks(), 500u);
      EXPECT_EQ(opened->wasClosed(), isClosed);
      const auto check = opened->check();
      ASSERT_TRUE(check) << check.error().message;
      EXPECT_EQ(check->damage, "");
      EXPECT_THAT(opened->note(), AllOf(HasSubstr(file.string() + companion), HasSubstr("not")));
    }
    EXPECT_EQ(folderContent(place), before);
  }

  const test::TemporaryFolder folder;
  const fs::path place = folder / "recordings";
  const fs::path file = place / "mine.insertion";
  const fs::path other = folder / "other.insertion";

  void SetUp() override { fs::create_directory(place); }
};

TEST_F(ForeignCompanion, LogOfACrashedRecordingSpoilsNoClosedOne)
{
  record(file, "mine", 500);
  crash(other, "other", 400);
  fs::copy_file(other.string() + "-wal", file.string() + "-wal");
  expectUntouched("-wal");
  fs::copy_file(other.string() + "-shm", file.string() + "-shm");
  expectUntouched("-wal");
}

TEST_F(ForeignCompanion, LogOfAnEarlierPartOfTheSameRecordingSpoilsNoClosedOne)
{
  crash(other, "mine", 400);
  record(file, "mine", 500);
  fs::copy_file(other.string() + "-wal", file.string() + "-wal");
  expectUntouched("-wal");
}

TEST_F(ForeignCompanion, LogThatIsNoneAndStrayIndexAreLeftAlone)
{
  record(file, "mine", 500);
  std::ofstream(file.string() + "-wal") << "not a log, " << std::string(9000, '*');
  std::ofstream(file.string() + "-shm") << std::string(32768, '\1');
  expectUntouched("-wal");
}

// A crashed recording that was opened once has its ticks in the file, which still awaits a log.
TEST_F(ForeignCompanion, LogSpoilsNoRecoveredRecording)
{
  crash(file, "mine", 500);
  ASSERT_TRUE(RecordedInsertion::open(file));
  ASSERT_FALSE(fs::exists(file.string() + "-wal"));
  crash(other, "other", 800);
  fs::copy_file(other.string() + "-wal", file.string() + "-wal");
  expectUntouched("-wal", "mine", false);
}

TEST_F(ForeignCompanion, LogIsNotTakenForTheLostOneOfACrashedRecording)
{
  crash(file, "mine", 500);
  fs::remove(file.string() + "-wal");
  crash(other, "other", 800);
  fs::copy_file(other.string() + "-wal", file.string() + "-wal");
  const auto before = folderContent(place);
  {
    const auto opened = RecordedInsertion::open(file);
    ASSERT_TRUE(opened) << opened.error().message;
    EXPECT_EQ(opened->facts().scenarioName, "mine");
    EXPECT_LT(opened->ticks(), 500u);
  }
  EXPECT_EQ(folderContent(place)["mine.insertion"], before.at("mine.insertion"));
}

TEST_F(ForeignCompanion, JournalSpoilsNoRecording)
{
  record(file, "mine", 500);
  record(other, "other", 3000);
  const fs::path copy = folder / "copy";
  for (const char* sql : {"DELETE FROM block; UPDATE meta SET value = value || 'x'",
                          "INSERT INTO event VALUES(1, 1, hex(zeroblob(200000)), 1)",
                          "UPDATE block SET packed = zeroblob(60000)"}) {
    SCOPED_TRACE(sql);
    fs::copy_file(other, copy, fs::copy_options::overwrite_existing);
    fs::remove(file.string() + "-journal");
    leaveJournal(copy, sql);
    ASSERT_TRUE(fs::exists(copy.string() + "-journal"));
    fs::rename(copy.string() + "-journal", file.string() + "-journal");
    expectUntouched("-journal");
  }
}

TEST_F(ForeignCompanion, JournalIsNotUsedBesideTheRecordingsOwnLog)
{
  record(other, "other", 3000);
  leaveJournal(other, "DELETE FROM block; UPDATE meta SET value = value || 'x'");
  crash(file, "mine", 500);
  fs::copy_file(other.string() + "-journal", file.string() + "-journal");
  const std::string journal = contentOf(file.string() + "-journal");
  const auto opened = RecordedInsertion::open(file);
  ASSERT_TRUE(opened) << opened.error().message;
  EXPECT_EQ(opened->ticks(), 500u);
  EXPECT_EQ(opened->check()->damage, "");
  EXPECT_THAT(opened->note(), HasSubstr("-journal"));
  EXPECT_EQ(contentOf(file.string() + "-journal"), journal);
}

TEST_F(ForeignCompanion, IsRefusedBeforeAClosedRecordingGoesOn)
{
  auto recording = Recording::create(file, factsNamed("mine"));
  ASSERT_TRUE(recording);
  ASSERT_TRUE((*recording)->append(test::quietRecords(0, 500)));
  ASSERT_TRUE((*recording)->close());
  crash(other, "other", 400);
  fs::copy_file(other.string() + "-wal", file.string() + "-wal");
  const auto more = (*recording)->append(test::quietRecords(500, 20));
  ASSERT_FALSE(more);
  EXPECT_THAT(more.error().message, HasSubstr("mine.insertion-wal"));
  recording->reset();
  expectUntouched("-wal");
}

TEST(TheOwnLog, OfACrashedRecordingIsRecovered)
{
  for (const std::uint64_t ticks : {20u, 1000u, 1040u, 20000u}) {
    const test::TemporaryFolder folder;
    const fs::path file = folder / "mine.insertion";
    crash(file, "mine", ticks);
    for (int i = 0; i < 2; ++i) {
      const auto opened = RecordedInsertion::open(file);
      ASSERT_TRUE(opened) << opened.error().message;
      EXPECT_EQ(opened->ticks(), ticks);
      EXPECT_EQ(opened->note(), "");
      EXPECT_EQ(opened->check()->damage, "");
    }
    EXPECT_FALSE(fs::exists(file.string() + "-wal"));
  }
}

TEST(TheOwnLog, ThatIsDamagedIsKeptAndNamed)
{
  constexpr std::uint64_t ticks = 2240;
  for (const double part : {0.1, 0.5, 0.9}) {
    const test::TemporaryFolder folder;
    const fs::path file = folder / "mine.insertion", log = file.string() + "-wal";
    crash(file, "mine", ticks);
    std::string damaged = contentOf(log);
    damaged[static_cast<std::size_t>(part * static_cast<double>(damaged.size()))] ^= 1;
    std::ofstream(log, std::ios::binary) << damaged;
    {
      const auto opened = RecordedInsertion::open(file);
      ASSERT_TRUE(opened) << opened.error().message;
      EXPECT_LT(opened->ticks(), ticks);
      EXPECT_THAT(opened->note(), AllOf(HasSubstr(log.string() + " is damaged at byte "),
                                        HasSubstr("mine.insertion-wal.damaged")));
    }
    EXPECT_EQ(contentOf(log.string() + ".damaged"), damaged);
  }
}

TEST(TheOwnLog, OfARecordingThatWentOnAfterItWasClosedIsRecovered)
{
  const test::TemporaryFolder folder;
  const fs::path file = folder / "mine.insertion";
  killedAfter([&] {
    auto recording = Recording::create(file, factsNamed("mine"));
    return recording && (*recording)->append(test::quietRecords(0, 100)) && (*recording)->close() &&
           (*recording)->append(test::quietRecords(100, 50)) && ::raise(SIGKILL) == 0;
  });
  const auto opened = RecordedInsertion::open(file);
  ASSERT_TRUE(opened) << opened.error().message;
  EXPECT_EQ(opened->ticks(), 150u);
  EXPECT_FALSE(opened->wasClosed());
  EXPECT_EQ(opened->check()->damage, "");
}

/// A process that records a tick every millisecond until it is ended.
class Recorder {
public:
  explicit Recorder(const fs::path& file)
  {
    int ready[2];
    EXPECT_EQ(::pipe(ready), 0);
    id_ = ::fork();
    if (id_ == 0) {
      auto recording = Recording::create(file, factsNamed("live"));
      for (std::uint64_t tick = 0; recording; tick += 10) {
        if (!(*recording)->append(test::quietRecords(tick, 10))) break;
        if (tick == 1000 && ::write(ready[1], "r", 1) != 1) break;
      }
      ::_exit(1);
    }
    char letter = 0;
    EXPECT_EQ(::read(ready[0], &letter, 1), 1);
    ::close(ready[0]);
    ::close(ready[1]);
  }
  ~Recorder()
  {
    ::kill(id_, SIGKILL);
    ::waitpid(id_, nullptr, 0);
  }

private:
  pid_t id_ = 0;
};

TEST(ARecordingInProgress, IsReadAsOneState)
{
  const test::TemporaryFolder folder;
  const fs::path file = folder / "live.insertion";
  const Recorder recorder(file);
  for (int i = 0; i < 20; ++i) {
    const auto opened = RecordedInsertion::open(file);
    ASSERT_TRUE(opened) << opened.error().message;
    EXPECT_TRUE(opened->isBeingWritten());
    EXPECT_THAT(opened->note(),
                AllOf(HasSubstr("live.insertion"), HasSubstr("still being recorded")));
    const std::uint64_t ticks = opened->ticks();
    EXPECT_GE(ticks, 1000u);
    const auto check = opened->check();
    ASSERT_TRUE(check) << check.error().message;
    EXPECT_EQ(check->damage, "");
    EXPECT_EQ(check->ticks, ticks);
    std::uint64_t read = 0;
    EXPECT_TRUE(opened->forEach([&](const auto&) { return ++read > 0; }));
    EXPECT_EQ(read, ticks);
    EXPECT_EQ(opened->highlights()->ticks, ticks);
  }
}

TEST(ARecordingInProgress, OfThisProcessKeepsItsLocks)
{
  const test::TemporaryFolder folder;
  const fs::path file = folder / "live.insertion";
  auto recording = Recording::create(file, factsNamed("live"));
  ASSERT_TRUE(recording);
  ASSERT_TRUE((*recording)->append(test::quietRecords(0, 100)));
  ASSERT_TRUE(RecordedInsertion::open(file));
  // another process opens it and closes it: it must not believe that nobody else has it open
  const pid_t child = ::fork();
  if (child == 0) {
    sqlite3* database = nullptr;
    const bool isRead =
        sqlite3_open(file.c_str(), &database) == SQLITE_OK &&
        sqlite3_exec(database, "SELECT * FROM meta", nullptr, nullptr, nullptr) == SQLITE_OK;
    sqlite3_close(database);
    ::_exit(isRead ? 0 : 1);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  EXPECT_EQ(status, 0);
  EXPECT_TRUE(fs::exists(file.string() + "-wal"));
  ASSERT_TRUE((*recording)->append(test::quietRecords(100, 50)));
  ASSERT_TRUE((*recording)->close());
  EXPECT_EQ(RecordedInsertion::open(file)->ticks(), 150u);
}

TEST(ARecordingThatIsNoMoreWritten, IsNotCalledSo)
{
  const test::TemporaryFolder folder;
  const fs::path file = folder / "live.insertion";
  {
    const Recorder recorder(file);
  }
  const auto opened = RecordedInsertion::open(file);
  ASSERT_TRUE(opened) << opened.error().message;
  EXPECT_FALSE(opened->isBeingWritten());
  EXPECT_EQ(opened->note(), "");
}

TEST(ATableOfTicks, GoesIntoNothingButAFile)
{
  const test::TemporaryFolder folder;
  record(folder / "mine.insertion", "mine", 50);
  const auto opened = RecordedInsertion::open(folder / "mine.insertion");
  ASSERT_TRUE(opened);
  ASSERT_EQ(::mkfifo((folder / "pipe").c_str(), 0600), 0);
  for (const fs::path& place : {fs::path(folder / "pipe"), fs::path("/dev/full"), folder.path()}) {
    const auto written = writeTickTable(*opened, place);
    ASSERT_FALSE(written) << place;
    EXPECT_THAT(written.error().message, HasSubstr(place.string() + " is not a file"));
  }
}

}  // namespace
}  // namespace perilymph::session
