// SPDX-License-Identifier: BSD-3-Clause
#include "virtual/ReplayDevice.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace perilymph::device {
namespace {

std::vector<DeviceSample> threeSamples()
{
  std::vector<DeviceSample> samples(3);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    samples[i].sequence = 10 + i;
    samples[i].position_D[2] = -1e-3 * static_cast<double>(i);
    samples[i].isValid = i == 1 ? 0u : 1u;  // an invalid sample
  }
  return samples;
}

TEST(ReplayDevice, GivesTheSamplesAsTheyWereFaultsIncluded)
{
  ReplayDevice hand(threeSamples(), 1e-3);
  ASSERT_TRUE(hand.open());
  for (const DeviceSample& recorded : threeSamples()) {
    const DeviceSample played = hand.read();
    EXPECT_EQ(played.sequence, recorded.sequence);
    EXPECT_EQ(played.position_D, recorded.position_D);
    EXPECT_EQ(played.isValid, recorded.isValid);
  }
  EXPECT_TRUE(hand.isOver());
}

TEST(ReplayDevice, GivesNothingFreshOnceItIsOver)
{
  ReplayDevice hand(threeSamples(), 1e-3);
  ASSERT_TRUE(hand.open());
  for (int i = 0; i < 3; ++i) hand.read();
  EXPECT_EQ(hand.read().sequence, 12u);
  EXPECT_EQ(hand.read().sequence, 12u);
}

TEST(ReplayDevice, SaysThatThereIsNothingToPlay)
{
  ReplayDevice hand({}, 1e-3);
  const Result<void> opened = hand.open();
  ASSERT_FALSE(opened);
  EXPECT_NE(opened.error().message.find("no samples"), std::string::npos);
  EXPECT_EQ(hand.read().isValid, 0u);
}

}  // namespace
}  // namespace perilymph::device
