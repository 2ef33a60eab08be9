// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/foundation/Utf8.h"

#include <gtest/gtest.h>

namespace perilymph {
namespace {

TEST(Utf8, ReadsCharactersOfEveryLength)
{
  for (const auto& [text, code, length] : {std::tuple{"a", 0x61u, 1u},
                                           {"\xc3\xa9", 0xe9u, 2u},
                                           {"\xe2\x82\xac", 0x20acu, 3u},
                                           {"\xf0\x9f\x98\x80", 0x1f600u, 4u},
                                           {"\xf4\x8f\xbf\xbf", 0x10ffffu, 4u}}) {
    const Utf8Character first = firstCharacter(text);
    EXPECT_EQ(static_cast<unsigned>(first.code), code);
    EXPECT_EQ(first.length, length);
  }
}

TEST(Utf8, RefusesWhatTheStandardRefuses)
{
  // RFC 3629: lone continuation byte, overlong form, surrogate, above U+10FFFF, truncated
  for (const char* text :
       {"\x80", "\xc0\xaf", "\xc1\xbf", "\xe0\x80\xaf", "\xed\xa0\x80", "\xf0\x80\x80\xaf",
        "\xf4\x90\x80\x80", "\xf5\x80\x80\x80", "\xff", "\xe2\x82", "\xc3"})
    EXPECT_EQ(firstCharacter(text).length, 0u) << text;
}

TEST(Utf8, ReplacesEachInvalidByte)
{
  EXPECT_EQ(validUtf8("a\xff\xc3\xa9\xe2\x82"), "a\xef\xbf\xbd\xc3\xa9\xef\xbf\xbd\xef\xbf\xbd");
  EXPECT_EQ(validUtf8(""), "");
}

TEST(Utf8, HasNoControlCharactersOnOneLine)
{
  EXPECT_EQ(onOneLine("a\nb\x1b[2J\x7f\xc2\x9b\xc3\xa9"), "a b [2J  \xc3\xa9");
}

}  // namespace
}  // namespace perilymph
