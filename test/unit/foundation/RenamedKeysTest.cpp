// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/foundation/RenamedKeys.h"

#include <gmock/gmock.h>

#include <fstream>
#include <string>
#include <vector>

#include "perilymph/foundation/TomlReader.h"
#include "perilymph/test/TemporaryFolder.h"

namespace perilymph {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// Collects warnings until it is destroyed.
class Heard {
public:
  Heard()
  {
    setWarningHandler([this](const std::string& warning) { warnings.push_back(warning); });
  }
  ~Heard() { setWarningHandler({}); }
  Heard(const Heard&) = delete;
  Heard& operator=(const Heard&) = delete;

  std::vector<std::string> warnings;
};

std::string fileWith(const test::TemporaryFolder& folder, const std::string& text)
{
  const auto file = folder.path() / "device.toml";
  std::ofstream(file) << text;
  return file.string();
}

TEST(RenamedKeys, MapToTheirCurrentName)
{
  EXPECT_EQ(currentKey("most_force_N"), "max_force_N");
  EXPECT_EQ(currentKey("max_force_N"), "max_force_N");
  EXPECT_EQ(currentKey("speed_mm_s"), "speed_mm_s");
}

TEST(RenamedKeys, AreReadUnderTheirOldNameWithAWarningThatSaysTheNewOne)
{
  const test::TemporaryFolder folder;
  const std::string file = fileWith(folder, "name = 'x'\n[capability]\nmost_force_N = 3.0\n");
  const Heard heard;
  auto reader = TomlReader::open(file);
  ASSERT_TRUE(reader) << reader.error().message;
  reader->text("name");
  TomlReader table = reader->table("capability");
  EXPECT_EQ(table.number("max_force_N", {0.0, 10.0}), 3.0);
  EXPECT_TRUE(reader->finish());
  EXPECT_THAT(heard.warnings,
              ElementsAre(file + ":3: the key 'capability.most_force_N' is now called "
                                 "'max_force_N'; the old name is read until version 1.0. "
                                 "Rename it."));
}

TEST(RenamedKeys, KeepTheLineOfTheOldNameInErrors)
{
  auto reader = TomlReader::parse("\n\nmost_force_N = 30.0\n", "my.toml");
  ASSERT_TRUE(reader);
  reader->number("max_force_N", {0.0, 10.0});
  const auto done = reader->finish();
  ASSERT_FALSE(done);
  EXPECT_EQ(done.error().message, "my.toml:3: max_force_N is 30; it must be between 0 and 10.");
}

TEST(RenamedKeys, AreReadInListsOfTablesAndAsNamesOfTables)
{
  const std::string text =
      "[residual_curvature_share]\nvalue = 0.25\n"
      "[[device]]\nmost_force_N = 1.0\n[[device]]\nmax_force_N = 2.0\n";
  auto reader = TomlReader::parse(text, "my.toml");
  ASSERT_TRUE(reader);
  TomlReader curvature = reader->table("residual_curvature_fraction");
  EXPECT_EQ(curvature.number("value", {0.0, 1.0}), 0.25);
  auto devices = reader->tables("device");
  ASSERT_EQ(devices.size(), 2u);
  EXPECT_EQ(devices[0].number("max_force_N", {0.0, 10.0}), 1.0);
  EXPECT_EQ(devices[1].number("max_force_N", {0.0, 10.0}), 2.0);
  EXPECT_TRUE(reader->finish());
}

TEST(RenamedKeys, AreRefusedBesideTheirNewName)
{
  const auto reader = TomlReader::parse("max_force_N = 1.0\nmost_force_N = 2.0\n", "my.toml");
  ASSERT_FALSE(reader);
  EXPECT_EQ(reader.error().message,
            "my.toml:2: the key 'most_force_N' is the old name of 'max_force_N', which is given, "
            "too. Remove 'most_force_N'.");
}

TEST(RenamedKeys, AreSetUnderTheirOldName)
{
  const Heard heard;
  auto reader = TomlReader::parse("residual_curvature_fraction = 0.5", "my.toml");
  ASSERT_TRUE(reader);
  reader->set("residual_curvature_share", "0.1");
  EXPECT_EQ(reader->number("residual_curvature_fraction", {0.0, 1.0}), 0.1);
  EXPECT_TRUE(reader->finish());
  ASSERT_EQ(heard.warnings.size(), 1u);
  EXPECT_THAT(heard.warnings[0], HasSubstr("--set residual_curvature_share=0.1"));
  EXPECT_THAT(heard.warnings[0], HasSubstr("'residual_curvature_fraction'"));
}

TEST(RenamedKeys, OfTextThatIsNoFileGiveNoWarning)
{
  // A recording contains the text of its scenario, where keys cannot be renamed.
  const Heard heard;
  auto reader = TomlReader::parse("most_force_N = 1.0", "recording");
  ASSERT_TRUE(reader);
  EXPECT_EQ(reader->number("max_force_N", {0.0, 10.0}), 1.0);
  EXPECT_THAT(heard.warnings, IsEmpty());
}

TEST(RenamedKeys, WarnAboutKeysReadBeforeTheHandlerWasSet)
{
  const test::TemporaryFolder folder;
  const std::string file = fileWith(folder, "dead_share = 0.1\n");
  EXPECT_TRUE(TomlReader::open(file));
  const Heard heard;
  ASSERT_EQ(heard.warnings.size(), 1u);
  EXPECT_THAT(heard.warnings[0], HasSubstr("'dead_zone'"));
}

TEST(RenamedKeys, WarnOnceForTheSameKey)
{
  const test::TemporaryFolder folder;
  const std::string file = fileWith(folder, "most_force_N = 3.0\n");
  const Heard heard;
  EXPECT_TRUE(TomlReader::open(file));
  EXPECT_TRUE(TomlReader::open(file));
  EXPECT_EQ(heard.warnings.size(), 1u);
}

}  // namespace
}  // namespace perilymph
