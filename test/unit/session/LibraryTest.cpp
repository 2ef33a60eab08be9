// SPDX-License-Identifier: BSD-3-Clause

// The library: recordings are found, listed without being read again, renamed, deleted, restored.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <stop_token>

#include "perilymph/session/RecordedInsertion.h"
#include "perilymph/session/SessionLibrary.h"
#include "perilymph/test/AllocationLimit.h"
#include "perilymph/test/Forgery.h"
#include "perilymph/test/OddRecords.h"
#include "perilymph/test/TemporaryFolder.h"

namespace perilymph::session {
namespace {

namespace fs = std::filesystem;
using test::runSql;
using testing::HasSubstr;
using testing::IsEmpty;

/// Ticks of a straight insertion at 2 mm/s; the force rises to 0.1 N at 3 mm and falls again.
std::vector<haptics::TickRecord> hillOfForce()
{
  std::vector<haptics::TickRecord> records(3001);
  for (std::size_t i = 0; i < records.size(); ++i) {
    records[i].tick = i;
    haptics::TickOutput& now = records[i].output;
    now.time = 1e-3 * static_cast<double>(i);
    now.workflow = haptics::Workflow::inserting;
    now.travel = 2e-3 * now.time;
    now.depth = now.travel + 2e-3;
    now.angularDepth = now.time;
    now.axialForce = 0.1 - 20.0 * std::abs(now.travel - 3e-3);
  }
  return records;
}

fs::path record(const fs::path& file, const std::string& startedUtc,
                const std::vector<haptics::TickRecord>& ticks)
{
  RecordingFacts facts = test::someFacts();
  facts.startedUtc = startedUtc;
  facts.scenarioText =
      "anatomy = \"published\"\narray = \"contour\"\nside = \"left\"\n\n[patient_numbers]\n"
      "label = \"014\"\nst_length_mm = 35.58\nrw_width_mm = 1.94\nrw_height_mm = 1.85\n";
  auto recording = Recording::create(file, facts);
  EXPECT_TRUE(recording);
  EXPECT_TRUE((*recording)->append(ticks));
  EXPECT_TRUE((*recording)->close());
  return file;
}

class Library : public testing::Test {
protected:
  std::vector<SessionSummary> list()
  {
    auto listed = listSessions(folder_.path());
    EXPECT_TRUE(listed) << listed.error().message;
    return listed ? *listed : std::vector<SessionSummary>{};
  }

  /// Replaces a word in the index, which shows whether a recording or its index was read.
  void renameInIndex(const std::string& word, const std::string& by)
  {
    const fs::path index = libraryCache(folder_.path()) / "index.json";
    std::ifstream stream(index);
    std::string text(std::istreambuf_iterator<char>(stream), {});
    const auto place = text.find('"' + word + '"');
    ASSERT_NE(place, std::string::npos);
    std::ofstream(index) << text.replace(place + 1, word.size(), by);
  }

