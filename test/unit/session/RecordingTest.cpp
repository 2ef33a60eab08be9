// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/session/Recording.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sqlite3.h>
#include <sys/stat.h>

#include <fstream>

#include "perilymph/foundation/AtomicFile.h"
#include "perilymph/session/RecordedInsertion.h"
#include "perilymph/test/OddRecords.h"
#include "perilymph/test/TemporaryFolder.h"
#include "perilymph/test/waitUntil.h"

namespace perilymph::session {
namespace {

using testing::AllOf;
using testing::HasSubstr;

/// The first column of every row as another program reads it.
std::vector<std::string> query(const std::filesystem::path& file, const std::string& sql)
{
  sqlite3* database = nullptr;
  EXPECT_EQ(sqlite3_open_v2(file.c_str(), &database, SQLITE_OPEN_READWRITE, nullptr), SQLITE_OK);
  std::vector<std::string> rows;
  const auto collect = [](void* to, int, char** values, char**) {
    static_cast<std::vector<std::string>*>(to)->push_back(values[0] ? values[0] : "NULL");
    return 0;
  };
  EXPECT_EQ(sqlite3_exec(database, sql.c_str(), collect, &rows, nullptr), SQLITE_OK) << sql;
  sqlite3_close(database);
  return rows;
}

std::size_t filesIn(const std::filesystem::path& folder)
{
  const std::filesystem::directory_iterator entries(folder);
  return static_cast<std::size_t>(std::distance(begin(entries), end(entries)));
}

TEST(Recording, GivesBackEveryBitOfEveryTick)
{
  const test::TemporaryFolder folder;
  std::vector<haptics::TickRecord> written;
  for (std::uint64_t tick = 0; tick < 500; ++tick) written.push_back(test::oddRecord(tick));
  {
    auto recording = Recording::create(folder / "odd.insertion", test::someFacts());
    ASSERT_TRUE(recording) << recording.error().message;
    ASSERT_TRUE((*recording)->append(written));
  }
  const auto recorded = RecordedInsertion::open(folder / "odd.insertion");
  ASSERT_TRUE(recorded) << recorded.error().message;
  std::size_t next = 0;
  const auto read = recorded->forEach([&](const haptics::TickRecord& record) {
    EXPECT_EQ(test::bitsOf(record), test::bitsOf(written[next])) << next;
    ++next;
    return true;
  });
  EXPECT_TRUE(read);
  EXPECT_EQ(next, written.size());
}

TEST(Recording, GivesBackItsFactsToTheLastBit)
{
  const test::TemporaryFolder folder;
  const RecordingFacts facts = test::someFacts();
  {
    auto recording = Recording::create(folder / "facts.insertion", facts);
    ASSERT_TRUE(recording);
    ASSERT_TRUE((*recording)->close(3));
  }
  const auto recorded = RecordedInsertion::open(folder / "facts.insertion");
  ASSERT_TRUE(recorded) << recorded.error().message;
  EXPECT_EQ(recorded->facts().scenarioText, facts.scenarioText);
  EXPECT_EQ(recorded->facts().timeStep, facts.timeStep);
  EXPECT_EQ(recorded->facts().run.samplePeriod, facts.run.samplePeriod);
  EXPECT_EQ(recorded->facts().modelFingerprint, facts.modelFingerprint);
  EXPECT_EQ(recorded->facts().seed, facts.seed);
  EXPECT_EQ(recorded->lostRecords(), 3u);
  EXPECT_TRUE(recorded->wasClosed());
}

TEST(Recording, IsOneFileOnceClosed)
{
  const test::TemporaryFolder folder;
  auto recording = Recording::create(folder / "one.insertion", test::someFacts());
  ASSERT_TRUE(recording);
  ASSERT_TRUE((*recording)->append(test::quietRecords(0, 100)));
  EXPECT_GT(filesIn(folder.path()), 1u);  // the write-ahead log
  ASSERT_TRUE((*recording)->close());
  EXPECT_EQ(filesIn(folder.path()), 1u);
}

TEST(Recording, GoesOnAfterItWasClosed)
{
  const test::TemporaryFolder folder;
  const std::filesystem::path file = folder / "withdrawn.insertion";
  auto recording = Recording::create(file, test::someFacts());
  ASSERT_TRUE(recording);
  ASSERT_TRUE((*recording)->append(test::quietRecords(0, 100)));
  ASSERT_TRUE((*recording)->close(2));
  const auto expectWhole = [&](std::uint64_t ticks, std::uint64_t lost, bool isClosed) {
    const auto recorded = RecordedInsertion::open(file);
    ASSERT_TRUE(recorded) << recorded.error().message;
    EXPECT_EQ(recorded->ticks(), ticks);
    EXPECT_EQ(recorded->highlights()->ticks, ticks);
    EXPECT_EQ(recorded->lostRecords(), lost);
    EXPECT_EQ(recorded->wasClosed(), isClosed);
    const auto check = recorded->check();
    ASSERT_TRUE(check);
    EXPECT_EQ(check->damage, "");
  };
  expectWhole(100, 2, true);
  EXPECT_EQ(filesIn(folder.path()), 1u);
  ASSERT_TRUE((*recording)->append(test::quietRecords(100, 50)));
  expectWhole(150, 2, false);
  ASSERT_TRUE((*recording)->close(3));
  expectWhole(150, 3, true);
  ASSERT_TRUE((*recording)->close(3, "{}"));  // what the device did, once the loop has ended
  expectWhole(150, 3, true);
  EXPECT_EQ(query(file, "SELECT value FROM meta WHERE key = 'device_report'"),
            std::vector<std::string>{"{}"});
  EXPECT_EQ(filesIn(folder.path()), 1u);
}

TEST(Recording, IsConcludedBesideAReaderAndGoesOn)
{
  const test::TemporaryFolder folder;
  const std::filesystem::path file = folder / "read.insertion";
  auto recording = Recording::create(file, test::someFacts());
  ASSERT_TRUE(recording);
  ASSERT_TRUE((*recording)->append(test::quietRecords(0, 100)));
  std::optional<Result<RecordedInsertion>> reader(RecordedInsertion::open(file));
  ASSERT_TRUE(*reader) << reader->error().message;
  const auto concluded = [&] {
    const auto merged = (*recording)->conclude(0);
    EXPECT_TRUE(merged) << (merged ? "" : merged.error().message);
    return merged && *merged;
  };
  EXPECT_FALSE(concluded()) << "it has a reader";
  EXPECT_FALSE(concluded()) << "asked again";
  ASSERT_TRUE((*recording)->append(test::quietRecords(100, 50)));
  EXPECT_FALSE(RecordedInsertion::open(file)->wasClosed()) << "it went on";
  EXPECT_FALSE(concluded());
  EXPECT_TRUE(RecordedInsertion::open(file)->wasClosed());
  reader.reset();
  EXPECT_TRUE(concluded());
  EXPECT_EQ(filesIn(folder.path()), 1u);
  const auto whole = RecordedInsertion::open(file);
  ASSERT_TRUE(whole) << whole.error().message;
  EXPECT_EQ(whole->ticks(), 150u);
  EXPECT_EQ(whole->check()->damage, "");
}

TEST(Recording, ThatIsStillReadAtItsEndIsCompleteAndMergedByItsReader)
{
  const test::TemporaryFolder folder;
  const std::filesystem::path file = folder / "read.insertion";
  auto recording = Recording::create(file, test::someFacts());
  ASSERT_TRUE(recording);
  ASSERT_TRUE((*recording)->append(test::quietRecords(0, 100)));
  {
    const auto reader = RecordedInsertion::open(file);
    ASSERT_TRUE(reader);
    const auto closed = (*recording)->close();
    ASSERT_FALSE(closed);
    EXPECT_NE(closed.error().message.find("is complete, but in several files"), std::string::npos);
  }
  EXPECT_TRUE(RecordedInsertion::open(file)->wasClosed());
  EXPECT_EQ(filesIn(folder.path()), 1u);
}

TEST(Recording, ThatWasMovedAfterItWasClosedStaysAsItIs)
{
  const test::TemporaryFolder folder;
  auto recording = Recording::create(folder / "here.insertion", test::someFacts());
  ASSERT_TRUE(recording);
  ASSERT_TRUE((*recording)->append(test::quietRecords(0, 100)));
  ASSERT_TRUE((*recording)->close());
  std::filesystem::rename(folder / "here.insertion", folder / "there.insertion");
  EXPECT_FALSE((*recording)->append(test::quietRecords(100, 50)));
  recording->reset();
  const auto recorded = RecordedInsertion::open(folder / "there.insertion");
  ASSERT_TRUE(recorded) << recorded.error().message;
  EXPECT_EQ(recorded->ticks(), 100u);
  EXPECT_TRUE(recorded->wasClosed());
  EXPECT_EQ(filesIn(folder.path()), 1u);
}

TEST(Recording, IsReadableForItsOwnerOnly)
{
  const test::TemporaryFolder folder;
  const auto before = ::umask(0);
  const auto recording = Recording::create(folder / "a.insertion", test::someFacts());
  ::umask(before);
  ASSERT_TRUE(recording);
  for (const auto& entry : std::filesystem::directory_iterator(folder.path()))
    EXPECT_EQ(entry.status().permissions(), std::filesystem::perms(0600)) << entry.path();
}

TEST(Recording, ShowsItsRowsToOtherProgramsWhileItRuns)
{
  const test::TemporaryFolder folder;
  auto recording = Recording::create(folder / "live.insertion", test::someFacts());
  ASSERT_TRUE(recording);
  auto records = test::quietRecords(0, 20);
  records[7].output.axialForce = 0.125;
  ASSERT_TRUE((*recording)->append(records));
  EXPECT_EQ(query(folder / "live.insertion", "SELECT SUM(ticks) FROM block"),
            std::vector<std::string>{"20"});
  const auto reader = RecordedInsertion::open(folder / "live.insertion");
  ASSERT_TRUE(reader) << reader.error().message;
  std::vector<double> forces;
  EXPECT_TRUE(reader->forEach([&forces](const haptics::TickRecord& record) {
    forces.push_back(record.output.axialForce);
    return true;
  }));
  ASSERT_EQ(forces.size(), 20u);
  EXPECT_EQ(forces[7], 0.125);
  EXPECT_TRUE((*recording)->append(test::quietRecords(20, 20)));  // a reader does not block it
}

TEST(Recording, WritesDownCommandsAndChanges)
{
  const test::TemporaryFolder folder;
  auto records = test::quietRecords(0, 6);
  records[0].commands.count = 1;
  records[0].commands.items[0].kind = haptics::Command::Kind::arm;
  for (std::size_t i = 1; i < 6; ++i) records[i].output.workflow = haptics::Workflow::inserting;
  records[3].output.status = haptics::forceClamped;
  records[4].output.status = haptics::forceClamped;
  {
    auto recording = Recording::create(folder / "events.insertion", test::someFacts());
    ASSERT_TRUE(recording);
    ASSERT_TRUE((*recording)->append(records));
  }
  EXPECT_EQ(
      query(folder / "events.insertion",
            "SELECT tick || ' ' || kind || ' ' || value FROM event ORDER BY rowid"),
      (std::vector<std::string>{"0 arm 0.0", "1 workflow inserting", "3 status forceClamped"}));
}

TEST(Recording, CountsTheTicksThatNeverCame)
{
  const test::TemporaryFolder folder;
  {
    auto recording = Recording::create(folder / "gaps.insertion", test::someFacts());
    ASSERT_TRUE(recording);
    ASSERT_TRUE((*recording)->append(test::quietRecords(0, 10)));
    ASSERT_TRUE((*recording)->append(test::quietRecords(15, 10)));  // 10 to 14 are missing
  }
  const auto recorded = RecordedInsertion::open(folder / "gaps.insertion");
  ASSERT_TRUE(recorded);
  EXPECT_EQ(recorded->lostRecords(), 5u);
  EXPECT_EQ(recorded->ticks(), 20u);
}

TEST(Recording, NeverOverwritesAnything)
{
  const test::TemporaryFolder folder;
  std::ofstream(folder / "mine.insertion") << "something dear";
  const auto recording = Recording::create(folder / "mine.insertion", test::someFacts());
  ASSERT_FALSE(recording);
  EXPECT_THAT(recording.error().message, AllOf(HasSubstr("mine.insertion"), HasSubstr("never")));
  std::ifstream stream(folder / "mine.insertion");
  EXPECT_EQ(std::string(std::istreambuf_iterator<char>(stream), {}), "something dear");
}

TEST(Recording, IsWholeAsSoonAsItHasItsName)
{
  const test::TemporaryFolder folder;
  for (int i = 0; i < 8; ++i) {
    const std::filesystem::path file = folder / (std::to_string(i) + ".insertion");
    Result<std::unique_ptr<Recording>> recording = Error{"not yet"};
    std::thread maker([&] { recording = Recording::create(file, test::someFacts()); });
    // as of a process that is killed then
    EXPECT_TRUE(test::waitUntil([&] { return std::filesystem::exists(file); }));
    const auto copied = readWhole(file);
    maker.join();
    ASSERT_TRUE(recording) << recording.error().message;
    ASSERT_TRUE(copied);
    const std::filesystem::path copy = folder / "copy.insertion";
    ASSERT_TRUE(writeWhole(copy, *copied));
    const auto recorded = RecordedInsertion::open(copy);
    ASSERT_TRUE(recorded) << recorded.error().message;
    EXPECT_EQ(recorded->facts().startedUtc, test::someFacts().startedUtc);
  }
  for (const auto& entry : std::filesystem::directory_iterator(folder.path()))
    EXPECT_EQ(entry.path().filename().string().find(".part"), std::string::npos) << entry;
}

TEST(Recording, SaysWhereItCannotBegin)
{
  const test::TemporaryFolder folder;
  const auto nowhere = Recording::create(folder / "no" / "x.insertion", test::someFacts());
  ASSERT_FALSE(nowhere);
  EXPECT_THAT(nowhere.error().message, HasSubstr("does not exist"));
  const auto inPlaceOfAFolder = Recording::create(folder.path(), test::someFacts());
  ASSERT_FALSE(inPlaceOfAFolder);
  EXPECT_THAT(inPlaceOfAFolder.error().message, HasSubstr("is a folder"));
}

class RecordingThatIsTaken : public testing::Test {
protected:
  RecordingThatIsTaken()
  {
    auto created = Recording::create(file, test::someFacts());
    EXPECT_TRUE(created);
    recording = std::move(*created);
    EXPECT_TRUE(recording->append(test::quietRecords(0, 20)));
  }

