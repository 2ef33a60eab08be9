// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/analysis/PhysicalRanges.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

namespace perilymph::analysis {
namespace {

using testing::HasSubstr;

InsertionRun possible()
{
  InsertionRun insertion;
  insertion.end = InsertionEnd::finished;
  insertion.depth = insertion.maxDepth = millimeters(25.0);
  insertion.apical = degrees(540.0);
  insertion.peak = {millimeters(24.0), millinewtons(60.0)};
  insertion.contacts.resize(1);
  insertion.profile = {{millimeters(1.0), millinewtons(2.0)}};
  return insertion;
}

TEST(PhysicalRanges, NameTheFirstValueThatIsOutOfThem)
{
  EXPECT_EQ(impossibility(possible()), "");
  InsertionRun other = possible();
  other.peak.force = millinewtons(-5000.0);
  EXPECT_EQ(impossibility(other), "the peak force is -5000 mN; 0 to 2000 is possible");
  other = possible();
  other.apical = radians(9e8);
  EXPECT_THAT(impossibility(other), HasSubstr("the angle is"));
  other = possible();
  other.partition = newtons(std::numeric_limits<double>::quiet_NaN());
  EXPECT_THAT(impossibility(other), HasSubstr("the force on the partition is nan"));
  other = possible();
  other.profile[0].force = newtons(-2.5);
  EXPECT_THAT(impossibility(other), HasSubstr("a force is"));
  other = possible();
  other.contacts[0].depth = millimeters(99.0);
  EXPECT_THAT(impossibility(other), HasSubstr("the depth of a contact is"));
}

TEST(PhysicalRanges, LimitTheForceOfAnArrayThatJammed)
{
  // it jammed because it exceeded 2 N: that is all that its peak says
  InsertionRun jammed = possible();
  jammed.end = InsertionEnd::jammed;
  jammed.peak.force = newtons(2.3);
  jammed.endForce = newtons(2.3);
  const InsertionRun kept = asPossible(jammed);
  EXPECT_EQ(kept.end, InsertionEnd::jammed);
  EXPECT_NEAR(kept.peak.force.si(), 2.0, 1e-12);
  EXPECT_EQ(kept.peak.depth, jammed.peak.depth);
  EXPECT_EQ(impossibility(kept), "");
}

TEST(PhysicalRanges, KeepNoInsertionThatIsImpossible)
{
  InsertionRun other = possible();
  other.peak.force = newtons(41.0);
  const InsertionRun kept = asPossible(other);
  EXPECT_EQ(kept.end, InsertionEnd::refused);
  EXPECT_EQ(kept.peak.force.si(), 0.0);
  EXPECT_THAT(kept.reason, HasSubstr("the peak force is 41000 mN"));
  EXPECT_EQ(asPossible(possible()).peak.force, possible().peak.force);
}

}  // namespace
}  // namespace perilymph::analysis
