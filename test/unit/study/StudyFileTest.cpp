// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/study/StudyFile.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "perilymph/foundation/AtomicFile.h"
#include "perilymph/test/TemporaryFolder.h"

namespace perilymph::study {
namespace {

using testing::HasSubstr;

StudyFileFacts facts()
{
  return {"Two arrays", "title = \"Two arrays\"\n", "ab12", "0.1.0", 9, 3, 7};
}

StudyResult resultOf(std::size_t number)
{
  StudyResult result;
  result.number = number;
  result.cochlea = "virtual 3";
  result.settings = {{"array", "flex28"}, {"friction", "tissue, \"wet\""}};
  result.a_mm = 9.25;
  result.b_mm = 6.5;
  result.insertion.end = analysis::InsertionEnd::buckled;
  result.insertion.reason = "bowed";
  result.insertion.maxDepth = millimeters(18.25);
  result.insertion.peak = {millimeters(12.5), millinewtons(64.0)};
  result.insertion.profile = {{millimeters(1.0), millinewtons(2.0)},
                              {millimeters(2.0), millinewtons(3.5)}};
  result.insertion.contacts.resize(2);
  result.insertion.contacts[0].number = 1;
  result.insertion.contacts[1].number = 2;
  result.insertion.contacts[1].angle = degrees(45.0);
  return result;
}

std::vector<StudyResult> allIn(const StudyFile& file)
{
  std::vector<StudyResult> found;
  const auto done = file.read([&](const StudyResult& result) -> Result<void> {
    found.push_back(result);
    return {};
  });
  EXPECT_TRUE(done);
  return found;
}

/// Runs a statement on a file as another program does.
void runSql(const std::filesystem::path& file, const std::string& sql)
{
  auto database = database::Database::openNew(file);
  ASSERT_TRUE(database) << database.error().message;
  const auto done = database->run(sql);
  ASSERT_TRUE(done) << done.error().message;
}

class StudyFiles : public testing::Test {
private:
  test::TemporaryFolder folder_;

protected:
  const std::filesystem::path file_ = folder_ / "shard-1-of-2.sqlite";
};

TEST_F(StudyFiles, HoldWhatWasAdded)
{
  {
    auto file = StudyFile::openToContinue(file_, facts());
    ASSERT_TRUE(file) << file.error().message;
    ASSERT_TRUE(file->append({resultOf(3), resultOf(4)}));
    ASSERT_TRUE(file->close());
  }
  const auto file = StudyFile::open(file_);
  ASSERT_TRUE(file) << file.error().message;
  EXPECT_EQ(file->facts().title, "Two arrays");
  EXPECT_EQ(file->facts().end, 7u);
  EXPECT_EQ(file->size(), 2u);
  const auto results = allIn(*file);
  ASSERT_EQ(results.size(), 2u);
  EXPECT_EQ(results[1].number, 4u);
  EXPECT_EQ(results[1].settings, resultOf(4).settings);
  EXPECT_EQ(results[1].insertion.end, analysis::InsertionEnd::buckled);
  EXPECT_NEAR(inMillimeters(results[1].insertion.maxDepth), 18.25, 1e-12);
  EXPECT_NEAR(inMillinewtons(results[1].insertion.peak.force), 64.0, 1e-9);
  EXPECT_NEAR(inMillimeters(results[1].insertion.peak.depth), 12.5, 1e-12);
  ASSERT_EQ(results[1].insertion.profile.size(), 2u);
  EXPECT_NEAR(inMillimeters(results[1].insertion.profile[1].depth), 2.0, 1e-12);
  ASSERT_EQ(results[1].insertion.contacts.size(), 2u);
  EXPECT_NEAR(inDegrees(results[1].insertion.contacts[1].angle), 45.0, 1e-12);
}

TEST_F(StudyFiles, KeepWhatIsSaidOfTheirPatientsUnderTheirSeal)
{
  StudyFileFacts noted = facts();
  noted.notes = {"The measures of A were changed.", "The measures of B carry no seal."};
  {
    auto file = StudyFile::openToContinue(file_, noted);
    ASSERT_TRUE(file) << file.error().message;
    ASSERT_TRUE(file->append({resultOf(3)}));
    ASSERT_TRUE(file->close());
  }
  EXPECT_TRUE(StudyFile::openToContinue(file_, noted));
  EXPECT_EQ(StudyFile::open(file_)->facts().notes, noted.notes);
  EXPECT_EQ(StudyFile::outlineOf(file_)->first.notes, noted.notes);
  runSql(file_, "DELETE FROM meta WHERE key = 'notes'");
  EXPECT_EQ(StudyFile::open(file_)->facts().seal, Seal::changed);
}

TEST_F(StudyFiles, AreContinuedWhereTheyEnded)
{
  {
    auto file = StudyFile::openToContinue(file_, facts());
    ASSERT_TRUE(file);
    ASSERT_TRUE(file->append({resultOf(3)}));
  }  // not closed
  auto file = StudyFile::openToContinue(file_, facts());
  ASSERT_TRUE(file) << file.error().message;
  EXPECT_EQ(file->size(), 1u);
  ASSERT_TRUE(file->append({resultOf(4)}));
  EXPECT_EQ(file->size(), 2u);
}

TEST_F(StudyFiles, TakeOneWriterAtATime)
{
  auto first = StudyFile::openToContinue(file_, facts());
  ASSERT_TRUE(first);
  const auto second = StudyFile::openToContinue(file_, facts());
  ASSERT_FALSE(second);
  EXPECT_THAT(second.error().message, HasSubstr("another program works on it"));
}

TEST_F(StudyFiles, KeepAllOrNothingOfABlock)
{
  auto file = StudyFile::openToContinue(file_, facts());
  ASSERT_TRUE(file);
  const auto done = file->append({resultOf(3), resultOf(4), resultOf(4)});
  ASSERT_FALSE(done);
  EXPECT_EQ(file->size(), 0u);
}

TEST_F(StudyFiles, AreRefusedWithAGapADamageOrAsSomethingElse)
{
  {
    auto file = StudyFile::openToContinue(file_, facts());
    ASSERT_TRUE(file);
    ASSERT_TRUE(file->append({resultOf(3), resultOf(5)}));
    ASSERT_TRUE(file->close());
  }
  const auto gap =
      StudyFile::open(file_)->read([](const StudyResult&) -> Result<void> { return {}; });
  ASSERT_FALSE(gap);
  EXPECT_THAT(gap.error().message, HasSubstr("not consecutive"));

  std::filesystem::resize_file(file_, std::filesystem::file_size(file_) / 2);
  EXPECT_THAT(StudyFile::open(file_).error().message, HasSubstr("damaged"));
  ASSERT_TRUE(writeWhole(file_, "a text"));
  EXPECT_THAT(StudyFile::open(file_).error().message, HasSubstr("is not a study of Perilymph"));
  EXPECT_THAT(StudyFile::openToContinue(file_, facts()).error().message,
              HasSubstr("is not a study of Perilymph"));
}

TEST_F(StudyFiles, ThatWereChangedHaveNoNumberAndAreNotContinued)
{
  for (const char* change :
       {"UPDATE insertion SET peak_mN = 6.4 WHERE number = 3",
        "UPDATE profile SET force_mN = 3 WHERE number = 4", "DELETE FROM contact WHERE number = 4",
        "UPDATE insertion SET cochlea = 'virtual 4'",
        "UPDATE meta SET value = 'x' WHERE key = 'title'",
        "DELETE FROM meta WHERE key = 'content_sha256'", "PRAGMA user_version=2"}) {
    std::filesystem::remove(file_);
    {
      auto file = StudyFile::openToContinue(file_, facts());
      ASSERT_TRUE(file) << file.error().message;
      ASSERT_TRUE(file->append({resultOf(3), resultOf(4)}));
      ASSERT_TRUE(file->close());
    }
    EXPECT_EQ(StudyFile::open(file_)->facts().fingerprint, "ab12");
    runSql(file_, change);
    const auto file = StudyFile::open(file_);
    ASSERT_TRUE(file) << change << ": " << file.error().message;
    EXPECT_EQ(file->facts().seal, Seal::changed) << change;
    EXPECT_EQ(file->facts().fingerprint, "") << change;
    EXPECT_THAT(StudyFile::openToContinue(file_, facts()).error().message,
                HasSubstr("was changed after the program wrote it"));
  }
}

TEST_F(StudyFiles, OfAnEarlierVersionCarryNoSeal)
{
  {
    auto file = StudyFile::openToContinue(file_, facts());
    ASSERT_TRUE(file->append({resultOf(3)}));
    ASSERT_TRUE(file->close());
  }
  runSql(file_, "PRAGMA user_version=2; DELETE FROM meta WHERE key = 'content_sha256'");
  const auto file = StudyFile::open(file_);
  ASSERT_TRUE(file) << file.error().message;
  EXPECT_EQ(file->facts().seal, Seal::absent);
  EXPECT_EQ(file->facts().fingerprint, "ab12");
  EXPECT_EQ(allIn(*file).size(), 1u);
  // the same of a program that seals every study
  runSql(file_, "UPDATE meta SET value = '0.3.0-dev+1a2b' WHERE key = 'program'");
  EXPECT_EQ(StudyFile::open(file_)->facts().seal, Seal::changed);
  EXPECT_EQ(StudyFile::open(file_)->facts().fingerprint, "");
}

TEST_F(StudyFiles, WithImpossibleValuesAreRefusedByTheirNames)
{
  for (const auto& [change, reason] :
       {std::pair{"peak_mN = -5000", "the peak force is -5000 mN; 0 to 2000 is possible"},
        {"peak_mN = 2001", "the peak force"},
        {"angle_deg = 1e9", "the angle is 1"},
        {"A_mm = 99", "A is 99 mm; 5 to 13 is possible"},
        {"B_mm = 0", "B is 0 mm"},
        {"coverage_percent = -1", "the coverage"},
        {"ticks = -1", "its ticks"},
        {"ending = 'finishes'", "its ending"},
        {"settings = '[]'", "its settings"}}) {
    std::filesystem::remove(file_);
    {
      auto file = StudyFile::openToContinue(file_, facts());
      ASSERT_TRUE(file) << file.error().message;
      ASSERT_TRUE(file->append({resultOf(3)}));
      ASSERT_TRUE(file->close());
    }
    runSql(file_, std::string("UPDATE insertion SET ") + change);
    const auto read =
        StudyFile::open(file_)->read([](const StudyResult&) -> Result<void> { return {}; });
    ASSERT_FALSE(read) << change;
    EXPECT_THAT(read.error().message, HasSubstr(reason));
  }
  runSql(file_, "UPDATE insertion SET settings = '{}'; UPDATE contact SET is_inserted = 2");
  const auto read =
      StudyFile::open(file_)->read([](const StudyResult&) -> Result<void> { return {}; });
  EXPECT_THAT(read.error().message, HasSubstr("is_inserted is 2; it must be 0 or 1"));
}

TEST_F(StudyFiles, WithRowsOfNoInsertionAreRefused)
{
  {
    auto file = StudyFile::openToContinue(file_, facts());
    ASSERT_TRUE(file->append({resultOf(3)}));
    ASSERT_TRUE(file->close());
  }
  runSql(file_, "INSERT INTO profile VALUES(2, 1.0, 1.0)");
  const auto file = StudyFile::open(file_);
  ASSERT_FALSE(file);
  EXPECT_THAT(file.error().message, HasSubstr("belong to no insertion"));
}

}  // namespace
}  // namespace perilymph::study