  test::TemporaryFolder folder_;
};

TEST(NameOfARecording, LeavesOutTheTimeOfAutomaticNames)
{
  EXPECT_EQ(displayNameOf("s/20261122T014506Z-P-017.insertion"), "P-017");
  EXPECT_EQ(displayNameOf("s/20261122T014506Z-contour-published-2.insertion"),
            "contour-published-2");
  EXPECT_EQ(displayNameOf("s/tuesday.insertion"), "tuesday");
  EXPECT_EQ(displayNameOf("s/20261122T014506Z.insertion"), "20261122T014506Z");
}

TEST(NameOfARecording, StatesWhenAnAutomaticOneBegan)
{
  EXPECT_EQ(startedUtcOf("s/20261122T014506Z-P-017.insertion"), "2026-11-22T01:45:06Z");
  EXPECT_EQ(startedUtcOf("s/tuesday.insertion"), "");
  EXPECT_EQ(startedUtcOf("s/20261122T014506Z.insertion"), "");
}

TEST_F(Library, ListsTheTechnique)
{
  record(folder_ / "one.insertion", "2026-01-01T00:00:00Z", hillOfForce());
  for (int i = 0; i < 2; ++i) {  // from the recording, then from the index
    const auto sessions = list();
    ASSERT_EQ(sessions.size(), 1u);
    EXPECT_EQ(sessions[0].technique, "standard");
  }
}

TEST_F(Library, WithoutRecordingsIsEmpty)
{
  const auto listed = listSessions(folder_ / "none");
  ASSERT_TRUE(listed);
  EXPECT_THAT(*listed, IsEmpty());
}

TEST_F(Library, ListsPatientArrayAndPeakForceNewestFirst)
{
  record(folder_ / "a.insertion", "2010-05-17T09:30:00Z", hillOfForce());
  record(folder_ / "b.insertion", "2010-05-18T09:30:00Z", hillOfForce());
  const auto sessions = list();
  ASSERT_EQ(sessions.size(), 2u);
  EXPECT_EQ(sessions[0].file.filename(), "b.insertion");
  const SessionSummary& one = sessions[1];
  EXPECT_EQ(one.patient, "014");
  EXPECT_EQ(one.side, "left");
  EXPECT_EQ(one.array, "Nucleus 24 Contour");
  EXPECT_THAT(one.error, IsEmpty());
  // the peak at 3 mm, after 3 s
  EXPECT_DOUBLE_EQ(one.highlights.peakForce, 0.1);
  EXPECT_NEAR(one.highlights.peakTravel, 3e-3, 1e-9);
  EXPECT_NEAR(one.highlights.peakDepth, 5e-3, 1e-9);
  EXPECT_DOUBLE_EQ(one.highlights.duration, 3.0);
  EXPECT_NEAR(one.highlights.deepest, 8e-3, 1e-9);
  EXPECT_DOUBLE_EQ(one.highlights.deepestAngle, 3.0);
}

TEST_F(Library, ReadsNoTickOfAClosedRecording)
{
  runSql(record(folder_ / "a.insertion", "2010-05-17T09:30:00Z", hillOfForce()),
         "DELETE FROM block");
  EXPECT_DOUBLE_EQ(list().at(0).highlights.peakForce, 0.1);
}

TEST_F(Library, FindsTheNumbersOfOlderRecordingsAmongTheirTicks)
{
  const fs::path file = record(folder_ / "a.insertion", "2010-05-17T09:30:00Z", hillOfForce());
  const Highlights noted = list().at(0).highlights;
  runSql(file, "DELETE FROM meta WHERE key LIKE 'peak%'");
  EXPECT_EQ(list().at(0).highlights, noted);
}

TEST_F(Library, DoesNotOpenWhatHasNotChanged)
{
  const fs::path file = record(folder_ / "a.insertion", "2010-05-17T09:30:00Z", hillOfForce());
  list();
  renameInIndex("014", "index");
  EXPECT_EQ(list().at(0).patient, "index");
  runSql(file, "UPDATE meta SET value = 'elsewhere' WHERE key = 'scenario_name'");
  fs::last_write_time(file, fs::last_write_time(file) + std::chrono::seconds(1));
  EXPECT_EQ(list().at(0).patient, "014");
}

TEST_F(Library, RebuildsADamagedIndex)
{
  record(folder_ / "a.insertion", "2010-05-17T09:30:00Z", hillOfForce());
  list();
  std::ofstream(libraryCache(folder_.path()) / "index.json") << std::string(5000, 'x');
  EXPECT_EQ(list().at(0).patient, "014");
  renameInIndex("014", "index");
  EXPECT_EQ(list().at(0).patient, "index");
}

TEST_F(Library, ListsWhatCannotBeReadWithASentence)
{
  std::ofstream(folder_ / "letter.insertion") << "Dear colleague,";
  const fs::path cut = record(folder_ / "cut.insertion", "2010-05-17T09:30:00Z", hillOfForce());
  fs::resize_file(cut, fs::file_size(cut) / 2);
  const auto sessions = list();
  ASSERT_EQ(sessions.size(), 2u);
  for (const SessionSummary& one : sessions)
    EXPECT_THAT(one.error, testing::EndsWith(".")) << one.file;
  EXPECT_THAT(sessions[0].error + sessions[1].error, HasSubstr("cut short"));
}

TEST_F(Library, ListsARecordingThatNeedsTooMuchMemoryWithASentence)
{
  record(folder_ / "good.insertion", "2026-01-01T00:00:00Z", hillOfForce());
  const fs::path large = folder_ / "large.insertion";
  record(large, "2026-01-02T00:00:00Z", hillOfForce());
  runSql(large, "UPDATE meta SET value = printf('%.*c', 8000000, 'x') WHERE key = 'device'");
  const test::AllocationLimit memory(4'000'000);
  const auto sessions = list();
  ASSERT_EQ(sessions.size(), 2u);
  for (const SessionSummary& each : sessions) EXPECT_EQ(each.error.empty(), each.file != large);
}

TEST_F(Library, GivesEachRecordingBeforeItReadsTheNext)
{
  record(folder_ / "one.insertion", "2026-01-01T00:00:00Z", hillOfForce());
  record(folder_ / "two.insertion", "2026-01-02T00:00:00Z", hillOfForce());
  std::vector<fs::path> given;
  std::stop_source stop;
  const auto stopAfterOne = [&](const SessionSummary& one) {
    given.push_back(one.file);
    stop.request_stop();
  };
  ASSERT_TRUE(listSessions(folder_.path(), {}, {}, stopAfterOne, stop.get_token()));
  EXPECT_THAT(given, testing::ElementsAre(folder_ / "two.insertion"));
}

TEST_F(Library, ListsAnInsertionThatNeverRan)
{
  record(folder_ / "a.insertion", "2010-05-17T09:30:00Z", {});
  EXPECT_THAT(list().at(0).error, HasSubstr("before the insertion began"));
  EXPECT_FALSE(isInsertion(list().at(0)));
}

TEST_F(Library, TakesOnlyWhatMovedTheArrayForAnInsertion)
{
  std::vector<haptics::TickRecord> armed = hillOfForce();
  for (haptics::TickRecord& each : armed) each.output.workflow = haptics::Workflow::armed;
  record(folder_ / "armed.insertion", "2010-05-17T09:30:00Z", armed);
  record(folder_ / "moved.insertion", "2010-05-18T09:30:00Z", hillOfForce());
  for (int i = 0; i < 2; ++i) {  // from the recordings, then from the index
    const auto sessions = list();
    ASSERT_EQ(sessions.size(), 2u);
    EXPECT_TRUE(isInsertion(sessions[0]));
    EXPECT_FALSE(isInsertion(sessions[1]));
    EXPECT_GT(sessions[1].highlights.ticks, 0u);
    EXPECT_THAT(sessions[1].error, HasSubstr("delete it"));
  }
}

TEST_F(Library, LeavesTheFileAloneThatIsBeingRecorded)
{
  std::ofstream(folder_ / "now.insertion") << "half a page";
  const auto sessions = listSessions(folder_.path(), folder_ / "now.insertion");
  ASSERT_TRUE(sessions);
  EXPECT_TRUE(sessions->at(0).isBeingRecorded);
  EXPECT_THAT(sessions->at(0).error, IsEmpty());
}

TEST_F(Library, StopsWhenCanceledAndListsTheNewestRead)
{
  for (const char* day : {"20100517", "20100518", "20100519"})
    record(folder_ / (std::string(day) + "T093000Z.insertion"), "2010-05-17T09:30:00Z",
           hillOfForce());
  std::size_t all = 0;
  std::stop_source stop;
  const auto afterTwo = [&](std::size_t done, std::size_t ofAll) {
    all = ofAll;
    if (done == 2) stop.request_stop();
  };
  const auto stopped = listSessions(folder_.path(), {}, afterTwo, {}, stop.get_token());
  ASSERT_TRUE(stopped);
  EXPECT_EQ(all, 3u);
  ASSERT_EQ(stopped->size(), 2u);
  EXPECT_THAT(stopped->at(0).file.string(), HasSubstr("20100519"));
  EXPECT_THAT(stopped->at(1).file.string(), HasSubstr("20100518"));
  EXPECT_EQ(list().size(), 3u);
}

TEST_F(Library, RestoresADeletedRecording)
{
  const fs::path file = record(folder_ / "a.insertion", "2010-05-17T09:30:00Z", hillOfForce());
  const auto trashed = trashSession(file);
  ASSERT_TRUE(trashed) << trashed.error().message;
  EXPECT_THAT(list(), IsEmpty());
  ASSERT_TRUE(restoreSession(*trashed, file));
  EXPECT_EQ(list().size(), 1u);
  EXPECT_TRUE(RecordedInsertion::open(file));
}

TEST_F(Library, DeletesTwoRecordingsOfOneName)
{
  const fs::path file = folder_ / "a.insertion";
  for (int i = 0; i < 2; ++i)
    EXPECT_TRUE(trashSession(record(file, "2010-05-17T09:30:00Z", hillOfForce())));
  EXPECT_TRUE(fs::exists(folder_ / ".trash/a.insertion"));
  EXPECT_TRUE(fs::exists(folder_ / ".trash/a-2.insertion"));
}

TEST_F(Library, RenamesButNeverOverAnotherRecording)
{
  const fs::path file = record(folder_ / "a.insertion", "2010-05-17T09:30:00Z", hillOfForce());
  record(folder_ / "b.insertion", "2010-05-17T09:30:00Z", hillOfForce());
  const auto taken = renameSession(file, "b");
  ASSERT_FALSE(taken);
  EXPECT_THAT(taken.error().message, HasSubstr("exists already"));
  const auto renamed = renameSession(file, "first try");
  ASSERT_TRUE(renamed);
  EXPECT_TRUE(fs::exists(folder_ / "first try.insertion"));
  EXPECT_FALSE(fs::exists(file));
}

TEST_F(Library, RefusesInvalidNames)
{
  const fs::path file = record(folder_ / "a.insertion", "2010-05-17T09:30:00Z", hillOfForce());
  for (const char* name : {"", "../a", ".hidden", "two\nlines"}) {
    const auto renamed = renameSession(file, name);
    ASSERT_FALSE(renamed) << name;
    EXPECT_THAT(renamed.error().message, HasSubstr("is not a valid recording name")) << name;
  }
}

}  // namespace
}  // namespace perilymph::session
