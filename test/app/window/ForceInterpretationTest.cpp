// SPDX-License-Identifier: BSD-3-Clause

// The text beside a force: published thresholds from the force at which they are exceeded, and no
// claim of safety.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

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
  EXPECT_THAT(onHand(0.0), HasSubstr("below perception threshold (20 mN)"));
  EXPECT_THAT(onHand(20.3), HasSubstr("below perception threshold (20 mN)"));
  EXPECT_THAT(onHand(20.5), HasSubstr("perceptible (above 20 mN)"));
}

TEST(WordsOfAForceOnTheHand, CompareItWithPeaksInPatients)
{
  EXPECT_THAT(onHand(44.0), Not(HasSubstr("clinical")));
  EXPECT_THAT(onHand(45.0), HasSubstr("within reported clinical peak forces (45–102 mN)"));
  EXPECT_THAT(onHand(103.0), HasSubstr("above reported clinical peak forces (> 102 mN)"));
}

TEST(WordsOfAForceOnTheHand, HoldForAPullAsForAPush) { EXPECT_EQ(onHand(-30.0), onHand(30.0)); }

// Schuster 2015: 42 to 122 mN.
TEST(WordsOfAForceOnThePartition, SayWhatItBearsBeforeAndBeyond)
{
  const ForceThresholds known = ForceThresholds::shipped();
  EXPECT_THAT(onPartition(7.0), HasSubstr("cochlear partition 7 mN"));
  EXPECT_THAT(onPartition(7.0), HasSubstr("rupture assumed at 42–122 mN"));
  EXPECT_FALSE(meaningOnPartition(millinewtons(41.0), known).isBeyond);
  EXPECT_TRUE(meaningOnPartition(millinewtons(43.0), known).isBeyond);
}

TEST(WordsOfAForceOnThePartition, SayThatAnEarlierVersionDidNotRecordIt)
{
  const auto none = meaningOnPartition(newtons(std::nan("")), ForceThresholds::shipped());
  EXPECT_EQ(none.text.toStdString(), "force on the cochlear partition not recorded");
  EXPECT_FALSE(none.isBeyond);
}

TEST(WordsOfAForceOnThePartition, SayWhereItRupturedAndWhatIsAboveIt)
{
  haptics::Translocation rupture{1.0285, 0.042, 12.98e-3, 0.0};
  EXPECT_EQ(meaningOfRupture(rupture).text.toStdString(),
            "cochlear partition ruptured at 59° by 42 mN");
  EXPECT_TRUE(meaningOfRupture(rupture).isBeyond);
  rupture.lengthAbove = 7.3e-3;
  EXPECT_EQ(meaningOfRupture(rupture).text.toStdString(),
            "translocation: partition ruptured at 59° by 42 mN, 7.3 mm above it");
}

TEST(WordsOfAForceOnThePartition, MarkTheRuptureForcesAsAssumed)
{
  const std::string source = ForceThresholds::shipped().rupture->source;
  EXPECT_THAT(source, HasSubstr("Schuster et al. 2015"));
  EXPECT_THAT(source, HasSubstr("assumption: original not available"));
  EXPECT_THAT(source, Not(HasSubstr("memory")));
  EXPECT_THAT(onPartition(200.0), HasSubstr("assumed rupture forces"));
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
