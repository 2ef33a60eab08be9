// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/test/TemporaryFolder.h"

#include <gtest/gtest.h>

#include <fstream>

namespace perilymph::test {
namespace {

namespace fs = std::filesystem;

TEST(TemporaryFolder, IsEmptyAndGoesWithEverythingInIt)
{
  fs::path place;
  {
    const TemporaryFolder folder;
    place = folder.path();
    EXPECT_TRUE(fs::is_empty(place));
    fs::create_directories(folder / "a" / "b");
    std::ofstream(folder / "a" / "b" / "file") << "text";
    fs::permissions(folder / "a", fs::perms::owner_read | fs::perms::owner_exec);
  }
  EXPECT_FALSE(fs::exists(place));
}

TEST(TemporaryFolder, IsNeverSharedByTwo)
{
  const TemporaryFolder one, other;
  EXPECT_NE(one.path(), other.path());
}

}  // namespace
}  // namespace perilymph::test
