// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <locale>
#include <random>

#include "perilymph/foundation/TomlReader.h"

namespace perilymph {
namespace {

TomlReader parsed(const std::string& text)
{
  Result<TomlReader> reader = TomlReader::parse(text, "my.toml");
  EXPECT_TRUE(reader) << reader.error().message << "\n" << text;
  return std::move(*reader);
}

/// A number as C prints it with 17 digits, which reads back to the same bits.
std::string seventeenDigits(double value)
{
  char buffer[40];
  std::snprintf(buffer, sizeof buffer, "%.17g", value);
  const std::string text = buffer;
  return text.find_first_of(".en") == std::string::npos ? text + ".0" : text;
}

TEST(TomlDump, ReadsBackToTheSameBits)
{
  std::mt19937_64 bits(5);
  for (int i = 0; i < 2000; ++i) {
    const double value = std::bit_cast<double>(bits());
    if (!std::isfinite(value)) continue;
    TomlReader first = parsed("x = " + seventeenDigits(value));
    TomlReader second = parsed(first.dump());
    const double back = second.number("x", {});
    ASSERT_EQ(std::bit_cast<std::uint64_t>(back), std::bit_cast<std::uint64_t>(value)) << value;
  }
}

TEST(TomlDump, WritesTheShortestFormOfANumber)
{
  EXPECT_EQ(parsed("x = 0.10000000000000000").dump(), "x = 0.1\n");
  EXPECT_EQ(parsed("x = 22.000").dump(), "x = 22.0\n");
  EXPECT_EQ(parsed("x = 22").dump(), "x = 22\n");
}

TEST(TomlDump, SortsKeysAndPutsTablesLast)
{
  EXPECT_EQ(parsed("z = 1\n[m]\nb = 2\na = 1\n[m.deep]\nc = true\n").dump() + "|",
            "z = 1\n\n[m]\na = 1\nb = 2\n\n[m.deep]\nc = true\n|");
}

TEST(TomlDump, KeepsEveryKindOfValue)
{
  const std::string text =
      "a = \"q\\\"b\\\\s\\n\\t\\u0001 \xc3\xa9\"\n"
      "b = [1, 2.5, 'x', [true]]\n"
      "c = 2024-02-29T10:20:30.5Z\n"
      "d = 2024-02-29\n"
      "e = 10:20:30\n"
      "f = inf\n"
      "\"a key\" = -0.0\n"
      "[[list]]\nx = { y = 1, z = [] }\n[[list]]\n"
      "[\"a.b\"]\nv = 1\n";
  TomlReader first = parsed(text);
  TomlReader second = parsed(first.dump());
  EXPECT_EQ(second.text("a"), "q\"b\\s\n\t\x01 \xc3\xa9");
  EXPECT_TRUE(std::signbit(second.number("a key", {})));
  EXPECT_EQ(second.table("a.b").integer("v", 0, 9, 0), 1);
  ASSERT_EQ(second.tables("list").size(), 2u);
  EXPECT_EQ(second.tables("list")[0].table("x").integer("y", 0, 9, 0), 1);
  const std::string dump = second.dump();
  for (const char* line : {"b = [1, 2.5, \"x\", [true]]\n", "c = 2024-02-29T10:20:30.5Z\n",
                           "d = 2024-02-29\n", "e = 10:20:30\n", "f = inf\n"})
    EXPECT_NE(dump.find(line), std::string::npos) << line << dump;
}

/// Number format of some countries: 1.234,5.
class Commas : public std::numpunct<char> {
protected:
  char do_decimal_point() const override { return ','; }
  char do_thousands_sep() const override { return '.'; }
  std::string do_grouping() const override { return "\3"; }
};

TEST(TomlDump, DoesNotDependOnTheLocale)
{
  const std::locale older =
      std::locale::global(std::locale(std::locale::classic(), new Commas));  // owned by the locale
  TomlReader reader = parsed("d = 2024-02-29\nn = 12345\nx = 1234.5\n");
  const std::string dump = reader.dump();
  reader.number("x", {0.0, 1000.5});
  const std::string message = reader.finish().error().message;
  std::locale::global(older);
  EXPECT_EQ(dump, "d = 2024-02-29\nn = 12345\nx = 1234.5\n");
  EXPECT_EQ(message, "my.toml:3: x is 1234.5; it must be between 0 and 1000.5.");
}

}  // namespace
}  // namespace perilymph
