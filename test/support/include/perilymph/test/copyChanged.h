// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Scenarios and arrays of a test, from the shipped ones.

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

namespace perilymph::test {

/// Writes a copy of a text file in which some texts, each found once or more, are replaced where they
/// come first. The test fails if one is not in it.
/// @param changes  Pairs of the former and the new text.
/// @return The path of the copy.
inline std::string copyChanged(const std::filesystem::path& from, const std::filesystem::path& to,
                               const std::vector<std::pair<std::string, std::string>>& changes)
{
  std::ifstream file(from);
  std::string text(std::istreambuf_iterator<char>(file), {});
  for (const auto& [former, changed] : changes) {
    const auto place = text.find(former);
    EXPECT_NE(place, std::string::npos) << former << " in " << from;
    if (place != std::string::npos) text.replace(place, former.size(), changed);
  }
  std::ofstream(to) << text;
  return to.string();
}

}  // namespace perilymph::test