  void expectGone(const Result<void>& done) const
  {
    ASSERT_FALSE(done);
    EXPECT_THAT(done.error().message,
                AllOf(HasSubstr("mine.insertion was moved or deleted while it was recorded"),
                      HasSubstr("Start a new recording")));
  }

  const test::TemporaryFolder folder;
  const std::filesystem::path file = folder / "mine.insertion";
  std::unique_ptr<Recording> recording;
};

TEST_F(RecordingThatIsTaken, ByBeingDeletedSaysSoAtTheNextDrain)
{
  std::filesystem::remove(file);
  expectGone(recording->append(test::quietRecords(20, 20)));
}

TEST_F(RecordingThatIsTaken, AfterTheLastDrainSaysSoWhenItIsClosed)
{
  std::filesystem::remove(file);
  expectGone(recording->close());
}

TEST_F(RecordingThatIsTaken, ByBeingMovedKeepsWhatItHolds)
{
  std::filesystem::rename(file, folder / "elsewhere.insertion");
  expectGone(recording->append(test::quietRecords(20, 20)));
  recording.reset();
  const auto recorded = RecordedInsertion::open(folder / "elsewhere.insertion");
  ASSERT_TRUE(recorded) << recorded.error().message;
  EXPECT_EQ(recorded->ticks(), 40u);
  EXPECT_FALSE(recorded->wasClosed());
}

TEST_F(RecordingThatIsTaken, AndReplacedLeavesTheOtherFileAndItsLogAlone)
{
  std::filesystem::remove(file);
  std::filesystem::remove(file.string() + "-wal");
  std::ofstream(file) << "somebody else's";
  std::ofstream(file.string() + "-wal") << "somebody else's log";
  expectGone(recording->append(test::quietRecords(20, 20)));
  recording.reset();
  for (const auto& [name, content] : {std::pair{file.string(), "somebody else's"},
                                      {file.string() + "-wal", "somebody else's log"}}) {
    std::ifstream stream(name);
    EXPECT_EQ(std::string(std::istreambuf_iterator<char>(stream), {}), content) << name;
  }
}

TEST(Recording, AcceptsNamesWithSpecialCharacters)
{
  const test::TemporaryFolder folder;
  for (const char* name : {"50%20 done?mode=ro#x.insertion", "a b&c.insertion"}) {
    const auto recording = Recording::create(folder / name, test::someFacts());
    ASSERT_TRUE(recording) << recording.error().message;
    EXPECT_TRUE((*recording)->append(test::quietRecords(0, 3)));
    EXPECT_TRUE((*recording)->close());
    const auto recorded = RecordedInsertion::open(folder / name);
    ASSERT_TRUE(recorded) << recorded.error().message;
    EXPECT_EQ(recorded->ticks(), 3u);
  }
}

}  // namespace
}  // namespace perilymph::session
