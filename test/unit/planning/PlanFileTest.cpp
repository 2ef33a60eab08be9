// SPDX-License-Identifier: BSD-3-Clause
#include "PlanFile.h"

#include <gtest/gtest.h>

#include <fstream>

#include "perilymph/test/SyntheticPlan.h"
#include "perilymph/test/TemporaryFolder.h"

namespace perilymph::test {
namespace {

namespace fs = std::filesystem;
using planning::insertionsIn;
using planning::planKind;
using planning::rowsOf;
using session::InsertionTable;

Result<InsertionTable> continued(const fs::path& file, const std::string& fingerprint)
{
  return InsertionTable::openToContinue(file, planKind(), planning::planFacts(fingerprint));
}

/// A file with draws, closed.
void write(const fs::path& file, const std::vector<planning::PlannedInsertion>& insertions)
{
  auto made = continued(file, "one");
  ASSERT_TRUE(made) << made.error().message;
  ASSERT_TRUE(made->append(rowsOf(insertions)));
  ASSERT_TRUE(made->close());
}

/// Runs statements on a file as another program does.
void runSql(const fs::path& file, const std::string& sql)
{
  auto database = database::Database::openNew(file);
  ASSERT_TRUE(database) << database.error().message;
  const auto done = database->run(sql);
  ASSERT_TRUE(done) << done.error().message;
}

TEST(PlanFile, KeepsEveryBit)
{
  const TemporaryFolder folder;
  auto insertions = syntheticInsertions(3);
  insertions[1].stiffness = 1.0 / 3.0;
  insertions[1].insertion.peak = newtons(0.1 + 0.2);
  insertions[2].insertion.reason = "\"quoted\", and a line\nmore";
  write(folder / "draws.sqlite", insertions);
  const auto file = continued(folder / "draws.sqlite", "one");
  ASSERT_TRUE(file) << file.error().message;
  EXPECT_EQ(file->seal(), Seal::intact);
  EXPECT_EQ(file->size(), insertions.size());
  const auto found = insertionsIn(*file);
  ASSERT_TRUE(found) << found.error().message;
  ASSERT_EQ(found->size(), insertions.size());
  for (std::size_t i = 0; i < insertions.size(); ++i)
    EXPECT_EQ(contentOf((*found)[i]), contentOf(insertions[i])) << i;
  EXPECT_EQ((*found)[1].stiffness, 1.0 / 3.0);
  EXPECT_EQ((*found)[1].insertion.peak.si(), 0.1 + 0.2);
  EXPECT_EQ((*found)[2].insertion.reason, insertions[2].insertion.reason);
}

TEST(PlanFile, KeepsForcesAtRestAndReadsInsertionsWithoutThem)
{
  auto insertion = syntheticInsertions(1).front();
  insertion.insertion.forceAfter10s = newtons(-0.003);
  const auto kept = planning::insertionIn(contentOf(insertion));
  ASSERT_TRUE(kept) << kept.error().message;
  EXPECT_EQ(kept->insertion.forceAfter1s, insertion.insertion.forceAfter1s);
  EXPECT_EQ(kept->insertion.forceAfter10s, insertion.insertion.forceAfter10s);
  insertion.insertion.forceAfter1s.reset();
  insertion.insertion.forceAfter10s.reset();
  const std::string former = contentOf(insertion);
  EXPECT_EQ(former.find("after"), std::string::npos);
  ASSERT_TRUE(planning::insertionIn(former));
  EXPECT_FALSE(planning::insertionIn(former)->insertion.forceAfter1s);
  insertion.insertion.forceAfter10s = newtons(1e9);
  EXPECT_FALSE(planning::insertionIn(contentOf(insertion)));
}

TEST(PlanFile, OfAnotherPlanIsRefused)
{
  const TemporaryFolder folder;
  ASSERT_TRUE(continued(folder / "draws.sqlite", "one"));
  const auto other = continued(folder / "draws.sqlite", "two");
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
  write(folder / "draws.sqlite", insertions);
  const auto file = InsertionTable::open(folder / "draws.sqlite", planKind());
  ASSERT_TRUE(file) << file.error().message;
  const auto found = insertionsIn(*file);
  ASSERT_FALSE(found);
  EXPECT_NE(found.error().message.find("not consecutive"), std::string::npos)
      << found.error().message;
}

TEST(PlanFile, ThatIsNoneIsRefusedAndLeftAlone)
{
  const TemporaryFolder folder;
  const auto place = folder.path() / "draws.sqlite";
  std::ofstream(place) << "not a database";
  EXPECT_FALSE(continued(place, "one"));
  std::ifstream stream(place);
  EXPECT_EQ(std::string(std::istreambuf_iterator<char>(stream), {}), "not a database");
}

TEST(PlanFile, ThatWasChangedIsViewedAndNotContinued)
{
  const TemporaryFolder folder;
  const auto file = folder / "draws.sqlite";
  const std::string changes[] = {
      "UPDATE insertion SET content = replace(content, '\"stiffness\":1.0', '\"stiffness\":1.1')",
      "DELETE FROM insertion WHERE draw = 3",
      "UPDATE meta SET value = 'two' WHERE key = 'program'",
      "DELETE FROM meta WHERE key = 'content_sha256'",
      "PRAGMA user_version=2",
      "PRAGMA user_version=2; DELETE FROM meta WHERE key = 'content_sha256'"};
  for (const std::string& change : changes) {
    fs::remove(file);
    write(file, syntheticInsertions(3));
    EXPECT_TRUE(continued(file, "one"));
    runSql(file, change);
    const auto viewed = InsertionTable::open(file, planKind());
    ASSERT_TRUE(viewed) << change << ": " << viewed.error().message;
    EXPECT_EQ(viewed->seal(), Seal::changed) << change;
    EXPECT_FALSE(continued(file, "one")) << change;
  }
  fs::remove(file);
  write(file, syntheticInsertions(3));
  runSql(file, changes[0]);
  EXPECT_EQ(continued(file, "one").error().message,
            file.string() +
                " was changed after the program wrote it, so its results are not "
                "continued. Delete it or give another folder.");
}

TEST(PlanFile, OfAnEarlierVersionCarriesNoSeal)
{
  const TemporaryFolder folder;
  const auto file = folder / "draws.sqlite";
  write(file, syntheticInsertions(3));
  runSql(file,
         "PRAGMA user_version=2; DELETE FROM meta WHERE key = 'content_sha256'; UPDATE meta SET "
         "value = '0.2.0+1a2b' WHERE key = 'program'");
  const auto viewed = InsertionTable::open(file, planKind());
  ASSERT_TRUE(viewed) << viewed.error().message;
  EXPECT_EQ(viewed->seal(), Seal::absent);
  EXPECT_EQ(insertionsIn(*viewed)->size(), 6u);
  EXPECT_NE(continued(file, "one").error().message.find("carries no seal"), std::string::npos);
}

TEST(PlanFile, TakesOneWriterAtATime)
{
  const TemporaryFolder folder;
  const auto first = continued(folder / "draws.sqlite", "one");
  ASSERT_TRUE(first) << first.error().message;
  const auto second = continued(folder / "draws.sqlite", "one");
  ASSERT_FALSE(second);
  EXPECT_NE(second.error().message.find("another program works on it"), std::string::npos)
      << second.error().message;
}

TEST(RowOfAPlan, OutOfWhatIsPossibleIsRefusedByItsName)
{
  const std::string whole = contentOf(syntheticInsertions(1).front());
  const std::tuple<const char*, const char*, const char*> changes[] = {
      {"\"peak\":0.001", "\"peak\":-5.0", "the peak force is -5000 mN; 0 to 2000"},
      {"\"peak\":0.001", "\"peak\":2.5", "the peak force is 2500 mN"},
      {"\"apical\":", "\"apical\":9", "the angle is"},
      {"\"a_mm\":9.", "\"a_mm\":99.", "a_mm is 99.001"},
      {"\"partition\":0.001", "\"partition\":-0.001", "the force on the partition"},
      {"\"depth\":0.02", "\"depth\":2.0", "the depth is 2000 mm"},
      {"\"end\":\"finished\"", "\"end\":\"finishes\"", "its end has no known name"},
      {"\"profile_force\":[0.001", "\"profile_force\":[1e9", "a force is"}};
  for (const auto& [part, other, reason] : changes) {
    std::string text = whole;
    ASSERT_NE(text.find(part), std::string::npos) << part << " in " << text;
    text.replace(text.find(part), std::string(part).size(), other);
    const auto read = planning::insertionIn(text);
    ASSERT_FALSE(read) << other;
    EXPECT_NE(read.error().message.find(reason), std::string::npos) << read.error().message;
  }
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
  planned.packing = 0.5;
  planned.lastContact_mm = 0.9;
  std::string text = contentOf(planned);
  const auto now = planning::insertionIn(text);
  ASSERT_TRUE(now);
  EXPECT_EQ(now->sectionSecond, 1.125);
  EXPECT_EQ(now->dip_mm, 0.25);
  EXPECT_EQ(now->packing, 0.5);
  EXPECT_EQ(now->lastContact_mm, 0.9);
  for (const char* key :
       {"section_second", "dip_mm", "radius", "height", "packing", "last_contact_mm"})
    text.replace(text.find(std::string("\"") + key + "\""), 2, "\"x");
  const auto former = planning::insertionIn(text);
  ASSERT_TRUE(former);
  EXPECT_EQ(former->sectionSecond, 0.875);
  EXPECT_EQ(former->dip_mm, 0.0);
  EXPECT_EQ(former->height, 1.0);
  EXPECT_EQ(former->packing, 0.0);
  EXPECT_EQ(former->lastContact_mm, 0.0);
}

}  // namespace
}  // namespace perilymph::test
