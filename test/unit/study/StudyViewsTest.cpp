// SPDX-License-Identifier: BSD-3-Clause

// The views of a study's file, as any program that reads SQLite sees them.

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sqlite3.h>

#include <algorithm>
#include <cstdio>
#include <memory>

#include "StudyViews.h"
#include "perilymph/foundation/Sha256.h"
#include "perilymph/study/StudyFile.h"
#include "perilymph/study/StudySummary.h"
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

TEST_F(ViewsOfAStudy, CountEveryWayInWhichAnInsertionEnds)
{
  std::vector<StudyResult> results;
  std::string sum = "0";
  using analysis::InsertionEnd;
  for (const InsertionEnd end :
       {InsertionEnd::none, InsertionEnd::finished, InsertionEnd::stoppedByResistance,
        InsertionEnd::buckled, InsertionEnd::outOfOpening, InsertionEnd::foldedTip,
        InsertionEnd::jammed, InsertionEnd::fault, InsertionEnd::refused}) {
    StudyResult& result = results.emplace_back();
    result.number = results.size() - 1;
    result.settings = {{"array", "flex24"}};
    result.a_mm = 9.0;
    result.b_mm = 6.8;
    result.insertion.end = end;
    sum += std::string(" + ") + haptics::nameOf(end);
  }
  // a further end would be the one after the last
  const auto after = static_cast<InsertionEnd>(std::uint32_t(InsertionEnd::refused) + 1);
  EXPECT_STREQ(haptics::nameOf(after), haptics::nameOf(InsertionEnd::none));
  const test::TemporaryFolder folder;
  const fs::path file = folder / "study.sqlite";
  {
    auto created = StudyFile::openToContinue(
        file, {"Nine", "", "f00d", "test", results.size(), 0, results.size()});
    ASSERT_TRUE(created && created->append(results) && created->close());
  }
  EXPECT_THAT(rowsOf(file, ("SELECT insertions, " + sum +
                            ", stopped_by_resistance, folded_tip, "
                            "jammed FROM ending_by_setting")
                               .c_str()),
              ElementsAre("9|9|1|1|1"));
}

TEST_F(ViewsOfAStudy, HaveTheQuartilesAndMeansOfTheSummary)
{
  const auto columns = StudyColumns::read(file_, {});
  ASSERT_TRUE(columns);
  const auto summary = summaryOf(*columns, columns->rows({}), {"A_mm", "angle_deg", "array"});
  int compared = 0;
  for (const StudyGroup& group : summary.groups)
    for (const StudySelection selection : studySelections)
      for (std::size_t i = 0; i < summarizedQuantities.size(); ++i) {
        const StudySample& sample = group.samples[selection];
        const auto found = rowsOf(
            file_, ("SELECT n, round(mean, 6), round(median, 6), round(quartile25, 6), "
                    "round(quartile75, 6) FROM distribution_by_setting WHERE key = 'array' AND "
                    "value = '" +
                    group.level + "' AND selection = '" + nameOf(selection) + "' AND quantity = '" +
                    summarizedQuantities[i].key + "'")
                       .c_str());
        ASSERT_EQ(found.size(), 1u);
        double n = 0, mean = 0, median = 0, low = 0, high = 0;
        ASSERT_EQ(
            std::sscanf(found[0].c_str(), "%lf|%lf|%lf|%lf|%lf", &n, &mean, &median, &low, &high),
            5);
        EXPECT_EQ(n, static_cast<double>(sample.count));
        EXPECT_NEAR(mean, sample.means[i]->mean, 1e-6);
        EXPECT_NEAR(median, sample.quartiles[i]->value, 1e-6);
        EXPECT_NEAR(low, sample.quartiles[i]->low, 1e-6);
        EXPECT_NEAR(high, sample.quartiles[i]->high, 1e-6);
        ++compared;
      }
  EXPECT_EQ(compared, 20);
}

TEST_F(ViewsOfAStudy, OfTheVersionBeforeAreRead)
{
  ASSERT_TRUE(run(file_,
                  "DROP VIEW ending_by_setting; DROP VIEW distribution_by_setting; PRAGMA "
                  "user_version = 3"));
  // as version 3 wrote it
  ASSERT_TRUE(
      run(file_,
          "CREATE VIEW ending_by_setting AS SELECT key, value, count(*) AS insertions, "
          "sum(ending = 'finished') AS finished, sum(ending = 'out_of_opening') AS out_of_opening, "
          "sum(ending = 'buckled') AS buckled, sum(ending = 'fault') AS fault, "
          "sum(ending = 'refused') AS refused, "
          "100.0 * sum(ending = 'finished') / count(*) AS finished_percent "
          "FROM setting JOIN insertion USING (number) GROUP BY key, value"));
  const auto opened = StudyFile::open(file_);
  ASSERT_TRUE(opened) << opened.error().message;
  EXPECT_EQ(opened->size(), 4u);
}

TEST_F(ViewsOfAStudy, OfTheFirstDictionaryAreRead)
{
  // of which the dictionary explained the tables alone; the hash is of its text as that version wrote it
  const auto is = [](const std::string& view) {
    Sha256 hash;
    hash.add(view);
    return hash.hex() == "99fca30e6285e8dc5fb4fedfcca26acddd613bdac1fa21eabb348a6a9632eba8";
  };
  const auto former = formerStudyViews();
  const auto found = std::ranges::find_if(former, is);
  ASSERT_NE(found, former.end());
  ASSERT_TRUE(run(file_, ("DROP VIEW dictionary; " + *found).c_str()));
  const auto opened = StudyFile::open(file_);
  ASSERT_TRUE(opened) << opened.error().message;
}

TEST_F(ViewsOfAStudy, OfVersion4AreRead)
{
  // which said nothing of files; the hashes are of its views as that version wrote them
  int replaced = 0;
  for (const std::string& view : formerStudyViews()) {
    Sha256 hash;
    hash.add(view);
    if (hash.hex() != "40ccc3038805e134c8bb767cfa7b2683c59d125c456b9d6e07938f6d8ac55460" &&
        hash.hex() != "54f9d51b8bc019d8654d846e108b579ddfd7ec7efae4fa1137cbc43e6633631b")
      continue;
    const std::string name =
        view.substr(0, view.find(view.find('(') < view.find(" AS") ? "(" : " AS"));
    ASSERT_TRUE(
        run(file_, ("DROP VIEW " + name.substr(name.rfind(' ') + 1) + "; " + view).c_str()));
    ++replaced;
  }
  EXPECT_EQ(replaced, 2);
  ASSERT_TRUE(run(file_, "DROP VIEW file_value; PRAGMA user_version = 4"));
  const auto opened = StudyFile::open(file_);
  ASSERT_TRUE(opened) << opened.error().message;
}

TEST_F(ViewsOfAStudy, AreExplainedColumnByColumn)
{
  EXPECT_THAT(rowsOf(file_,
                     "SELECT m.name || '.' || p.name FROM sqlite_master AS m, "
                     "pragma_table_info(m.name) AS p WHERE m.type IN ('table', 'view') "
                     "ORDER BY 1"),
              testing::ElementsAreArray(rowsOf(
                  file_, "SELECT table_name || '.' || column_name FROM dictionary ORDER BY 1")));
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
  for (const char* view : {"extreme", "outcome_by_size", "outcome_by_setting",
                           "distribution_by_setting", "ending_by_setting", "setting"})
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
