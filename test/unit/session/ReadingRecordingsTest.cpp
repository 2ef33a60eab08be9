// SPDX-License-Identifier: BSD-3-Clause

// Recordings in the field: of crashed programs, truncated, of newer versions, in read-only folders.

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <fstream>

#include "perilymph/session/RecordedInsertion.h"
#include "perilymph/test/Forgery.h"
#include "perilymph/test/OddRecords.h"
#include "perilymph/test/Places.h"
#include "perilymph/test/TemporaryFolder.h"

namespace perilymph::session {
namespace {

namespace fs = std::filesystem;
using test::runSql;
using testing::HasSubstr;

/// A closed recording with a number of ticks.
fs::path recorded(const test::TemporaryFolder& folder, std::uint64_t ticks)
{
  const fs::path file = folder / "some.insertion";
  auto recording = Recording::create(file, test::someFacts());
  EXPECT_TRUE(recording);
  EXPECT_TRUE((*recording)->append(test::quietRecords(0, ticks)));
  EXPECT_TRUE((*recording)->close());
  return file;
}

/// A recording whose program was killed after a number of drains of 20 ticks.
fs::path crashed(const test::TemporaryFolder& folder, std::uint64_t drains)
{
  const fs::path file = folder / "crashed.insertion";
  const pid_t child = ::fork();
  if (child == 0) {
    auto recording = Recording::create(file, test::someFacts());
    for (std::uint64_t i = 0; recording && i < drains; ++i)
      if (!(*recording)->append(test::quietRecords(20 * i, 20))) ::_exit(1);
    ::raise(SIGKILL);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  EXPECT_TRUE(WIFSIGNALED(status));
  return file;
}

std::string refusal(const fs::path& file)
{
  const auto opened = RecordedInsertion::open(file);
  return opened ? "opened" : opened.error().message;
}

/// Drops root's rights until it is destroyed; without effect for other users.
class Nobody {
public:
  Nobody()
  {
    if (::geteuid() == 0) isChanged_ = ::seteuid(65534) == 0;
  }
  ~Nobody()
  {
    if (isChanged_ && ::seteuid(0) != 0) ADD_FAILURE() << "could not become root again";
  }

private:
  bool isChanged_ = false;
};

TEST(CrashedRecording, KeepsEveryDrainThatHadReturned)
{
  const test::TemporaryFolder folder;
  const auto opened = RecordedInsertion::open(crashed(folder, 30));
  ASSERT_TRUE(opened) << opened.error().message;
  EXPECT_EQ(opened->ticks(), 600u);
  EXPECT_FALSE(opened->wasClosed());
  EXPECT_EQ(opened->note(), "");
}

TEST(CrashedRecording, IsReadAsFarAsItWasFoldedWhereNothingMayBeWritten)
{
  const test::TemporaryFolder folder;
  ::chmod(folder.path().c_str(), 0755);
  const fs::path file = crashed(folder, 30);
  ::chmod(file.c_str(), 0444);
  ::chmod(folder.path().c_str(), 0555);
  {
    const Nobody nobody;
    const auto opened = RecordedInsertion::open(file);
    ASSERT_TRUE(opened) << opened.error().message;
    EXPECT_LE(opened->ticks(), 600u);
    EXPECT_THAT(opened->note(), HasSubstr("-wal"));
    EXPECT_EQ(opened->facts().scenarioName, "somewhere");
  }
  ::chmod(folder.path().c_str(), 0755);
}

TEST(ClosedRecording, IsReadWholeWhereNothingMayBeWritten)
{
  const test::TemporaryFolder folder;
  ::chmod(folder.path().c_str(), 0755);
  const fs::path file = recorded(folder, 50);
  ::chmod(file.c_str(), 0444);
  ::chmod(folder.path().c_str(), 0555);
  {
    const Nobody nobody;
    const auto opened = RecordedInsertion::open(file);
    ASSERT_TRUE(opened) << opened.error().message;
    EXPECT_EQ(opened->ticks(), 50u);
    EXPECT_EQ(opened->note(), "");
  }
  ::chmod(folder.path().c_str(), 0755);
}

TEST(OpeningARecording, SaysThatThereIsNone)
{
  const test::TemporaryFolder folder;
  EXPECT_THAT(refusal(folder / "none.insertion"), HasSubstr("does not exist"));
  EXPECT_THAT(refusal(folder.path()), HasSubstr("is a folder"));
}

TEST(OpeningARecording, SaysThatItIsSomethingElse)
{
  const test::TemporaryFolder folder;
  std::ofstream(folder / "text.insertion") << "time_s,travel_mm\n0,0\n";
  EXPECT_THAT(refusal(folder / "text.insertion"), HasSubstr("not a recording"));
  std::ofstream(folder / "empty.insertion") << "";
  EXPECT_THAT(refusal(folder / "empty.insertion"), HasSubstr("not a recording"));
  runSql(folder / "other.db", "CREATE TABLE meta(key, value); INSERT INTO meta VALUES(1, 2)");
  EXPECT_THAT(refusal(folder / "other.db"), HasSubstr("not a recording"));
}

TEST(OpeningARecording, SaysThatItIsTooNew)
{
  const test::TemporaryFolder folder;
  const fs::path file = recorded(folder, 5);
  runSql(file, "PRAGMA user_version=9");
  EXPECT_THAT(refusal(file), testing::AllOf(HasSubstr("format 9"), HasSubstr("newer version")));
}

TEST(OpeningARecording, SaysThatItIsCutShort)
{
  const test::TemporaryFolder folder;
  const fs::path file = recorded(folder, 500);
  for (const std::uintmax_t size : {fs::file_size(file) - 1, fs::file_size(file) / 2,
                                    std::uintmax_t{4096}, std::uintmax_t{50}}) {
    fs::resize_file(file, size);
    EXPECT_THAT(refusal(file), HasSubstr("damaged")) << size;
  }
}

TEST(OpeningARecording, SaysThatItsFactsAreMissing)
{
  const test::TemporaryFolder folder;
  const fs::path file = recorded(folder, 5);
  runSql(file, "DELETE FROM meta WHERE key = 'scenario'");
  EXPECT_THAT(refusal(file), HasSubstr("damaged"));
}

TEST(OpeningARecording, RefusesFactsThatAreThereAndUnreadable)
{
  for (const char* change :
       {"value = 'yes' WHERE key = 'closed'", "value = '2' WHERE key = 'feels_force'",
        "value = '12 mm' WHERE key = 'reach_m'", "value = '' WHERE key = 'max_stiffness_N_m'",
        "value = 'none' WHERE key = 'off_time_s'"}) {
    const test::TemporaryFolder folder;
    const fs::path file = recorded(folder, 3);
    runSql(file, std::string("UPDATE meta SET ") + change);
    EXPECT_THAT(refusal(file), HasSubstr("damaged")) << change;
  }
}

TEST(ReadingTicks, StopsAtAnInvalidBlock)
{
  const test::TemporaryFolder folder;
  const fs::path file = recorded(folder, 2500);  // blocks that begin at 0, 1024 and 2048
  const fs::path whole = folder / "whole";
  fs::copy_file(file, whole);
  for (const char* change :
       {"SET packed = x'01'", "SET packed = zeroblob(100000)", "SET packed = 'text'",
        "SET packed = substr(packed, 1, length(packed) - 1)",
        "SET packed = CAST(packed || x'00' AS BLOB)",
        "SET packed = (SELECT packed FROM block WHERE tick = 0)", "SET ticks = 1023",
        "SET ticks = 1025", "SET ticks = 0", "SET ticks = -1", "SET ticks = 1000000000000",
        "SET ticks = 'many'", "SET tick = 1025", "SET tick = 5", "SET tick = 1023"}) {
    SCOPED_TRACE(change);
    fs::copy_file(whole, file, fs::copy_options::overwrite_existing);
    runSql(file, std::string("UPDATE block ") + change + " WHERE tick = 1024");
    const auto opened = RecordedInsertion::open(file);
    ASSERT_TRUE(opened);
    std::uint64_t seen = 0;
    const auto read = opened->forEach([&](const haptics::TickRecord&) { return ++seen > 0; });
    ASSERT_FALSE(read);
    EXPECT_THAT(read.error().message, HasSubstr("the block of tick"));
    EXPECT_LE(seen, 1024u);
    EXPECT_FALSE(opened->check());
  }
}

TEST(ReadingTicks, BeginsAndEndsWithinABlock)
{
  const test::TemporaryFolder folder;
  const auto opened = RecordedInsertion::open(recorded(folder, 2500));
  ASSERT_TRUE(opened);
  EXPECT_EQ(opened->ticks(), 2500u);
  for (const std::uint64_t first : {0u, 1u, 1023u, 1024u, 1025u, 2499u}) {
    std::vector<std::uint64_t> seen;
    ASSERT_TRUE(opened->forEach(
        [&](const haptics::TickRecord& record) {
          seen.push_back(record.tick);
          return seen.size() < 3;
        },
        first));
    std::vector<std::uint64_t> expected;
    for (std::uint64_t tick = first; tick < std::min<std::uint64_t>(2500, first + 3); ++tick)
      expected.push_back(tick);
    EXPECT_EQ(seen, expected);
  }
  EXPECT_TRUE(opened->forEach([](const auto&) { return ADD_FAILURE(), false; }, 2500));
}

TEST(ReadingTicks, OfFormat2StopsAtAnInvalidRecord)
{
  const test::TemporaryFolder folder;
  const fs::path file = folder / "some.insertion";
  fs::copy_file(test::testData() / "recordings/version-0.2/contour-published-rod.insertion", file);
  for (const char* change : {"UPDATE tick SET record = x'01' WHERE tick = 4",
                             "UPDATE tick SET record = (SELECT record FROM tick WHERE tick = 3) "
                             "WHERE tick = 4",
                             "UPDATE tick SET record = zeroblob(100000) WHERE tick = 4"}) {
    runSql(file, change);
    const auto opened = RecordedInsertion::open(file);
    ASSERT_TRUE(opened);
    std::uint64_t seen = 0;
    const auto read = opened->forEach([&](const haptics::TickRecord&) { return ++seen > 0; });
    ASSERT_FALSE(read) << change;
    EXPECT_THAT(read.error().message, HasSubstr("tick 4"));
    EXPECT_EQ(seen, 4u);
  }
}

TEST(ReadingTicks, SurvivesAnyByteThatFlips)
{
  const test::TemporaryFolder folder;
  const fs::path file = recorded(folder, 20);
  std::ifstream stream(file, std::ios::binary);
  const std::string whole(std::istreambuf_iterator<char>(stream), {});
  for (std::size_t place = 0; place < whole.size(); place += 97) {
    std::string damaged = whole;
    damaged[place] = static_cast<char>(damaged[place] ^ 0x55);
    const fs::path copy = folder / "copy.insertion";
    std::ofstream(copy, std::ios::binary) << damaged;
    const auto opened = RecordedInsertion::open(copy);
    // Every error has a message.
    if (!opened) {
      EXPECT_THAT(opened.error().message, HasSubstr("copy.insertion")) << place;
      continue;
    }
    const auto read = opened->forEach([](const haptics::TickRecord&) { return true; });
    if (!read) {
      EXPECT_THAT(read.error().message, HasSubstr("copy.insertion")) << place;
    }
  }
}

}  // namespace
}  // namespace perilymph::session
