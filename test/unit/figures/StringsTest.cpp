// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/figures/Strings.h"

#include <gtest/gtest.h>

namespace perilymph::figures {
namespace {

TEST(FigureStrings, PutNumbersWhereALanguageWantsThem)
{
  EXPECT_EQ(filled("mean %1 mm, %2 inside", {"0.5", "12"}), "mean 0.5 mm, 12 inside");
  EXPECT_EQ(filled("%2 Kontakte, %1 mm", {"0.5", "12"}), "12 Kontakte, 0.5 mm");
  EXPECT_EQ(filled("no numbers", {"7"}), "no numbers");
}

TEST(FigureStrings, WriteTheDecimalSignOfALanguage)
{
  EXPECT_EQ(withDecimalSign("0.5", ','), "0,5");
  EXPECT_EQ(withDecimalSign("0.5 mm", '.'), "0.5 mm");
  EXPECT_EQ(withDecimalSign("12", ','), "12");
}

TEST(FigureStrings, RoundToSoManyDigits)
{
  EXPECT_EQ(fixed(0.08849, 3), "0.088");
  EXPECT_EQ(fixed(-2.5, 0), "-2");  // half to even
  EXPECT_EQ(fixed(1e20, 1), "100000000000000000000.0");
}

}  // namespace
}  // namespace perilymph::figures
