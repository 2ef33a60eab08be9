// SPDX-License-Identifier: BSD-3-Clause

// What the surgeon states: values that no surgery has are refused.

#include <gtest/gtest.h>

#include <functional>

#include "perilymph/outcome/Surgery.h"

namespace perilymph::outcome {
namespace {

TEST(Surgery, MayLeaveOutEverythingButTheArray)
{
  Surgery surgery;
  surgery.array = "flex28";
  EXPECT_TRUE(checkSurgery(surgery));
}

TEST(Surgery, IsRefusedInASentenceThatNamesTheValueAndItsRange)
{
  struct Wrong {
    std::function<void(Surgery&)> change;
    const char* part;
  };
  for (const Wrong& each :
       {Wrong{[](Surgery& s) { s.lot = "lot 12"; }, "“lot 12”"},
        Wrong{[](Surgery& s) { s.intendedDepth = millimeters(41); }, "41"},
        Wrong{[](Surgery& s) { s.intendedDepth = millimeters(-1); },
              "Intended depth is -1 mm; 0 to 40 mm"},
        Wrong{[](Surgery& s) { s.outside = millimeters(std::nan("")); }, "Length outside is"},
        Wrong{[](Surgery& s) { s.contactsOutside = 65; }, "65"},
        Wrong{[](Surgery& s) { s.contactAtResistance = 0; }, "1 to 64"},
        Wrong{[](Surgery& s) { s.attempts = 0; }, "Attempts is 0; 1 to 100"},
        Wrong{[](Surgery& s) { s.pullBacks = -1; }, "Pull-backs is -1"},
        Wrong{[](Surgery& s) { s.daysToCt = 36'501; }, "36500"},
        Wrong{[](Surgery& s) { s.tilt_deg = 91.0; }, "Tilt of the approach is 91°; -90° to 90°"}}) {
    Surgery surgery;
    each.change(surgery);
    const auto checked = checkSurgery(surgery);
    ASSERT_FALSE(checked) << each.part;
    EXPECT_NE(checked.error().message.find(each.part), std::string::npos)
        << checked.error().message;
  }
}

TEST(Surgery, WithAnArrayHasNoMoreContactsAndNoMoreLengthThanIt)
{
  electrode::ArrayDesign array;
  array.name = "Twelve";
  array.insertable = millimeters(28);
  array.contactsFromTip.assign(12, millimeters(1));
  Surgery most;
  most.contactsOutside = most.intendedContacts = most.contactAtResistance = 12;
  most.intendedDepth = millimeters(28.4);  // a mark is read to half a millimeter
  EXPECT_TRUE(checkSurgery(most, array));
  struct Wrong {
    std::function<void(Surgery&)> change;
    const char* sentence;
  };
  for (const Wrong& each : {Wrong{[](Surgery& s) { s.contactsOutside = 13; },
                                  "Contacts outside is 13, and Twelve has 12 contacts."},
                            Wrong{[](Surgery& s) { s.intendedContacts = 16; },
                                  "Contacts intended inside is 16, and Twelve has 12 contacts."},
                            Wrong{[](Surgery& s) { s.contactAtResistance = 13; },
                                  "Contact at first resistance is 13, and Twelve has 12 contacts."},
                            Wrong{[](Surgery& s) { s.intendedDepth = millimeters(35); },
                                  "Intended depth is 35 mm, and Twelve goes 28 mm deep."},
                            Wrong{[](Surgery& s) { s.outside = millimeters(29); },
                                  "Length outside is 29 mm, and Twelve goes 28 mm deep."},
                            Wrong{[](Surgery& s) { s.attempts = 0; }, "Attempts is 0; 1 to 100"}}) {
    Surgery surgery = most;
    each.change(surgery);
    const auto checked = checkSurgery(surgery, array);
    ASSERT_FALSE(checked) << each.sentence;
    EXPECT_EQ(checked.error().message.find(each.sentence), 0u) << checked.error().message;
  }
}

}  // namespace
}  // namespace perilymph::outcome
