// SPDX-License-Identifier: BSD-3-Clause

// A library's cache with malicious content.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "perilymph/session/SessionLibrary.h"
#include "perilymph/test/ForgedJournal.h"
#include "perilymph/test/OddRecords.h"
#include "perilymph/test/TemporaryFolder.h"

namespace perilymph::session {
namespace {

namespace fs = std::filesystem;

std::string contentOf(const fs::path& place)
{
  std::ifstream stream(place, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

class ForgedCache : public testing::Test {
protected:
  ForgedCache()
  {
    fs::create_directories(sessions);
    std::ofstream(treasure) << "what nobody may lose\n";
    auto recording = Recording::create(sessions / "some.insertion", test::someFacts());
    EXPECT_TRUE(recording);
    EXPECT_TRUE((*recording)->append(test::quietRecords(0, 20)));
    EXPECT_TRUE((*recording)->close());
  }

  void expectListed() const
  {
    const auto listed = listSessions(sessions);
    ASSERT_TRUE(listed) << listed.error().message;
    ASSERT_EQ(listed->size(), 1u);
    EXPECT_EQ(listed->front().highlights.ticks, 20u);
  }

  const test::TemporaryFolder folder;
  const fs::path sessions = folder / "sessions", cache = sessions / ".cache",
                 treasure = folder / "treasure.txt";
};

TEST_F(ForgedCache, WithAJournalThatNamesAFileDoesNotDeleteThatFile)
{
  expectListed();
  for (const std::string index : {"index.sqlite", "index.json"}) {
    if (!fs::exists(cache / index)) std::ofstream(cache / index) << "x";
    test::forgeJournal(cache / index, treasure);
  }
  expectListed();
  EXPECT_EQ(contentOf(treasure), "what nobody may lose\n");
}

TEST_F(ForgedCache, ThatIsALinkIsLeftAlone)
{
  const fs::path elsewhere = folder / "elsewhere";
  fs::create_directory(elsewhere);
  std::ofstream(elsewhere / "index.json") << "somebody's own";
  std::ofstream(elsewhere / "index.sqlite") << "somebody's own";
  fs::create_directory_symlink(elsewhere, cache);
  expectListed();
  EXPECT_EQ(contentOf(elsewhere / "index.json"), "somebody's own");
  EXPECT_EQ(contentOf(elsewhere / "index.sqlite"), "somebody's own");
  EXPECT_TRUE(fs::is_symlink(cache));
}

TEST_F(ForgedCache, WhoseIndexIsALinkIsNotFollowed)
{
  fs::create_directory(cache);
  fs::create_symlink(treasure, cache / "index.json");
  expectListed();
  EXPECT_EQ(contentOf(treasure), "what nobody may lose\n");
}

TEST_F(ForgedCache, WithATrashThatIsALinkThrowsNothingAway)
{
  fs::create_directory(folder / "elsewhere");
  fs::create_directory_symlink(folder / "elsewhere", sessions / ".trash");
  const auto thrown = trashSession(sessions / "some.insertion");
  ASSERT_FALSE(thrown);
  EXPECT_THAT(thrown.error().message, testing::HasSubstr("Nothing was deleted"));
  EXPECT_TRUE(fs::exists(sessions / "some.insertion"));
}

TEST_F(ForgedCache, WithAnIndexOfAnyShapeOnlyHasItsRecordingsReadAgain)
{
  fs::create_directory(cache);
  for (const char* text :
       {"", "{", "[]", "{\"format\":2}", "{\"format\":2,\"sessions\":[1]}",
        "{\"format\":2,\"sessions\":{\"some.insertion\":{}}}",
        "{\"format\":2,\"sessions\":{\"some.insertion\":{\"bytes\":-1}}}", "{\"format\":99}"}) {
    std::ofstream(cache / "index.json") << text;
    expectListed();
  }
  std::ofstream(cache / "index.json") << std::string(200'000, '[');
  expectListed();
}

}  // namespace
}  // namespace perilymph::session
