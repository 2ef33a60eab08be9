// SPDX-License-Identifier: BSD-3-Clause

// The guide's table of a profile's keys against the reader.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <map>
#include <regex>
#include <set>

#include "codec/DeviceProfile.h"
#include "perilymph/foundation/Resources.h"
#include "perilymph/test/Places.h"

namespace perilymph::device {
namespace {

using testing::HasSubstr;

std::string textOf(const std::filesystem::path& file)
{
  std::ifstream stream(file);
  EXPECT_TRUE(stream) << file;
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// One row of the guide's table.
struct Row {
  std::string table, key, range;
};

std::vector<Row> rows()
{
  const std::string guide = textOf(resource("resources/guide/device-profiles.md"));
  const std::regex row(R"(\n\| ?(\S[^|]*|) ?\| `(\w+)` \| ([^|]*)\| ([^|]*) \|)");
  std::vector<Row> found;
  for (std::sregex_iterator each(guide.begin(), guide.end(), row), end; each != end; ++each)
    found.push_back({(*each)[1], (*each)[2], (*each)[4]});
  return found;
}

TEST(TheGuidesTableOfProfileKeys, HoldsEveryKeyThatIsReadAndNoOther)
{
  std::set<std::string> read;
  const std::regex call(
      R"rx((?:number|numbers|integer|text|choice|flag|has|three|signs|wholeNumbers|readAxis|sixteenBits)\(\s*(?:\w+,\s*)?"([a-z]\w*)")rx");
  const std::regex pair(R"rx((?:slot|readUsage)\(\s*\w+,\s*"(\w+)",\s*"(\w+)")rx");
  const std::regex axes(R"rx(keys\{([^}]*)\})rx");
  for (const char* file : {"DeviceProfile.cpp", "ProfileTables.cpp"}) {
    const std::string source = textOf(test::projectFolder() / "modules/device/src/codec" / file);
    for (std::sregex_iterator each(source.begin(), source.end(), call), end; each != end; ++each)
      read.insert((*each)[1]);
    for (std::sregex_iterator each(source.begin(), source.end(), pair), end; each != end; ++each) {
      read.insert((*each)[1]);
      read.insert((*each)[2]);
    }
    std::smatch list;
    if (std::regex_search(source, list, axes)) {
      const std::string names = list[1];
      const std::regex name(R"rx("(\w+)")rx");
      for (std::sregex_iterator each(names.begin(), names.end(), name), end; each != end; ++each)
        read.insert((*each)[1]);
    }
  }
  read.erase("calibration");  // a table
  std::set<std::string> told;
  for (const Row& row : rows()) told.insert(row.key);
  EXPECT_THAT(told, testing::ContainerEq(read));
  EXPECT_GT(told.size(), 60u);
}

/// A shipped profile with a value in a table replaced or added.
std::string with(std::string text, const std::string& table, const std::string& line,
                 const std::string& key)
{
  const std::string head = "[" + table + "]\n";
  auto begin = text.find(head);
  if (begin == std::string::npos) {
    text += "\n" + head;
    begin = text.size() - head.size();
  }
  begin += head.size();
  const auto end = std::min(text.find("\n[", begin), text.size());
  std::string part = text.substr(begin, end - begin);
  part = std::regex_replace(part, std::regex("(^|\n)" + key + " = [^\n]*"), "$1");
  return text.substr(0, begin) + line + "\n" + part + text.substr(end);
}

TEST(TheGuidesTableOfProfileKeys, GivesTheRangesThatTheReaderAllows)
{
  const std::map<std::string, std::string> bases = {
      {"capability", "plugins/devices/forsslund/woodenhaptics.toml"},
      {"mount", "plugins/devices/forsslund/woodenhaptics.toml"},
      {"linkage", "plugins/devices/forsslund/woodenhaptics.toml"},
      {"axes", "plugins/devices/generic/pid.toml"},
      {"pid", "plugins/devices/generic/pid.toml"}};
  const std::regex range(R"(^(-?[0-9.]+) to (-?[0-9.]+))");
  int checked = 0;
  for (const Row& row : rows()) {
    std::smatch limits;
    if (!std::regex_search(row.range, limits, range)) continue;
    const std::string table = std::regex_replace(row.table, std::regex("[`\\[\\] ]"), "");
    const auto base = bases.find(table);
    if (base == bases.end()) continue;
    const std::string text = textOf(resource(base->second));
    ASSERT_TRUE(parseProfile(text, "base.toml"));
    const double low = std::stod(limits[1]), high = std::stod(limits[2]);
    const double span = high - low;
    // Whole numbers are written as such.
    const bool isWhole = row.key == "buttons" || row.key == "polled_report" ||
                         row.key == "grasp_button" || row.key == "full_counts";
    for (const double outside :
         {low - (isWhole ? 1.0 : 0.01 * span), high + (isWhole ? 1.0 : 0.01 * span)}) {
      char line[96];
      std::snprintf(line, sizeof line, isWhole ? "%s = %.0f" : "%s = %.6f", row.key.c_str(),
                    outside);
      const auto refused = parseProfile(with(text, table, line, row.key), "test.toml");
      ASSERT_FALSE(refused) << line;
      EXPECT_THAT(refused.error().message, HasSubstr(row.key)) << line;
    }
    ++checked;
  }
  EXPECT_GE(checked, 15);
}

TEST(APolarProfile, WhoseAxesWouldPushTheSameWayIsRefused)
{
  const std::string text = textOf(resource("plugins/devices/generic/pid.toml"));
  EXPECT_TRUE(parseProfile(text, "two.toml"));
  const std::string third = with(text, "axes", "y = \"z\"", "y");
  const auto refused = parseProfile(third, "three.toml");
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error().message, HasSubstr("directions_deg"));
  // The opposite direction is the same line.
  EXPECT_FALSE(parseProfile(
      with(third, "pid", "directions_deg = [270.0, 180.0, 0.0]", "directions_deg"), "three.toml"));
  EXPECT_TRUE(parseProfile(
      with(with(third, "pid", "effects = \"axes\"", "effects"), "pid", "", "directions_deg"),
      "three.toml"));
}

}  // namespace
}  // namespace perilymph::device
