// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/foundation/TomlReader.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <functional>
#include <random>

#include "perilymph/test/TemporaryFolder.h"

namespace perilymph {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::MatchesRegex;
using testing::StartsWith;

constexpr Range speeds{0.01, 200.0};

TomlReader parsed(const std::string& text)
{
  Result<TomlReader> reader = TomlReader::parse(text, "my.toml");
  EXPECT_TRUE(reader) << reader.error().message;
  return std::move(*reader);
}

/// The error of finish() after reading, or "fine".
std::string errorIn(const std::string& text, const std::function<void(TomlReader&)>& reading)
{
  Result<TomlReader> reader = TomlReader::parse(text, "my.toml");
  if (!reader) return reader.error().message;
  reading(*reader);
  const Result<void> done = reader->finish();
  return done ? "fine" : done.error().message;
}

void readSpeed(TomlReader& reader) { reader.number("speed_mm_s", speeds); }

TEST(TomlReader, GivesWhatTheFileSays)
{
  TomlReader reader = parsed(
      "speed_mm_s = 2.5\nnodes = 100\nwithdraw = true\nlabel = 'left ear'\nside = 'left'\n"
      "from_tip_mm = [0, 1.5, 22]\n");
  EXPECT_EQ(reader.number("speed_mm_s", speeds), 2.5);
  EXPECT_EQ(reader.integer("nodes", 2, 1000, 50), 100);
  EXPECT_TRUE(reader.flag("withdraw", false));
  EXPECT_EQ(reader.text("label"), "left ear");
  EXPECT_EQ(reader.choice("side", {"right", "left"}), "left");
  EXPECT_THAT(reader.numbers("from_tip_mm", {0.0, 25.0}, 2), ElementsAre(0.0, 1.5, 22.0));
  EXPECT_TRUE(reader.finish());
}

TEST(TomlReader, GivesFallbacksForWhatIsAbsent)
{
  TomlReader reader = parsed("");
  EXPECT_EQ(reader.number("speed_mm_s", speeds, 3.0), 3.0);
  EXPECT_EQ(reader.integer("nodes", 2, 1000, 50), 50);
  EXPECT_TRUE(reader.flag("withdraw", true));
  EXPECT_EQ(reader.text("label", "none"), "none");
  EXPECT_EQ(reader.choice("side", {"right", "left"}, "left"), "left");
  EXPECT_TRUE(reader.tables("sensor").empty());
  EXPECT_FALSE(reader.has("speed_mm_s"));
  EXPECT_TRUE(reader.finish());
}

TEST(TomlReader, TakesAWholeNumberForANumber)
{
  TomlReader reader = parsed("speed_mm_s = 2");
  EXPECT_EQ(reader.number("speed_mm_s", speeds), 2.0);
}

TEST(TomlReader, TakesTheEndsOfARange)
{
  EXPECT_EQ(errorIn("speed_mm_s = 0.01", readSpeed), "fine");
  EXPECT_EQ(errorIn("speed_mm_s = 200", readSpeed), "fine");
}

TEST(TomlReader, NamesFileLineKeyValueAndRange)
{
  EXPECT_EQ(errorIn("\n\n\n\n\n\nspeed_mm_s = -3\n", readSpeed),
            "my.toml:7: speed_mm_s is -3; it must be between 0.01 and 200.");
}

TEST(TomlReader, NamesTheKeyThatIsMissing)
{
  const auto reading = [](TomlReader& reader) { reader.number("st_length_mm", {25.0, 45.0}); };
  EXPECT_EQ(errorIn("", reading),
            "my.toml: key 'st_length_mm' is missing; it must be between 25 and 45.");
}

TEST(TomlReader, GuessesWhatAnUnknownKeyMeant)
{
  const auto reading = [](TomlReader& reader) {
    reader.number("speed_mm_s", speeds, 1.0);
    reader.number("stop_travel_mm", {0.0, 30.0}, 16.5);
  };
  EXPECT_EQ(errorIn("\n\n\nspeed = 3\n", reading),
            "my.toml:4: unknown key 'speed'; did you mean speed_mm_s?");
  EXPECT_EQ(errorIn("speed_mms = 3", reading),
            "my.toml:1: unknown key 'speed_mms'; did you mean speed_mm_s?");
  EXPECT_EQ(errorIn("color = 3", reading),
            "my.toml:1: unknown key 'color'; known are speed_mm_s, stop_travel_mm.");
}

TEST(TomlReader, PrefersTheMisspelledKeyToTheMissingOne)
{
  EXPECT_EQ(errorIn("speed = 3", readSpeed),
            "my.toml:1: unknown key 'speed'; did you mean speed_mm_s?");
}

TEST(TomlReader, RefusesWhatIsNotFinite)
{
  for (const std::string value : {"nan", "inf", "-inf", "+nan"})
    EXPECT_THAT(errorIn("x_mm = " + value, [](TomlReader& reader) { reader.number("x_mm", {}); }),
                MatchesRegex("my.toml:1: x_mm is -?(nan|inf); it must be a finite number\\."));
  const auto list = [](TomlReader& reader) { reader.numbers("x_mm", {}, 1); };
  EXPECT_EQ(errorIn("x_mm = [1, nan]", list),
            "my.toml:1: x_mm has nan as number 2; it must be a list of at least 1 numbers, each a "
            "finite number.");
}

TEST(TomlReader, RefusesAWrongType)
{
  EXPECT_EQ(errorIn("speed_mm_s = 'fast'", readSpeed),
            "my.toml:1: speed_mm_s is 'fast'; it must be a number, between 0.01 and 200.");
  EXPECT_EQ(errorIn("speed_mm_s = true", readSpeed),
            "my.toml:1: speed_mm_s is true; it must be a number, between 0.01 and 200.");
  EXPECT_EQ(errorIn("[speed_mm_s]", readSpeed),
            "my.toml:1: speed_mm_s is a table; it must be a number, between 0.01 and 200.");
  const auto whole = [](TomlReader& reader) { reader.integer("nodes", 2, 1000, 50); };
  EXPECT_EQ(errorIn("nodes = 100.5", whole),
            "my.toml:1: nodes is 100.5; it must be a whole number between 2 and 1000.");
  EXPECT_EQ(
      errorIn("nodes = 9223372036854775807", whole),
      "my.toml:1: nodes is 9223372036854775807; it must be a whole number between 2 and 1000.");
  const auto flag = [](TomlReader& reader) { reader.flag("withdraw", false); };
  EXPECT_EQ(errorIn("withdraw = 1", flag), "my.toml:1: withdraw is 1; it must be true or false.");
  const auto text = [](TomlReader& reader) { reader.text("label"); };
  EXPECT_EQ(errorIn("label = 12", text),
            "my.toml:1: label is 12; it must be text in quotation marks.");
  EXPECT_EQ(errorIn("", text), "my.toml: key 'label' is missing; it must be text.");
}

TEST(TomlReader, NamesTheChoices)
{
  const auto side = [](TomlReader& reader) { reader.choice("side", {"right", "left"}); };
  EXPECT_EQ(errorIn("side = 'up'", side),
            "my.toml:1: side is 'up'; it must be one of right, left.");
  EXPECT_EQ(errorIn("", side), "my.toml: key 'side' is missing; it must be one of right, left.");
}

TEST(TomlReader, RefusesListsThatAreTooShortOrOutOfRange)
{
  const auto places = [](TomlReader& reader) { reader.numbers("from_tip_mm", {0.0, 25.0}, 2); };
  const std::string must = "it must be a list of at least 2 numbers, each between 0 and 25.";
  EXPECT_EQ(errorIn("from_tip_mm = [1]", places), "my.toml:1: from_tip_mm has 1 numbers; " + must);
  EXPECT_EQ(errorIn("from_tip_mm = [1, 30.5]", places),
            "my.toml:1: from_tip_mm has 30.5 as number 2; " + must);
  EXPECT_EQ(errorIn("from_tip_mm = [1, 'b']", places),
            "my.toml:1: from_tip_mm has 'b' as number 2; " + must);
  EXPECT_EQ(errorIn("from_tip_mm = 3", places), "my.toml:1: from_tip_mm is 3; " + must);
}

TEST(TomlReader, GivesUsableValuesAfterAnError)
{
  TomlReader reader = parsed("speed_mm_s = -3\nfrom_tip_mm = []\nside = 'up'");
  EXPECT_EQ(reader.number("speed_mm_s", speeds), speeds.low);
  EXPECT_THAT(reader.numbers("from_tip_mm", {1.0, 2.0}, 2), ElementsAre(1.0, 1.0));
  EXPECT_EQ(reader.choice("side", {"right", "left"}), "right");
}

TEST(TomlReader, KeepsTheFirstErrorAlone)
{
  const auto reading = [](TomlReader& reader) {
    reader.number("a_mm", {0.0, 1.0});
    reader.number("b_mm", {0.0, 1.0});
    reader.refuse("a_mm", "a_mm and b_mm do not fit.");
  };
  EXPECT_THAT(errorIn("b_mm = 3\na_mm = 4", reading), StartsWith("my.toml:2: a_mm is 4;"));
}

TEST(TomlReader, PutsACallersErrorAtItsLine)
{
  const auto reading = [](TomlReader& reader) {
    reader.number("a_mm", {});
    reader.refuse("a_mm", "a_mm does not fit.");
  };
  EXPECT_EQ(errorIn("\na_mm = 4", reading), "my.toml:2: a_mm does not fit.");
}

TEST(TomlReader, ReportsTheErrorsOfItsTables)
{
  const auto reading = [](TomlReader& reader) {
    TomlReader stylet = reader.table("stylet");
    stylet.number("from_tip_mm", {0.0, 25.0});
  };
  EXPECT_EQ(errorIn("[stylet]\nfrom_tip_mm = 2", reading), "fine");
  EXPECT_EQ(errorIn("[stylet]\nfrom_tip_mm = 26", reading),
            "my.toml:2: stylet.from_tip_mm is 26; it must be between 0 and 25.");
  EXPECT_EQ(errorIn("\n[stylet]\n", reading),
            "my.toml:2: key 'stylet.from_tip_mm' is missing; it must be between 0 and 25.");
  EXPECT_EQ(errorIn("[stylet]\nfrom_tip_mm = 2\ncolor = 1", reading),
            "my.toml:3: unknown key 'stylet.color'; known are from_tip_mm.");
  EXPECT_EQ(errorIn("stylet = 3", reading),
            "my.toml:1: stylet is 3; it must be a table under [stylet].");
}

TEST(TomlReader, GivesTheSameTableWhenAskedTwice)
{
  const auto reading = [](TomlReader& reader) {
    reader.table("stylet").number("from_tip_mm", {0.0, 25.0});
    reader.table("stylet").number("bending_N_m2", {0.0, 1.0});
  };
  EXPECT_EQ(errorIn("[stylet]\nfrom_tip_mm = 2\nbending_N_m2 = 1e-6", reading), "fine");
}

TEST(TomlReader, ReadsListsOfTables)
{
  TomlReader reader = parsed("[[sensor]]\nx_mm = 1\n[[sensor]]\nx_mm = 7\ny_mm = 1");
  std::vector<TomlReader> sensors = reader.tables("sensor");
  ASSERT_EQ(sensors.size(), 2u);
  EXPECT_EQ(sensors[0].number("x_mm", {0.0, 5.0}), 1.0);
  EXPECT_TRUE(sensors[0].finish());
  sensors[1].number("x_mm", {0.0, 5.0});
  ASSERT_FALSE(reader.finish());
  EXPECT_EQ(reader.finish().error().message,
            "my.toml:4: sensor[2].x_mm is 7; it must be between 0 and 5.");
}

TEST(TomlReader, SaysWhereTextIsNotToml)
{
  EXPECT_THAT(errorIn("a = 1\n\nspeed = = 3", readSpeed),
              StartsWith("my.toml:3:9: this is not TOML: "));
  EXPECT_THAT(errorIn("a = 1\na = 2", readSpeed), StartsWith("my.toml:2:"));
}

TEST(TomlReader, SaysWhereTextIsNotUtf8)
{
  for (const std::string bytes :
       {"\xff", "\xc0\x80", "\xed\xa0\x80", "\xf4\x90\x80\x80", "\xe2\x82"})
    EXPECT_EQ(errorIn("a = 1\nb = '" + bytes, readSpeed),
              "my.toml:2: this is not UTF-8 text. Check that it is the right file and save it as "
              "UTF-8.");
}

TEST(TomlReader, RefusesNestingWithoutBound)
{
  std::string dotted = "a";
  for (int i = 0; i < 1000000; ++i) dotted += ".a";
  EXPECT_THAT(errorIn(dotted + " = 1", readSpeed), HasSubstr("more than 16 parts"));
  EXPECT_THAT(errorIn("[" + dotted + "]", readSpeed), HasSubstr("more than 16 parts"));
  EXPECT_THAT(errorIn("a = " + std::string(1000000, '['), readSpeed), HasSubstr("not TOML"));
  EXPECT_THAT(errorIn("a = '........................'\n# ..................\n", readSpeed),
              StartsWith("my.toml: key 'speed_mm_s' is missing"));
}

TEST(TomlReader, ShortensALongValue)
{
  const std::string message = errorIn("speed_mm_s = '" + std::string(5000, 'x') + "'", readSpeed);
  EXPECT_LT(message.size(), 200u);
  EXPECT_THAT(message, HasSubstr("xxx...'"));
}

TEST(TomlReader, KeepsAMessageOnOneLine)
{
  EXPECT_EQ(errorIn("speed_mm_s = \"a\\nb\\u001b\"", readSpeed).find_first_of("\n\x1b"),
            std::string::npos);
}

TEST(TomlReader, SaysWhatIsWrongWithAFile)
{
  const test::TemporaryFolder folder;
  const auto messageOf = [](const Result<TomlReader>& reader) {
    return reader ? "no error" : reader.error().message;
  };
  EXPECT_THAT(messageOf(TomlReader::open(folder / "no.toml")), HasSubstr("there is no such file"));
  EXPECT_THAT(messageOf(TomlReader::open(folder.path())), HasSubstr("it is a folder"));
  std::ofstream(folder / "large.toml") << "";
  std::filesystem::resize_file(folder / "large.toml", (std::uintmax_t{16} << 20) + 1);
  EXPECT_THAT(messageOf(TomlReader::open(folder / "large.toml")), HasSubstr("larger than 16 MiB"));
  std::ofstream(folder / "bad.toml") << "a = 1\nb";
  EXPECT_THAT(messageOf(TomlReader::open(folder / "bad.toml")),
              StartsWith((folder / "bad.toml").string() + ":2:"));
}

TEST(TomlReader, SurvivesDamagedFiles)
{
  const std::string whole =
      "name = \"Nucleus\"\nspeed_mm_s = 2.0\n[stylet]\nfrom_tip_mm = [0, 1.5]\n[[s]]\nx = {a = 1}\n"
      "note = \"\"\"\nlong\n\"\"\"\nwhen = 2024-01-01T10:00:00Z\n";
  std::mt19937 bits(11);
  for (int i = 0; i < 3000; ++i) {
    std::string damaged = whole.substr(0, 1 + bits() % whole.size());
    for (int change = 0; change < 3; ++change)
      damaged[bits() % damaged.size()] = static_cast<char>(bits() % 256);
    EXPECT_FALSE(errorIn(damaged, [](TomlReader& reader) {
                   reader.number("speed_mm_s", speeds);
                   reader.table("stylet").numbers("from_tip_mm", {0.0, 25.0}, 2);
                   reader.tables("s");
                   reader.dump();
                 }).empty());
  }
}

}  // namespace
}  // namespace perilymph
