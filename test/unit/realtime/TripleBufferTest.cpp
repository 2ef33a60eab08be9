// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/realtime/TripleBuffer.h"

#include <gtest/gtest.h>

namespace perilymph::realtime {
namespace {

TEST(TripleBuffer, HasNothingFreshBeforeTheFirstPublication)
{
  TripleBuffer<int> buffer;
  EXPECT_FALSE(buffer.refresh());
}

TEST(TripleBuffer, GivesEachValueOnce)
{
  TripleBuffer<int> buffer;
  buffer.publish(7);
  EXPECT_TRUE(buffer.refresh());
  EXPECT_EQ(buffer.latest(), 7);
  EXPECT_FALSE(buffer.refresh());
  EXPECT_EQ(buffer.latest(), 7);
}

TEST(TripleBuffer, DropsAllButTheNewest)
{
  TripleBuffer<int> buffer;
  for (int i = 1; i <= 10; ++i) buffer.publish(i);
  ASSERT_TRUE(buffer.refresh());
  EXPECT_EQ(buffer.latest(), 10);
}

TEST(TripleBuffer, KeepsTheReadersValueInPlaceWhileTheWriterGoesOn)
{
  TripleBuffer<int> buffer;
  buffer.publish(1);
  ASSERT_TRUE(buffer.refresh());
  for (int i = 2; i <= 10; ++i) buffer.publish(i);
  EXPECT_EQ(buffer.latest(), 1);
}

TEST(TripleBuffer, PublishesADraftBuiltInPlace)
{
  TripleBuffer<std::array<int, 4>> buffer;
  buffer.draft() = {1, 2, 3, 4};
  EXPECT_FALSE(buffer.refresh());
  buffer.publishDraft();
  ASSERT_TRUE(buffer.refresh());
  EXPECT_EQ(buffer.latest(), (std::array<int, 4>{1, 2, 3, 4}));
}

}  // namespace
}  // namespace perilymph::realtime
