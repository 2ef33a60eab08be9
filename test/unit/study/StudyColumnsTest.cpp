// SPDX-License-Identifier: BSD-3-Clause

// Results as columns, and their filter.

#include "perilymph/study/StudyColumns.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <stop_token>

#include "perilymph/test/TemporaryFolder.h"

namespace perilymph::study {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;

/// Twenty insertions: two arrays in cochleae of A = 8.0, 8.1 ... mm; the speed grows.
std::vector<StudyResult> twentyResults()
{
  std::vector<StudyResult> results(20);
  for (std::size_t i = 0; i < results.size(); ++i) {
    StudyResult& one = results[i];
    one.number = i;
    one.cochlea = "virtual " + std::to_string(i / 2 + 1);
    one.settings = {{"array", i % 2 == 0 ? "flex24" : "flex28"},
                    {"nodes", "100"},
                    {"speed_mm_s", "0." + std::to_string(i + 10)}};
    one.a_mm = 8.0 + 0.1 * static_cast<double>(i / 2);
    one.b_mm = 6.8;
    one.insertion.end = i == 5 ? analysis::InsertionEnd::buckled : analysis::InsertionEnd::finished;
    one.insertion.peak.force = millinewtons(static_cast<double>(i));
    one.insertion.apical = degrees(300.0 + static_cast<double>(i));
  }
  return results;
}

class AStudyInColumns : public testing::Test {
protected:
  fs::path write(const std::vector<StudyResult>& results)
  {
    const fs::path file = folder_ / "study.sqlite";
    StudyFileFacts facts{"Twenty", "title = 'Twenty'", "f00d", "test", results.size(),
                         0,        results.size()};
    auto created = StudyFile::openToContinue(file, facts);
    EXPECT_TRUE(created) << (created ? "" : created.error().message);
    EXPECT_TRUE(created->append(results));
    EXPECT_TRUE(created->close());
    return file;
  }
  StudyColumns columnsWith(std::vector<StudyFileValue> files)
  {
    StudyFileFacts facts;
    facts.fileValues = std::move(files);
    return {facts, twentyResults()};
  }
  StudyColumns columns()
  {
    auto read = StudyColumns::read(write(twentyResults()), {});
    if (!read) throw std::runtime_error(read.error().message);
    return *std::move(read);
  }
  static StudyFilter wanting(const StudyColumns& columns, const std::string& key,
                             const std::string& level)
  {
    StudyFilter filter;
    for (const StudyFactor& factor : columns.factors()) {
      filter.levels.emplace_back();
      if (factor.key != key) continue;
      for (const std::string& each : factor.levels) filter.levels.back().push_back(each == level);
    }
    return filter;
  }

private:
  test::TemporaryFolder folder_;
};

TEST_F(AStudyInColumns, HaveWhatTheFilesOfSettingsSay)
{
  const StudyColumns columns = columnsWith({{"array", "flex24", "array_name", "Short"},
                                            {"array", "flex28", "array_name", "Long"},
                                            {"array", "flex24", "friction_static", "0.1"},
                                            {"array", "flex28", "friction_static", "0.25"}});
  ASSERT_NE(columns.factor("array"), nullptr);
  EXPECT_THAT(columns.factor("array")->shown, ElementsAre("Short", "Long"));
  const StudyQuantity* friction = columns.quantity("friction_static");
  ASSERT_NE(friction, nullptr);
  for (std::size_t i = 0; i < columns.size(); ++i)
    EXPECT_EQ(friction->values[i], i % 2 == 0 ? 0.1 : 0.25);
  EXPECT_THAT(columns.ranges(), ElementsAre("speed_mm_s"));  // its slope would be the factor's
  EXPECT_EQ(columns.fileColumns(), (std::vector<std::string>{"array_name", "friction_static"}));
}

TEST_F(AStudyInColumns, HasEndingAndSettingsOfFewValuesAsFactors)
{
  const StudyColumns study = columns();
  ASSERT_EQ(study.factors().size(), 2u);
  EXPECT_EQ(study.factors()[0].key, "ending");
  EXPECT_THAT(study.factors()[0].levels, ElementsAre("finished", "buckled"));
  EXPECT_EQ(study.factors()[1].key, "array");  // nodes are the same, speeds too many
  EXPECT_THAT(study.factors()[1].levels, ElementsAre("flex24", "flex28"));
}

TEST_F(AStudyInColumns, HasNumbersOfInsertionsAndOfSettingsAsQuantities)
{
  const StudyColumns study = columns();
  const StudyQuantity* peak = study.quantity("peak_mN");
  ASSERT_NE(peak, nullptr);
  EXPECT_DOUBLE_EQ(peak->values[7], 7.0);
  const StudyQuantity* speed = study.quantity("speed_mm_s");
  ASSERT_NE(speed, nullptr);
  EXPECT_DOUBLE_EQ(speed->values[3], 0.13);
  EXPECT_EQ(study.quantity("nodes"), nullptr);
  EXPECT_EQ(study.quantity("array"), nullptr);
}

TEST_F(AStudyInColumns, IsFilteredByLevelAndByCochlearSize)
{
  const StudyColumns study = columns();
  EXPECT_EQ(study.rows({}).size(), 20u);
  EXPECT_THAT(study.rows(wanting(study, "ending", "buckled")), ElementsAre(5u));
  StudyFilter filter = wanting(study, "array", "flex24");
  filter.minA_mm = 8.75;
  EXPECT_THAT(study.rows(filter), ElementsAre(16u, 18u));
}

TEST_F(AStudyInColumns, HasDrawnNumbersAsQuantityOnly)
{
  auto results = twentyResults();
  results.resize(2);
  results[0].settings.back().second = "2.7583438084835765";
  results[1].settings.back().second = "2.4768641177949675";
  const auto study = StudyColumns::read(write(results), {});
  ASSERT_TRUE(study);
  for (const StudyFactor& factor : study->factors()) EXPECT_NE(factor.key, "speed_mm_s");
  EXPECT_NE(study->quantity("speed_mm_s"), nullptr);
}

TEST_F(AStudyInColumns, OfANumberThatIsMissingHasNone)
{
  auto results = twentyResults();
  results[4].settings.pop_back();
  auto study = StudyColumns::read(write(results), {});
  ASSERT_TRUE(study);
  const StudyQuantity* speed = study->quantity("speed_mm_s");
  ASSERT_NE(speed, nullptr);
  EXPECT_TRUE(std::isnan(speed->values[4]));
}

TEST_F(AStudyInColumns, RefusesAFileWithoutInsertionsAndOneOfAnotherKind)
{
  const auto empty = StudyColumns::read(write({}), {});
  ASSERT_FALSE(empty);
  EXPECT_THAT(empty.error().message, HasSubstr("has no insertions yet"));
  const auto missing = StudyColumns::read("/nowhere/study.sqlite", {});
  ASSERT_FALSE(missing);
  EXPECT_THAT(missing.error().message, HasSubstr("/nowhere/study.sqlite"));
}

}  // namespace
}  // namespace perilymph::study
