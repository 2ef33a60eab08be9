// SPDX-License-Identifier: BSD-3-Clause

// The guide's table of what volume files state twice has the rows that the readers use.

#include <gtest/gtest.h>

#include <sstream>

#include "perilymph/foundation/AtomicFile.h"
#include "perilymph/test/Places.h"
#include "statements/VolumePairs.h"

namespace perilymph::imaging {
namespace {

TEST(GuideTable, HasEveryPairOfStatements)
{
  const auto page = readWhole(test::projectFolder() / "resources/guide/files.md");
  ASSERT_TRUE(page) << page.error().message;
  const std::size_t from = page->find("<!-- statements of volumes -->\n");
  ASSERT_NE(from, std::string::npos);
  std::istringstream lines(page->substr(from));
  std::string line;
  for (int headings = 0; headings < 3; ++headings) std::getline(lines, line);
  for (const StatedTwice* pair : volumePairs()) {
    std::getline(lines, line);
    EXPECT_EQ(line, rowOf(*pair));
  }
  std::getline(lines, line);
  EXPECT_EQ(line, "<!-- /statements of volumes -->");
}

}  // namespace
}  // namespace perilymph::imaging
