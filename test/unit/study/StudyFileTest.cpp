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
  const auto done = file.read([&](const StudyResult& result) -> Result<Done> {
    found.push_back(result);
    return Done{};
  });
  EXPECT_TRUE(done);
  return found;
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
    auto file = StudyFile::create(file_, facts());
    ASSERT_TRUE(file) << file.error().message;
    ASSERT_TRUE(file->append({resultOf(3), resultOf(4)}));
    ASSERT_TRUE(file->close());
  }
  const auto file = StudyFile::open(file_);
  ASSERT_TRUE(file) << file.error().message;
  EXPECT_EQ(file->facts().title, "Two arrays");
  EXPECT_EQ(file->facts().end, 7u);
  EXPECT_EQ(*file->size(), 2u);
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

TEST_F(StudyFiles, AreContinuedWhereTheyEnded)
{
  {
    auto file = StudyFile::create(file_, facts());
    ASSERT_TRUE(file);
    ASSERT_TRUE(file->append({resultOf(3)}));
  }  // not closed
  auto file = StudyFile::resume(file_);
  ASSERT_TRUE(file) << file.error().message;
  EXPECT_EQ(*file->size(), 1u);
  ASSERT_TRUE(file->append({resultOf(4)}));
  EXPECT_EQ(*file->size(), 2u);
}

TEST_F(StudyFiles, TakeOneWriterAtATime)
{
  auto first = StudyFile::create(file_, facts());
  ASSERT_TRUE(first);
  const auto second = StudyFile::resume(file_);
  ASSERT_FALSE(second);
  EXPECT_THAT(second.error().message, HasSubstr("another process"));
}

TEST_F(StudyFiles, KeepAllOrNothingOfABlock)
{
  auto file = StudyFile::create(file_, facts());
  ASSERT_TRUE(file);
  const auto done = file->append({resultOf(3), resultOf(4), resultOf(4)});
  ASSERT_FALSE(done);
  EXPECT_EQ(*file->size(), 0u);
}

TEST_F(StudyFiles, AreRefusedWithAGapADamageOrAsSomethingElse)
{
  {
    auto file = StudyFile::create(file_, facts());
    ASSERT_TRUE(file);
    ASSERT_TRUE(file->append({resultOf(3), resultOf(5)}));
    ASSERT_TRUE(file->close());
  }
  const auto gap = StudyFile::open(file_)->size();
  ASSERT_FALSE(gap);
  EXPECT_THAT(gap.error().message, HasSubstr("not consecutive"));

  std::filesystem::resize_file(file_, std::filesystem::file_size(file_) / 2);
  EXPECT_THAT(StudyFile::open(file_).error().message, HasSubstr("damaged"));
  ASSERT_TRUE(writeWhole(file_, "a text"));
  EXPECT_THAT(StudyFile::open(file_).error().message, HasSubstr("is not a study of Perilymph"));
  EXPECT_THAT(StudyFile::create(file_, facts()).error().message, HasSubstr("there is one already"));
}

}  // namespace
}  // namespace perilymph::study
