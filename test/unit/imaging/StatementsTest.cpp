// SPDX-License-Identifier: BSD-3-Clause
#include "statements/Statements.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace perilymph::imaging {
namespace {

constexpr StatedTwice length{"Form", "the length", "the ruler",          "the label",       "mm",
                             1e-3,   0.01,         Disagreement::refuse, "measure it again"};

TEST(Disagreement, IsASentenceWithBothValuesPlacesAndTheRemedy)
{
  EXPECT_EQ(disagreement("a.txt", length, 0.3, 300.0, " along k"),
            "a.txt states the length along k twice: 0.3 mm in the ruler and 300 mm in the label; "
            "measure it again.");
  EXPECT_EQ(disagreement("a.txt", length, "blue", "red"),
            "a.txt states the length twice: blue in the ruler and red in the label; measure it "
            "again.");
}

TEST(Disagreement, BeginsBeyondTheLargerTolerance)
{
  EXPECT_FALSE(disagreement("a", length, 1.0, 1.0099));  // 0.01 mm
  EXPECT_TRUE(disagreement("a", length, 1.0, 1.0101));
  EXPECT_FALSE(disagreement("a", length, 1000.0, 999.01));  // a thousandth
  EXPECT_TRUE(disagreement("a", length, 1000.0, 998.99));
  EXPECT_TRUE(disagreement("a", length, 1.0, -1.0));
  EXPECT_FALSE(disagreement("a", length, "red", "red"));
}

TEST(Disagreement, IsThatOfAnyValueWithOneThatIsNoFiniteNumber)
{
  const double infinite = std::numeric_limits<double>::infinity();
  for (const double value : {std::nan(""), infinite, -infinite}) {
    EXPECT_TRUE(disagreement("a", length, value, 1.0));
    EXPECT_TRUE(disagreement("a", length, 1.0, value));
    EXPECT_TRUE(disagreement("a", length, value, value));
  }
}

TEST(Disagreement, ShowsAsManyDigitsAsTellTheValuesApart)
{
  constexpr StatedTwice exact{"Form", "the count",          "the one",    "the other", "", 0.0,
                              0.0,    Disagreement::refuse, "count again"};
  EXPECT_EQ(disagreement("a", exact, 1234567.0, 1234568.0),
            "a states the count twice: 1234567 in the one and 1234568 in the other; count again.");
}

TEST(RowOf, HasFormatQuantityPlacesToleranceAndAnswer)
{
  EXPECT_EQ(rowOf(length),
            "| Form | the length | the ruler | the label | 0.1 % or 0.01 mm | refused |");
}

}  // namespace
}  // namespace perilymph::imaging
