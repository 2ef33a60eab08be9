// SPDX-License-Identifier: BSD-3-Clause

// The conformance statement in the guide lists the storage classes that are accepted, and no other.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <regex>
#include <set>
#include <string>

#include "StoreRequest.h"
#include "perilymph/foundation/AtomicFile.h"
#include "perilymph/test/Places.h"

namespace perilymph::archive {
namespace {

TEST(ConformanceStatement, ListsTheStorageClassesThatAreAccepted)
{
  const auto page = readWhole(test::projectFolder() / "resources/guide/archive.md");
  ASSERT_TRUE(page);
  std::set<std::string> images, documents;
  const std::regex row("\\| [^|]*Storage \\| ([0-9.]+) \\| (SCU, )?SCP \\| (A, B|A) \\|");
  for (std::sregex_iterator found(page->begin(), page->end(), row), end; found != end; ++found)
    ((*found)[3] == "A" ? documents : images).insert((*found)[1]);
  EXPECT_EQ(images, std::set<std::string>(imageClasses().begin(), imageClasses().end()));
  EXPECT_EQ(documents, std::set<std::string>(documentClasses().begin(), documentClasses().end()));
}

}  // namespace
}  // namespace perilymph::archive
