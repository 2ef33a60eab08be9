// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/realtime/SpscRing.h"

#include <gtest/gtest.h>

#include <deque>
#include <random>

namespace perilymph::realtime {
namespace {

TEST(SpscRing, GivesValuesInTheOrderTheyCame)
{
  SpscRing<int> ring(4);
  for (int i = 0; i < 4; ++i) ASSERT_TRUE(ring.push(i));
  for (int i = 0; i < 4; ++i) {
    int value = -1;
    ASSERT_TRUE(ring.take(value));
    EXPECT_EQ(value, i);
  }
}

TEST(SpscRing, RefusesWhenFullAndKeepsWhatItHas)
{
  SpscRing<int> ring(2);
  ASSERT_TRUE(ring.push(1));
  ASSERT_TRUE(ring.push(2));
  EXPECT_FALSE(ring.push(3));
  int value = 0;
  ASSERT_TRUE(ring.take(value));
  EXPECT_EQ(value, 1);
  EXPECT_TRUE(ring.push(4));
}

TEST(SpscRing, LeavesTheReadersValueAloneWhenEmpty)
{
  SpscRing<int> ring(2);
  int value = 42;
  EXPECT_FALSE(ring.take(value));
  EXPECT_EQ(value, 42);
}

TEST(SpscRing, BehavesLikeABoundedQueueUnderAnyMixOfPushAndTake)
{
  SpscRing<int> ring(5);
  std::deque<int> queue;  // the oracle
  std::mt19937 random(1);
  for (int i = 0; i < 20'000; ++i) {
    if (random() % 2 == 0) {
      const bool fits = queue.size() < ring.capacity();
      ASSERT_EQ(ring.push(i), fits);
      if (fits) queue.push_back(i);
    } else {
      int value = -1;
      ASSERT_EQ(ring.take(value), !queue.empty());
      if (queue.empty()) continue;
      ASSERT_EQ(value, queue.front());
      queue.pop_front();
    }
  }
}

TEST(SpscRing, RefusesToBeBuiltForNothing)
{
  EXPECT_THROW(SpscRing<int>(0), std::invalid_argument);
}

}  // namespace
}  // namespace perilymph::realtime
