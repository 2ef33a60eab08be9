// SPDX-License-Identifier: BSD-3-Clause

// Words beside a force: thresholds as printed, each once crossed, and never a promise.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "gui/scene/ForceInterpretation.h"

namespace perilymph::gui {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

std::string onHand(double force_mN)
{
  return meaningOnHand(millinewtons(force_mN), ForceThresholds::shipped()).text.toStdString();
}

std::string onPartition(double force_mN)
{
  return meaningOnPartition(millinewtons(force_mN), ForceThresholds::shipped()).text.toStdString();
}

// Kratchman 2016: 20.4 mN. Rau 2024: peaks 44.8 to 102.4 mN.
TEST(WordsOfAForceOnTheHand, SayFromWhenSurgeonsFeelIt)
{
  EXPECT_THAT(onHand(0.0), HasSubstr("below the 20 mN"));
  EXPECT_THAT(onHand(20.3), HasSubstr("below the 20 mN"));
  EXPECT_THAT(onHand(20.5), HasSubstr("felt by surgeons"));
}

TEST(WordsOfAForceOnTheHand, CompareItWithPeaksInPatients)
{
  EXPECT_THAT(onHand(44.0), Not(HasSubstr("patients")));
  EXPECT_THAT(onHand(45.0), HasSubstr("like peaks in patients, 45 to 102 mN"));
  EXPECT_THAT(onHand(103.0), HasSubstr("above the peaks in patients, 102 mN"));
}

TEST(WordsOfAForceOnTheHand, HoldForAPullAsForAPush) { EXPECT_EQ(onHand(-30.0), onHand(30.0)); }

// Schuster 2015: 42 to 122 mN.
TEST(WordsOfAForceOnThePartition, SayWhatItBearsBeforeAndBeyond)
{
  const ForceThresholds known = ForceThresholds::shipped();
  EXPECT_THAT(onPartition(7.0), HasSubstr("on the partition 7 mN"));
  EXPECT_THAT(onPartition(7.0), HasSubstr("42 to 122"));
  EXPECT_FALSE(meaningOnPartition(millinewtons(41.0), known).isBeyond);
  EXPECT_TRUE(meaningOnPartition(millinewtons(43.0), known).isBeyond);
}

TEST(WordsOfAForce, NeverCallItSafe)
{
  for (double force_mN = 0.0; force_mN < 300.0; force_mN += 1.0) {
    EXPECT_THAT(onHand(force_mN), Not(HasSubstr("safe")));
    EXPECT_THAT(onPartition(force_mN), Not(HasSubstr("safe")));
  }
}

}  // namespace
}  // namespace perilymph::gui
