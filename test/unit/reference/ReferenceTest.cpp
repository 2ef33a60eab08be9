// SPDX-License-Identifier: BSD-3-Clause

// The reference of the guide states every key and column that the program has, and no other.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <regex>
#include <set>
#include <sstream>

#include "InsertionsTable.h"
#include "KeyTables.h"
#include "PlanColumns.h"
#include "ReferencePage.h"
#include "StudyViews.h"
#include "SummaryColumns.h"
#include "TableColumns.h"
#include "ValidationColumns.h"
#include "perilymph/foundation/AtomicFile.h"
#include "perilymph/planning/PlannedShape.h"
#include "perilymph/session/Csv.h"
#include "perilymph/test/Places.h"

namespace perilymph {
namespace {

std::vector<std::string> namesOf(const FieldMeanings& meanings)
{
  std::vector<std::string> names;
  for (const FieldMeaning& each : meanings) names.push_back(each.name);
  return names;
}

class KeyTable : public testing::TestWithParam<test::KeyedFile (*)()> {};

TEST_P(KeyTable, HasARowForEachKeyThatTheProgramKnows)
{
  const test::KeyedFile file = GetParam()();
  EXPECT_THAT(test::knownKeys(file), testing::UnorderedElementsAreArray(namesOf(*file.meanings)));
}

// The examples have no key that is read only where it is given, unless somebody adds it there.
TEST(KeyTables, HaveARowForEachKeyThatIsReadOnlyWhereItIsGiven)
{
  std::set<std::string> known = {"by_speed", "stribeck",
                                 "spread"};  // tables of a file of frictions
  for (const auto* table :
       {test::scenarioFile().meanings, test::patientFile().meanings, test::arrayFile().meanings})
    for (const FieldMeaning& each : *table)
      for (std::size_t begin = 0; begin <= each.name.size();) {
        const std::size_t end = std::min(each.name.find('.', begin), each.name.size());
        known.insert(each.name.substr(begin, end - begin));
        begin = end + 1;
      }
  const std::filesystem::path modules = test::projectFolder() / "modules";
  std::vector<std::filesystem::path> files = {modules / "anatomy/src/patient/Patient.cpp",
                                              modules / "electrode/src/ArrayText.cpp"};
  for (const auto& file : std::filesystem::directory_iterator(modules / "session/src/scenario"))
    files.push_back(file.path());
  const std::regex given(R"re((?:\bhas\(|Key = )"(\w+)")re");
  int found = 0;
  for (const auto& file : files) {
    const auto text = readWhole(file);
    ASSERT_TRUE(text) << text.error().message;
    for (std::sregex_iterator match(text->begin(), text->end(), given), end; match != end;
         ++match) {
      EXPECT_TRUE(known.contains((*match)[1])) << (*match)[1] << " in " << file;
      ++found;
    }
  }
  EXPECT_GT(found, 30);
}

INSTANTIATE_TEST_SUITE_P(OfEachFile, KeyTable,
                         testing::Values(&test::scenarioFile, &test::patientFile,
                                         &test::arrayFile));

TEST(Columns, HaveNamesOfTheirOwnAndMeanings)
{
  for (const FieldMeanings* columns : {&session::tickColumns(),
                                       &analysis::sectionMeanings(),
                                       &analysis::comparisonColumns(),
                                       &analysis::curveColumns(),
                                       &analysis::eventColumns(),
                                       &analysis::groupColumns(),
                                       &analysis::differenceColumns(),
                                       &planning::planArrayColumns(),
                                       &planning::planDifferenceColumns(),
                                       &planning::shapeColumns(),
                                       &study::summaryGroupColumns(),
                                       &study::summaryDifferenceColumns(),
                                       &study::summaryTrendColumns(),
                                       &validation::forceColumns(),
                                       &validation::priorSummaryColumns(),
                                       &validation::priorColumns(),
                                       &validation::benchFrictionColumns(),
                                       &validation::benchPredictedColumns(),
                                       &validation::benchScoreColumns(),
                                       &validation::predictionColumns(),
                                       &validation::clinicalRowColumns(),
                                       &validation::clinicalInsertionColumns()}) {
    std::set<std::string> names;
    for (const FieldMeaning& each : *columns) {
      EXPECT_TRUE(names.insert(each.name).second) << each.name;
      EXPECT_FALSE(each.meaning.empty()) << each.name;
    }
  }
}

TEST(Columns, OfTheTimeSeriesAreThoseOfItsFile)
{
  EXPECT_EQ(headerOf(session::tickColumns()) + "\n", session::csvHeader());
}

TEST(Columns, OfTheInsertionsOfAStudyAreExplainedByItsDictionary)
{
  std::string header = study::insertionsHeader({});
  header.pop_back();
  std::vector<std::string> known, found;
  for (const study::ColumnMeaning& each : study::studyColumnMeanings())
    if (std::string(each.table) == "insertion" && std::string(each.column) != "settings")
      known.emplace_back(each.column);
  for (std::size_t begin = 0; begin < header.size();) {
    const std::size_t end = std::min(header.find(',', begin), header.size());
    found.push_back(header.substr(begin, end - begin));
    begin = end + 1;
  }
  EXPECT_THAT(found, testing::UnorderedElementsAreArray(known));
}

// PERILYMPH_WRITE_REFERENCE names the file to write, see resources/guide/make-reference.
TEST(Reference, IsThePageThatTheProgramWrites)
{
  const std::string page = test::referencePage();
  if (const char* file = std::getenv("PERILYMPH_WRITE_REFERENCE")) {
    ASSERT_TRUE(writeWhole(file, page, {Links::refused}));
  }
  const auto stored = readWhole(test::projectFolder() / "resources/guide/reference.md");
  ASSERT_TRUE(stored) << stored.error().message;
  std::istringstream fresh(page), old(*stored);
  std::string line, other;
  for (int number = 1; std::getline(fresh, line); ++number) {
    std::getline(old, other);
    ASSERT_EQ(other, line) << "line " << number
                           << "; resources/guide/make-reference writes the page again";
  }
  EXPECT_EQ(*stored, page);
}

}  // namespace
}  // namespace perilymph
