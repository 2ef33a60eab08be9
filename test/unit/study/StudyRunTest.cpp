// SPDX-License-Identifier: BSD-3-Clause

// Shards, their merge, and the same bytes for every division.

#include "perilymph/study/StudyRun.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <sstream>
#include <stop_token>

#include "perilymph/database/Database.h"
#include "perilymph/foundation/AtomicFile.h"
#include "perilymph/study/StudyFile.h"
#include "perilymph/test/TemporaryFolder.h"

namespace perilymph::study {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

/// Coarse: short insertions with few nodes and long steps.
Study shortStudy(const std::string& more = "", int cochleae = 2)
{
  const auto study = parseStudy(R"(
title = "Short"
scenario = "mean-flex28"
depth = "scenario"
samples = 2
[cochleae]
mean = true
virtual = )" + std::to_string(cochleae) +
                                    R"(
[vary]
nodes = [30]
dt_ms = [5.0]
stop_travel_mm = [2.0, 3.0]
[ranges]
speed_mm_s = [3.0, 5.0]
[results]
contacts = true
profile_spacing_mm = 0.5
)" + more,
                                "/study.toml");
  EXPECT_TRUE(study) << (study ? "" : study.error().message);
  return *study;
}

bool run(const Study& study, const fs::path& folder, std::size_t index, std::size_t count,
         unsigned jobs = 1)
{
  const auto done = runShard(study, shardOf(study.size(), index, count), folder, jobs, {});
  EXPECT_TRUE(done) << (done ? "" : done.error().message);
  return done && *done;
}

std::string bytesOf(const fs::path& file)
{
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream bytes;
  bytes << stream.rdbuf();
  EXPECT_TRUE(stream.good()) << file;
  return bytes.str();
}

std::string mergeErrorOf(const fs::path& folder)
{
  const auto merged = mergeShards(folder);
  return merged ? "was merged" : merged.error().message;
}

class StudyRuns : public testing::Test {
protected:
  fs::path folder(const std::string& name) const { return folder_ / name; }
  const Study study_ = shortStudy();

private:
  test::TemporaryFolder folder_;
};

TEST(Shards, CoverAStudyWithoutGapOrOverlap)
{
  for (const std::size_t cases : {1, 7, 12, 1000})
    for (const std::size_t count : {1, 3, 7, 16}) {
      std::size_t next = 0;
      for (std::size_t i = 1; i <= count; ++i) {
        const Shard shard = shardOf(cases, i, count);
        EXPECT_EQ(shard.first, next);
        EXPECT_LE(shard.end - shard.first, cases / count + 1);
        next = shard.end;
      }
      EXPECT_EQ(next, cases);
    }
}

TEST_F(StudyRuns, GiveTheSameBytesForEveryDivisionOrderAndNumberOfThreads)
{
  ASSERT_EQ(study_.size(), 12u);
  ASSERT_TRUE(run(study_, folder("one"), 1, 1));
  ASSERT_TRUE(run(study_, folder("threads"), 1, 1, 3));
  for (const std::size_t index : {3, 1, 5, 2, 4})
    ASSERT_TRUE(run(study_, folder("five"), index, 5));
  for (const char* name : {"one", "threads", "five"}) {
    const auto merged = mergeShards(folder(name));
    ASSERT_TRUE(merged) << merged.error().message;
    EXPECT_EQ(merged->end - merged->first, 12u);
  }
  for (const char* file : {mergedFile, mergedTable}) {
    const std::string one = bytesOf(folder("one") / file);
    EXPECT_GT(one.size(), 500u);
    EXPECT_TRUE(one == bytesOf(folder("threads") / file)) << file;
    EXPECT_TRUE(one == bytesOf(folder("five") / file)) << file;
  }
}

TEST_F(StudyRuns, GiveTheSameBytesWhereThreadsRunWholeCochleae)
{
  const Study study = shortStudy({}, 12);
  for (const unsigned jobs : {1u, 2u, 3u}) {
    const fs::path out = folder(std::to_string(jobs));
    ASSERT_TRUE(run(study, out, 1, 1, jobs));
    ASSERT_TRUE(mergeShards(out));
    EXPECT_TRUE(bytesOf(out / mergedFile) == bytesOf(folder("1") / mergedFile)) << jobs;
  }
}

