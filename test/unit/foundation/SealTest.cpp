// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/foundation/Seal.h"

#include <gtest/gtest.h>

namespace perilymph::test {
namespace {

std::string sealedText()
{
  return sealed("{\n  \"format\": 2,\n  \"side\": \"left\",\n  \"" + std::string(sealKey) +
                "\": \"" + sealToBe() + "\"\n}\n");
}

TEST(SealOfAText, HoldsForTheTextAlone)
{
  const std::string text = sealedText();
  EXPECT_EQ(text.find(sealToBe()), std::string::npos);
  EXPECT_EQ(sealIn(text, true), Seal::intact);
  // Every bit of every byte, the seal's own and its key's among them.
  for (std::size_t i = 0; i < text.size(); ++i)
    for (int bit = 0; bit < 8; ++bit) {
      std::string other = text;
      other[i] = static_cast<char>(other[i] ^ (1 << bit));
      EXPECT_EQ(sealIn(other, true), Seal::changed) << "byte " << i << ", bit " << bit;
    }
}

TEST(SealOfAText, IsAbsentInFormatsThatHadNoneOnly)
{
  const std::string text = "{\"side\": \"left\"}";
  EXPECT_EQ(sealIn(text, false), Seal::absent);
  EXPECT_EQ(sealIn(text, true), Seal::changed);
  EXPECT_EQ(sealIn(sealedText(), false), Seal::changed);
  EXPECT_EQ(sealIn("", false), Seal::absent);
}

TEST(SealOfAText, IsNotOneThatStandsInANote)
{
  // as JSON writes a note that quotes a seal
  const std::string text =
      R"({"notes": "\"content_sha256\": \"0000000000000000000000000000000000000000000000000000000000000000\""})";
  EXPECT_EQ(sealIn(text, false), Seal::absent);
}

TEST(Programs, SealWhatTheyWriteFromARelease)
{
  for (const char* program :
       {"0.3.0", "0.3.0-dev+1a2b3c4d5e6f", "perilymph 0.3.0-dev+1a2b with PERILYMPH_RESOURCES",
        "Perilymph 0.3.1", "0.10.2", "1.0.0", "perilymph 12.1"})
    EXPECT_TRUE(hasToBeSealed(program)) << program;
  for (const char* program : {"0.2.0", "0.2.9+abc", "perilymph 0.2", "Perilymph 0.1.0", "", "0",
                              "3", "0.", "-1.4", "other 4.0", "perilymph", "1 0.4", "v0.4"})
    EXPECT_FALSE(hasToBeSealed(program)) << program;
  EXPECT_TRUE(hasToBeSealed("0.2.0+1a2b", sealsRecordings));
  EXPECT_FALSE(hasToBeSealed("0.1.0+1a2b", sealsRecordings));
}

TEST(SealOfATable, CoversFactsAndRows)
{
  SealedFacts facts = {{"fingerprint", "ab"}, {"program", "1"}};
  Sha256 rows;
  rows.add(std::uint64_t{7});
  facts[sealKey] = sealOver(facts, rows);
  EXPECT_EQ(sealIn(facts, rows, true), Seal::intact);
  EXPECT_EQ(sealIn(facts, rows, false), Seal::changed);
  EXPECT_EQ(sealIn(facts, Sha256(), true), Seal::changed);
  // a fact of the same letters, divided in another way
  SealedFacts other = {{"fingerprint", "ab1"}, {"program", ""}, {sealKey, facts[sealKey]}};
  EXPECT_EQ(sealIn(other, rows, true), Seal::changed);
  facts.erase(sealKey);
  EXPECT_EQ(sealIn(facts, rows, false), Seal::absent);
  EXPECT_EQ(sealIn(facts, rows, true), Seal::changed);
}

}  // namespace
}  // namespace perilymph::test
