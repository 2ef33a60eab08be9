// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/foundation/FileIdentity.h"

#include <gtest/gtest.h>

#include <fstream>

#include "perilymph/test/TemporaryFolder.h"

namespace perilymph {
namespace {

namespace fs = std::filesystem;

bool areSame(const fs::path& one, const fs::path& other)
{
  return isSameFile(identityOf(one), identityOf(other));
}

class TwoNames : public testing::Test {
protected:
  TwoNames()
  {
    std::ofstream(folder / "file") << "x";
    std::ofstream(folder / "other") << "x";
    fs::create_directory(folder / "deep");
  }
  const test::TemporaryFolder folder;
};

TEST_F(TwoNames, OfOneFileAreTheSameHoweverTheyAreSpelled)
{
  EXPECT_TRUE(areSame(folder / "file", folder / "deep/../file"));
  EXPECT_TRUE(areSame(folder / "file", folder / "./file"));
  EXPECT_TRUE(areSame("no-such-file", "./no-such-file"));
  EXPECT_FALSE(areSame(folder / "file", folder / "other"));
}

TEST_F(TwoNames, OfWhichOneIsALinkAreTheSame)
{
  fs::create_symlink(folder / "file", folder / "symbolic");
  fs::create_hard_link(folder / "file", folder / "hard");
  fs::create_directory_symlink("deep", folder / "flat");
  EXPECT_TRUE(areSame(folder / "file", folder / "symbolic"));
  EXPECT_TRUE(areSame(folder / "file", folder / "hard"));
  EXPECT_TRUE(areSame(folder / "symbolic", folder / "hard"));
  EXPECT_TRUE(areSame(folder / "deep/new", folder / "flat/new"));
}

TEST_F(TwoNames, OfAFileThatIsNotThereYetAreTheSameThroughALink)
{
  fs::create_symlink("new", folder / "link");
  fs::create_symlink("deep/new", folder / "deeper");
  EXPECT_TRUE(areSame(folder / "link", folder / "new"));
  EXPECT_TRUE(areSame(folder / "deeper", folder / "deep/new"));
  EXPECT_FALSE(areSame(folder / "link", folder / "deeper"));
}

TEST_F(TwoNames, OfLinksInACircleAreResolvedInFiniteTime)
{
  fs::create_symlink("b", folder / "a");
  fs::create_symlink("a", folder / "b");
  EXPECT_FALSE(areSame(folder / "a", folder / "file"));
}

}  // namespace
}  // namespace perilymph