TEST_F(StudyRuns, AreNotMergedFromShardsWithoutASeal)
{
  ASSERT_TRUE(run(study_, folder("out"), 1, 1));
  std::filesystem::path shard;
  for (const auto& entry : std::filesystem::directory_iterator(folder("out")))
    if (entry.path().extension() == ".sqlite") shard = entry.path();
  {
    auto database = database::Database::openNew(shard);
    ASSERT_TRUE(database) << database.error().message;
    ASSERT_TRUE(
        database->run("PRAGMA user_version=2; DELETE FROM meta WHERE key = 'content_sha256'; "
                      "UPDATE insertion SET peak_mN = 1"));
  }
  const auto changed = mergeShards(folder("out"));
  ASSERT_FALSE(changed);
  EXPECT_THAT(changed.error().message, testing::HasSubstr("was changed after"));
  ASSERT_TRUE(database::Database::openNew(shard)->run(
      "UPDATE meta SET value = '0.2.0+1a2b' WHERE key = 'program'"));
  const auto merged = mergeShards(folder("out"));
  ASSERT_FALSE(merged);
  EXPECT_THAT(merged.error().message, testing::HasSubstr("carries no seal"));
  EXPECT_FALSE(std::filesystem::exists(folder("out") / mergedFile));
}

TEST_F(StudyRuns, HoldWhatEachInsertionWas)
{
  ASSERT_TRUE(run(study_, folder("out"), 1, 1));
  ASSERT_TRUE(mergeShards(folder("out")));
  const auto file = StudyFile::open(folder("out") / mergedFile);
  ASSERT_TRUE(file) << file.error().message;
  std::size_t next = 0;
  const auto done = file->read([&](const StudyResult& result) -> Result<void> {
    EXPECT_EQ(result.number, next++);
    const analysis::InsertionRun& found = result.insertion;
    EXPECT_EQ(found.end, analysis::InsertionEnd::finished) << found.reason;
    // 2 mm inside at the start, then the stop travel
    const auto& settings = result.settings;
    const bool isShort =
        std::find(settings.begin(), settings.end(),
                  session::Overrides::value_type("stop_travel_mm", "2")) != settings.end();
    EXPECT_NEAR(inMillimeters(found.depth), isShort ? 4.0 : 5.0, 0.05);
    EXPECT_GT(result.a_mm, result.b_mm);
    EXPECT_GT(result.b_mm, 4.0);
    EXPECT_FALSE(found.contacts.empty());
    // every 0.5 mm behind the 2 mm of the start
    const auto passed = static_cast<std::size_t>(inMillimeters(found.depth) / 0.5);
    EXPECT_EQ(found.profile.size(), passed - 4);
    EXPECT_NEAR(inMillimeters(found.profile.front().depth), 2.5, 1e-9);
    return {};
  });
  EXPECT_TRUE(done);
  EXPECT_EQ(next, 12u);
}

TEST_F(StudyRuns, GoOnAfterTheyWereStopped)
{
  const Study longer = [] {
    auto made = parseStudy(R"(
title = "Long"
scenario = "mean-flex28"
depth = "scenario"
[cochleae]
mean = true
[vary]
nodes = [20]
dt_ms = [10.0]
stop_travel_mm = [1.0]
speed_mm_s = [5.0]
approach_tilt_deg = [0.0, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9]
approach_turn_deg = [0.0, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6]
)",
                           "/study.toml");
    return *made;
  }();
  ASSERT_EQ(longer.size(), 70u);
  const Shard whole = shardOf(longer.size(), 1, 1);
  // what is lost is a twentieth at most, in a small study as in a large one
  std::stop_source stop;
  const auto stopped = runShard(
      longer, whole, folder("stopped"), 1,
      [&stop](std::size_t done, std::size_t) {
        if (done >= 40) stop.request_stop();
      },
      stop.get_token());
  ASSERT_TRUE(stopped) << stopped.error().message;
  EXPECT_FALSE(*stopped);
  EXPECT_THAT(mergeErrorOf(folder("stopped")), HasSubstr("is not complete ("));
  const auto states = shardsIn(folder("stopped"));
  ASSERT_TRUE(states);
  EXPECT_GE(states->front().done, 40u - longer.size() / 20 - 1);
  EXPECT_LT(states->front().done, longer.size());

  ASSERT_TRUE(run(longer, folder("stopped"), 1, 1));
  ASSERT_TRUE(run(longer, folder("whole"), 1, 1));
  ASSERT_TRUE(mergeShards(folder("stopped")) && mergeShards(folder("whole")));
  EXPECT_TRUE(bytesOf(folder("stopped") / mergedFile) == bytesOf(folder("whole") / mergedFile));
}

