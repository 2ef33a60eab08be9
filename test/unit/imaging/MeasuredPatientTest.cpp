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

}  // namespace
}  // namespace perilymph::imaging
