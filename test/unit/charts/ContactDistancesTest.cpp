// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/charts/ContactDistances.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "RingScala.h"

namespace perilymph::charts {
namespace {

constexpr double smoothing_mm = 0.01;  // interpolation of the wall between directions

std::vector<ContactDistance> distances(const haptics::Snapshot& now)
{
  ArrayInScala array(*test::ringScala(), test::plainArray());
  array.follow(now);
  return contactDistances(array);
}

TEST(ContactDistances, IsTheChordOfTheRoundSectionAtTheContactsHeight)
{
  const double across_mm = 0.4, up_mm = 0.5;
  const auto contacts = distances(test::laidTo(300.0, across_mm, up_mm));
  ASSERT_EQ(contacts.size(), 2u);
  const double toWall_mm = across_mm + std::sqrt(test::lumen_mm * test::lumen_mm - up_mm * up_mm);
  for (const ContactDistance& contact : contacts) {
    EXPECT_TRUE(contact.isInside);
    EXPECT_NEAR(contact.toInnerWall_mm, toWall_mm, smoothing_mm);
  }
}

TEST(ContactDistances, KnowsTheContactsAngles)
{
  // 20 mm of array over 300 degrees: the contact 2 mm from the tip is 30 degrees behind it
  EXPECT_NEAR(distances(test::laidTo(300.0, 0.0)).front().angle_deg, 270.0, 0.1);
}

TEST(ContactDistances, AreNegativeForAContactBeyondTheWall)
{
  EXPECT_LT(distances(test::laidTo(300.0, 0.0, 1.3)).front().toInnerWall_mm, 0.0);
}

TEST(ContactDistances, CountToTheInnerWallWhereTheArrayIsPressedPastTheOuterOne)
{
  const double past_mm = test::lumen_mm + 0.05;
  for (const ContactDistance& contact : distances(test::laidTo(300.0, past_mm)))
    EXPECT_NEAR(contact.toInnerWall_mm, past_mm + test::lumen_mm, smoothing_mm);
}

TEST(ContactDistances, AreNegativeForAContactBeyondTheInnerWall)
{
  EXPECT_LT(distances(test::laidTo(300.0, -1.1)).front().toInnerWall_mm, 0.0);
}

TEST(ContactDistances, HasNoneWithoutAnArray)
{
  haptics::Snapshot none{};
  for (const ContactDistance& contact : distances(none)) EXPECT_FALSE(contact.isInside);
}

TEST(ContactDistances, AreNotMeasuredAboveThePartition)
{
  haptics::Snapshot now = test::laidTo(300.0, 0.4);
  // the last 4 mm of 20: the contact 2 mm from the tip, not the next one
  for (std::size_t i = 81; i < test::ringNodes; ++i) now.isAbove.set(i);
  const auto contacts = distances(now);
  ASSERT_EQ(contacts.size(), 2u);
  EXPECT_TRUE(contacts[0].isInside && contacts[0].isAbove);
  EXPECT_LT(contacts[0].toInnerWall_mm, 0.0);
  EXPECT_FALSE(contacts[1].isAbove);
  EXPECT_GT(contacts[1].toInnerWall_mm, 0.0);
}

bool isSaid(const std::vector<ContactDistance>& contacts, const std::string& text)
{
  const figures::Drawing drawing = drawContactDistances(contacts, 400.0, 180.0);
  return std::ranges::any_of(drawing.marks, [&](const figures::Mark& mark) {
    const auto* label = std::get_if<figures::Label>(&mark);
    return label != nullptr && label->text == text;
  });
}

TEST(ContactDistances, ThoseAboveThePartitionAreCountedApart)
{
  EXPECT_TRUE(isSaid({{true, 90.0, -1.0, true}, {true, 80.0, 1.0}},
                     "mean 1.00 mm, 1 below the partition, 1 above"));
  EXPECT_TRUE(isSaid({{true, 90.0, -1.0, true}}, "1 above the partition"));
}

TEST(ContactDistances, TheirMeanIsWrittenOverThem)
{
  const std::vector<ContactDistance> contacts{
      {true, 90.0, 0.5}, {true, 80.0, 1.0}, {false, 0.0, -1.0}};
  EXPECT_TRUE(isSaid(contacts, "mean 0.75 mm, 2 inserted"));
}

}  // namespace
}  // namespace perilymph::charts
