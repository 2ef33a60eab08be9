// SPDX-License-Identifier: BSD-3-Clause
#include "PlanFile.h"

#include <gtest/gtest.h>

#include <fstream>

#include "SyntheticPlan.h"
#include "perilymph/test/TemporaryFolder.h"

namespace perilymph::test {
namespace {

using planning::PlanFile;

TEST(PlanFile, KeepsEveryBit)
{
  const TemporaryFolder folder;
  auto insertions = syntheticInsertions(3);
  insertions[1].stiffness = 1.0 / 3.0;
  insertions[1].insertion.peak = newtons(0.1 + 0.2);
  insertions[2].insertion.reason = "\"quoted\", and a line\nmore";
  {
    auto file = PlanFile::open(folder.path() / "draws.sqlite", "one");
    ASSERT_TRUE(file) << file.error().message;
    ASSERT_TRUE(file->append(insertions));
    ASSERT_TRUE(file->close());
  }
  const auto file = PlanFile::open(folder.path() / "draws.sqlite", "one");
  ASSERT_TRUE(file) << file.error().message;
  const auto found = file->read();
  ASSERT_TRUE(found) << found.error().message;
  ASSERT_EQ(found->size(), insertions.size());
  for (std::size_t i = 0; i < insertions.size(); ++i)
    EXPECT_EQ(contentOf((*found)[i]), contentOf(insertions[i])) << i;
  EXPECT_EQ((*found)[1].stiffness, 1.0 / 3.0);
  EXPECT_EQ((*found)[1].insertion.peak.si(), 0.1 + 0.2);
  EXPECT_EQ((*found)[2].insertion.reason, insertions[2].insertion.reason);
}

TEST(PlanFile, OfAnotherPlanIsRefused)
{
  const TemporaryFolder folder;
  ASSERT_TRUE(PlanFile::open(folder.path() / "draws.sqlite", "one"));
  const auto other = PlanFile::open(folder.path() / "draws.sqlite", "two");
  ASSERT_FALSE(other);
  EXPECT_NE(other.error().message.find("belongs to another plan"), std::string::npos)
      << other.error().message;
}

TEST(PlanFile, WithValuesThatNoInsertionHasIsRefused)
{
  auto insertion = syntheticInsertions(1).front();
  EXPECT_TRUE(planning::insertionIn(contentOf(insertion)));
  insertion.insertion.profile.push_back({meters(1e300), newtons(0.0)});
  EXPECT_FALSE(planning::insertionIn(contentOf(insertion)));
  EXPECT_FALSE(planning::insertionIn(R"({"draw": 1e300, "array": -1})"));
}

TEST(PlanFile, WithoutOneDrawIsRefused)
{
  const TemporaryFolder folder;
  auto insertions = syntheticInsertions(3);
  insertions.erase(insertions.begin() + 2, insertions.begin() + 4);
  auto file = PlanFile::open(folder.path() / "draws.sqlite", "one");
  ASSERT_TRUE(file) << file.error().message;
  ASSERT_TRUE(file->append(insertions));
  const auto found = file->read();
  ASSERT_FALSE(found);
  EXPECT_NE(found.error().message.find("not consecutive"), std::string::npos)
      << found.error().message;
}

TEST(PlanFile, ThatIsNoneIsRefusedAndLeftAlone)
{
  const TemporaryFolder folder;
  const auto place = folder.path() / "draws.sqlite";
  std::ofstream(place) << "not a database";
  EXPECT_FALSE(PlanFile::open(place, "one"));
  std::ifstream stream(place);
  EXPECT_EQ(std::string(std::istreambuf_iterator<char>(stream), {}), "not a database");
}

TEST(RowOfAPlan, ThatLacksAMemberIsNone)
{
  const std::string whole = contentOf(syntheticInsertions(1).front());
  EXPECT_TRUE(planning::insertionIn(whole));
  for (const char* key : {"a_mm", "end", "contacts", "peak"}) {
    std::string text = whole;
    text.replace(text.find(std::string("\"") + key + "\""), 2, "\"x");
    EXPECT_FALSE(planning::insertionIn(text)) << key;
  }
  EXPECT_FALSE(planning::insertionIn("[]"));
  EXPECT_FALSE(planning::insertionIn(""));
}

TEST(RowOfAPlan, OfAFormerVersionHasOneFactorForAllSections)
{
  planning::PlannedInsertion planned = syntheticInsertions(1).front();
  planned.section = 0.875;
  planned.sectionSecond = 1.125;
  planned.dip_mm = 0.25;
  std::string text = contentOf(planned);
  const auto now = planning::insertionIn(text);
  ASSERT_TRUE(now);
  EXPECT_EQ(now->sectionSecond, 1.125);
  EXPECT_EQ(now->dip_mm, 0.25);
  for (const char* key : {"section_second", "dip_mm", "radius", "height"})
    text.replace(text.find(std::string("\"") + key + "\""), 2, "\"x");
  const auto former = planning::insertionIn(text);
  ASSERT_TRUE(former);
  EXPECT_EQ(former->sectionSecond, 0.875);
  EXPECT_EQ(former->dip_mm, 0.0);
  EXPECT_EQ(former->height, 1.0);
}

}  // namespace
}  // namespace perilymph::test