TEST_F(StudyRuns, KeepNoInsertionOfAFileThatChangedMeanwhile)
{
  const auto patient = [](double a_mm) {
    return "a_mm = " + std::to_string(a_mm) + "\nb_mm = 6.8\n";
  };
  const fs::path measures = folder("p.toml");
  ASSERT_TRUE(writeWhole(measures, patient(9.2)));
  const auto study = parseStudy(R"(
title = "A patient"
scenario = "mean-flex28"
depth = "scenario"
[cochleae]
mean = true
patients = ["p.toml"]
[vary]
nodes = [20]
dt_ms = [10.0]
stop_travel_mm = [0.5]
)",
                                folder("s.toml"));
  ASSERT_TRUE(study) << study.error().message;
  const auto runsWhile = [&](double a_mm) {
    return runShard(*study, shardOf(2, 1, 1), folder("out"), 1, [&](std::size_t, std::size_t) {
      return static_cast<bool>(writeWhole(measures, patient(a_mm)));
    });
  };
  const auto changed = runsWhile(9.6);
  ASSERT_FALSE(changed);
  EXPECT_THAT(changed.error().message, HasSubstr("p.toml was changed while the study ran"));
  EXPECT_EQ(shardsIn(folder("out"))->front().done, 0u);
  const auto same = runsWhile(9.2);
  ASSERT_TRUE(same) << same.error().message;
  EXPECT_EQ(shardsIn(folder("out"))->front().done, 2u);
}

TEST_F(StudyRuns, AreMergedOnlyIfTheyAreWholeAndOfOneStudy)
{
  EXPECT_THAT(mergeErrorOf(folder("none")), HasSubstr("cannot be read"));
  ASSERT_TRUE(run(study_, folder("out"), 1, 3));
  ASSERT_TRUE(run(study_, folder("out"), 3, 3));
  EXPECT_THAT(mergeErrorOf(folder("out")), HasSubstr("The insertions 4 to 7 are missing"));
  ASSERT_TRUE(run(study_, folder("out"), 1, 2));
  EXPECT_THAT(mergeErrorOf(folder("out")), HasSubstr("that another shard has, too"));
  fs::remove(folder("out") / "shard-1-of-2.sqlite");

  const Study other = shortStudy("[[case]]\nforce_scale = 0.5\n");
  ASSERT_TRUE(run(other, folder("other"), 2, 3));
  fs::copy(folder("other") / "shard-2-of-3.sqlite", folder("out"));
  EXPECT_THAT(mergeErrorOf(folder("out")), HasSubstr("of another study"));
  const auto foreign = runShard(study_, shardOf(study_.size(), 2, 3), folder("out"), 1, {});
  ASSERT_FALSE(foreign);
  EXPECT_THAT(foreign.error().message, HasSubstr("belongs to another study"));

  ASSERT_TRUE(writeWhole(folder("out") / "shard-2-of-3.sqlite", "damaged"));
  EXPECT_THAT(mergeErrorOf(folder("out")), HasSubstr("shard-2-of-3.sqlite is not a study"));
  EXPECT_FALSE(fs::exists(folder("out") / mergedFile));
}

}  // namespace
}  // namespace perilymph::study
