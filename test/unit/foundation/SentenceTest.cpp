// SPDX-License-Identifier: BSD-3-Clause

// Sentences as a phrase and its values, and out of a file again.

#include "perilymph/foundation/Sentence.h"

#include <gmock/gmock.h>

#include "perilymph/foundation/Result.h"

namespace perilymph {
namespace {

using testing::ElementsAre;

TEST(Sentence, HasItsValuesInTheirPlaces)
{
  const Sentence sentence{"%2 of %1 files (%3) are cut off.", 12u, "a %1 b",
                          std::filesystem::path("/ct/x y")};
  EXPECT_EQ(sentence, "a %1 b of 12 files (/ct/x y) are cut off.");
  EXPECT_STREQ(sentence.phrase(), "%2 of %1 files (%3) are cut off.");
  EXPECT_THAT(sentence.values(), ElementsAre("12", "a %1 b", "/ct/x y"));
}

TEST(Sentence, KeepsASentenceWithinIt)
{
  const Error inner{"%1 does not exist.", "/ct"};
  const Error outer{"The ear was not measured. %1", inner.message};
  EXPECT_EQ(outer.message, "The ear was not measured. /ct does not exist.");
  EXPECT_STREQ(outer.message.values().at(0).phrase(), "%1 does not exist.");
}

TEST(Sentence, HasPercentSignsWithoutAPlaceAsTheyAre)
{
  EXPECT_EQ((Sentence{"%1 % at 5 %, %0", 90}), "90 % at 5 %, %0");
}

TEST(Sentence, WithoutAPhraseIsTheText)
{
  const Sentence sentence = std::string("a name with %1");
  EXPECT_EQ(sentence.phrase(), nullptr);
  EXPECT_EQ(sentence, "a name with %1");
}

constexpr Phrase known[] = {Phrase{"%1 % at friction %2 to %3"},
                            Phrase{"The measures of %1 carry no seal."},
                            Phrase{"Ends are those of the model."}};

TEST(Sentence, IsRecognizedInATextOfAFile)
{
  for (const Sentence& sentence :
       {Sentence(known[0], {std::string("90"), std::string("0.1"), std::string("0.5")}),
        Sentence(known[1], {std::string("P-017, of which")}), Sentence(known[2])}) {
    const Sentence read = recognized(sentence, known);
    EXPECT_EQ(read.phrase(), sentence.phrase()) << sentence;
    EXPECT_EQ(read.values(), sentence.values());
    EXPECT_EQ(read, sentence);
  }
}

TEST(Sentence, IsNotRecognizedInAnotherText)
{
  for (const char* const text :
       {"", "90", "% at friction  to ", "90 % at friction 0.1", "The measures of  carry no seal.",
        "The measures of P-017 carry no seal. More.", "Ends are those of the model.."}) {
    const Sentence read = recognized(text, known);
    EXPECT_EQ(read.phrase(), nullptr) << text;
    EXPECT_EQ(read, text);
  }
}

}  // namespace
}  // namespace perilymph
