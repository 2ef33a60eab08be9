// SPDX-License-Identifier: BSD-3-Clause

// A patient's file from measures: what the flags allow, and what of them it keeps.

#include "perilymph/imaging/MeasuredPatient.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

namespace perilymph::imaging {
namespace {

using testing::HasSubstr;

ct::CochleaMeasures measuredWith(ct::Flag flag)
{
  ct::CochleaMeasures measures;
  measures.a.value = 9.2;
  measures.b.value = 6.8;
  measures.h.value = 3.9;
  measures.flags = {flag};
  return measures;
}

TEST(MeasuredPatient, IsNotMadeOfACochleaWithoutTheTurnsOfTheModel)
{
  for (const ct::Flag flag : {ct::Flag::fewTurns, ct::Flag::cysticApex}) {
    const auto text = measuredPatientText(measuredWith(flag), "ear");
    ASSERT_FALSE(text) << ct::nameOf(flag);
    EXPECT_THAT(text.error().message, HasSubstr("2.5 turns"));
  }
}

TEST(MeasuredPatient, KeepsEveryOtherFlag)
{
  for (const ct::Flag flag : ct::allFlags()) {
    if (flag == ct::Flag::fewTurns || flag == ct::Flag::cysticApex) continue;
    const auto text = measuredPatientText(measuredWith(flag), "ear");
    ASSERT_TRUE(text) << text.error().message;
    EXPECT_THAT(*text, HasSubstr(std::string("# Flags: ") + ct::nameOf(flag) + "\n"));
  }
}

TEST(MeasuredPatient, HasTheHeightThatIsAllowedOrNoneAndSaysSo)
{
  ct::CochleaMeasures measures = measuredWith(ct::Flag::coarseVoxels);
  measures.h = {3.9, 0.15, 0.0, 0.0};
  EXPECT_FALSE(heightNote(measures));
  EXPECT_EQ(inMillimeters(*measuredPatient(measures).basalTurn->h), 3.9);

  // beyond the highest whole cochlea by less than the error of the measurement, 0.29 mm
  measures.h.value = 4.81;
  EXPECT_EQ(inMillimeters(*measuredPatient(measures).basalTurn->h), 4.8);
  ASSERT_TRUE(heightNote(measures));
  EXPECT_THAT(*heightNote(measures), HasSubstr("H is 4.81 mm, which its error allows"));
  EXPECT_THAT(*heightNote(measures), HasSubstr("4.80 mm is used"));

  measures.h.value = 5.2;
  EXPECT_FALSE(measuredPatient(measures).basalTurn->h);
  EXPECT_FALSE(measuredPatient(measures).errors->h);
  ASSERT_TRUE(heightNote(measures));
  EXPECT_THAT(*heightNote(measures), HasSubstr("outside 2.30 to 4.80 mm"));
  EXPECT_THAT(*measuredPatientText(measures, "ear"), HasSubstr("# H is 5.20 mm"));
}

}  // namespace
}  // namespace perilymph::imaging
