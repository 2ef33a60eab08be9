// SPDX-License-Identifier: BSD-3-Clause

// The views of a study's file, as any program that reads SQLite sees them.

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sqlite3.h>

#include <memory>

#include "perilymph/study/StudyFile.h"
#include "perilymph/test/TemporaryFolder.h"

namespace perilymph::study {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;

using Connection = std::unique_ptr<sqlite3, int (*)(sqlite3*)>;

Connection connectionTo(const fs::path& file)
{
  sqlite3* opened = nullptr;
  EXPECT_EQ(sqlite3_open(file.c_str(), &opened), SQLITE_OK);
  return {opened, sqlite3_close};
}

/// The rows of a query, their columns divided by bars.
std::vector<std::string> rowsOf(const fs::path& file, const char* sql)
{
  const Connection connection = connectionTo(file);
  sqlite3_stmt* statement = nullptr;
  EXPECT_EQ(sqlite3_prepare_v2(connection.get(), sql, -1, &statement, nullptr), SQLITE_OK)
      << sqlite3_errmsg(connection.get());
  std::vector<std::string> rows;
  while (sqlite3_step(statement) == SQLITE_ROW) {
    std::string row;
    for (int i = 0; i < sqlite3_column_count(statement); ++i)
      row += (i > 0 ? "|" : "") +
             std::string(reinterpret_cast<const char*>(sqlite3_column_text(statement, i)));
    rows.push_back(row);
  }
  sqlite3_finalize(statement);
  return rows;
}

bool run(const fs::path& file, const char* sql)
{
  return sqlite3_exec(connectionTo(file).get(), sql, nullptr, nullptr, nullptr) == SQLITE_OK;
}

class ViewsOfAStudy : public testing::Test {
protected:
  /// Four insertions: flex24 finishes twice, flex28 buckles once.
  ViewsOfAStudy()
  {
    std::vector<StudyResult> results(4);
    for (std::size_t i = 0; i < results.size(); ++i) {
      results[i].number = i;
      results[i].settings = {{"array", i < 2 ? "flex24" : "flex28"}};
      results[i].a_mm = i % 2 == 0 ? 8.9 : 9.6;
      results[i].b_mm = 6.8;
      results[i].insertion.end =
          i == 3 ? analysis::InsertionEnd::buckled : analysis::InsertionEnd::finished;
      results[i].insertion.apical = degrees(300.0 + 10.0 * static_cast<double>(i));
      results[i].insertion.peak.force = millinewtons(20.0 + static_cast<double>(i));
    }
    auto created = StudyFile::openToContinue(file_, {"Four", "", "f00d", "test", 4, 0, 4});
    EXPECT_TRUE(created);
    EXPECT_TRUE(created->append(results));
    EXPECT_TRUE(created->close());
  }

private:
  const test::TemporaryFolder folder_;

protected:
  const fs::path file_ = folder_ / "study.sqlite";
};

TEST_F(ViewsOfAStudy, CountEndingsBySetting)
{
  EXPECT_THAT(rowsOf(file_,
                     "SELECT value, insertions, finished, buckled, finished_percent FROM "
                     "ending_by_setting WHERE key = 'array'"),
              ElementsAre("flex24|2|2|0|100.0", "flex28|2|1|1|50.0"));
}

TEST_F(ViewsOfAStudy, GiveOutcomesOfFinishedInsertions)
{
  EXPECT_THAT(rowsOf(file_,
                     "SELECT value, finished, round(mean_angle_deg, 3), round(max_peak_mN, 3) FROM "
                     "outcome_by_setting"),
              ElementsAre("flex24|2|305.0|21.0", "flex28|1|320.0|22.0"));
  EXPECT_THAT(rowsOf(file_,
                     "SELECT A_from_mm, insertions, finished, round(mean_angle_deg, 3) FROM "
                     "outcome_by_size"),
              ElementsAre("8.5|2|2|310.0", "9.5|2|1|310.0"));
}

TEST_F(ViewsOfAStudy, NameTheExtremeInsertions)
{
  // all have the same force on the partition
  EXPECT_THAT(rowsOf(file_, "SELECT number FROM extreme WHERE has_max_angle"), ElementsAre("3"));
  EXPECT_THAT(rowsOf(file_, "SELECT number FROM extreme WHERE has_min_finished_angle"),
              ElementsAre("0"));
  EXPECT_THAT(rowsOf(file_, "SELECT number, peak_mN FROM extreme WHERE has_max_peak"),
              ElementsAre("3|23.0"));
}

TEST_F(ViewsOfAStudy, MayBeMissingInAFileOfAnEarlierVersion)
{
  for (const char* view :
       {"extreme", "outcome_by_size", "outcome_by_setting", "ending_by_setting", "setting"})
    ASSERT_TRUE(run(file_, (std::string("DROP VIEW ") + view).c_str()));
  ASSERT_TRUE(run(file_, "PRAGMA user_version = 1"));
  const auto opened = StudyFile::open(file_);
  ASSERT_TRUE(opened) << opened.error().message;
  EXPECT_EQ(opened->size(), 4u);
}

TEST_F(ViewsOfAStudy, OfAnotherProgramAreRefused)
{
  ASSERT_TRUE(run(file_, "CREATE VIEW other AS SELECT * FROM insertion"));
  const auto opened = StudyFile::open(file_);
  ASSERT_FALSE(opened);
  EXPECT_THAT(opened.error().message, HasSubstr("it has content that a study of Perilymph"));
}

}  // namespace
}  // namespace perilymph::study
