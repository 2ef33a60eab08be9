// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "perilymph/foundation/TomlReader.h"

namespace perilymph {
namespace {

using testing::HasSubstr;

constexpr Range allowedSpeeds{0.01, 200.0};

TomlReader withSet(const std::string& text, const std::string& key, const std::string& value)
{
  Result<TomlReader> reader = TomlReader::parse(text, "my.toml");
  EXPECT_TRUE(reader);
  reader->set(key, value);
  return std::move(*reader);
}

std::string errorOf(TomlReader& reader)
{
  const Result<void> done = reader.finish();
  return done ? "fine" : done.error().message;
}

TEST(TomlSet, ChangesAValueOfTheFile)
{
  TomlReader reader = withSet("speed_mm_s = 2", "speed_mm_s", "3.5");
  EXPECT_EQ(reader.number("speed_mm_s", allowedSpeeds), 3.5);
  EXPECT_EQ(errorOf(reader), "fine");
}

TEST(TomlSet, AddsAValueTheFileHasNot)
{
  TomlReader reader = withSet("", "withdraw", "true");
  EXPECT_TRUE(reader.flag("withdraw", false));
}

TEST(TomlSet, NamesTheCommandLineInPlaceOfALine)
{
  TomlReader reader = withSet("\n\nspeed_mm_s = 2", "speed_mm_s", "-3");
  reader.number("speed_mm_s", allowedSpeeds);
  EXPECT_EQ(errorOf(reader),
            "--set speed_mm_s=-3: speed_mm_s is -3; it must be between 0.01 and 200.");
}

TEST(TomlSet, GuessesWhatAnUnknownKeyMeant)
{
  TomlReader reader = withSet("", "sped_mm_s", "3");
  reader.number("speed_mm_s", allowedSpeeds, 2.0);
  EXPECT_EQ(errorOf(reader),
            "--set sped_mm_s=3: unknown key 'sped_mm_s'; did you mean speed_mm_s?");
}

TEST(TomlSet, NeedsNoQuotationMarks)
{
  TomlReader plain = withSet("", "patient", "../small.toml");
  EXPECT_EQ(plain.text("patient"), "../small.toml");
  TomlReader number = withSet("", "label", "12");
  EXPECT_EQ(number.text("label"), "12");
  TomlReader quoted = withSet("", "label", "\"a b\"");
  EXPECT_EQ(quoted.text("label"), "a b");
  TomlReader choice = withSet("", "side", "left");
  EXPECT_EQ(choice.choice("side", {"right", "left"}), "left");
}

TEST(TomlSet, CannotSmuggleInASecondKey)
{
  TomlReader reader = withSet("", "speed_mm_s", "2\nnodes = 7");
  reader.number("speed_mm_s", allowedSpeeds);
  EXPECT_EQ(reader.integer("nodes", 1, 10, 3), 3);
  EXPECT_THAT(errorOf(reader), HasSubstr("it must be a number, between 0.01 and 200."));
}

TEST(TomlSet, ReachesIntoTables)
{
  TomlReader reader = withSet("[stylet]\nfrom_tip_mm = 2\n", "stylet.from_tip_mm", "30");
  reader.table("stylet").number("from_tip_mm", {0.0, 25.0});
  EXPECT_EQ(errorOf(reader),
            "--set stylet.from_tip_mm=30: stylet.from_tip_mm is 30; it must be between 0 and 25.");
}

TEST(TomlSet, SaysThatAValueIsNoTable)
{
  TomlReader reader = withSet("speed_mm_s = 2", "speed_mm_s.x", "1");
  reader.number("speed_mm_s", allowedSpeeds);
  EXPECT_EQ(errorOf(reader), "--set speed_mm_s.x=1: speed_mm_s is not a table.");
}

TEST(TomlSet, IsPartOfTheDump)
{
  TomlReader reader = withSet("speed_mm_s = 2.0", "speed_mm_s", "3.5");
  EXPECT_EQ(reader.dump(), "speed_mm_s = 3.5\n");
}

}  // namespace
}  // namespace perilymph
