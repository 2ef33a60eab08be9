// SPDX-License-Identifier: BSD-3-Clause

// Each channel between two threads at full speed. Also run with the thread sanitizer.

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <thread>

#include "perilymph/realtime/SpscRing.h"
#include "perilymph/realtime/TripleBuffer.h"
#include "perilymph/test/waitUntil.h"

namespace perilymph::realtime {
namespace {

/// Large enough to be torn if it were copied during a write.
struct Wide {
  std::array<std::uint64_t, 64> words{};

  static Wide of(std::uint64_t number)
  {
    Wide wide;
    wide.words.fill(number);
    return wide;
  }
  bool isWhole() const
  {
    for (const std::uint64_t word : words)
      if (word != words[0]) return false;
    return true;
  }
};

constexpr std::uint64_t values = 200'000;

TEST(TripleBufferBetweenThreads, GivesWholeValuesThatNeverGoBack)
{
  TripleBuffer<Wide> buffer;
  std::thread writer([&buffer] {
    for (std::uint64_t i = 1; i <= values; ++i) buffer.publish(Wide::of(i));
  });
  std::uint64_t last = 0, torn = 0, backward = 0;
  while (last < values) {
    if (!test::waitUntil([&] { return buffer.refresh(); })) break;  // a lost newest value
    if (!buffer.latest().isWhole()) ++torn;
    if (buffer.latest().words[0] <= last) ++backward;
    last = buffer.latest().words[0];
  }
  writer.join();
  EXPECT_EQ(torn, 0u);
  EXPECT_EQ(backward, 0u);
  EXPECT_EQ(last, values);  // the newest value always arrives
}

TEST(SpscRingBetweenThreads, GivesEveryValueWholeAndInOrder)
{
  SpscRing<Wide> ring(8);
  std::thread writer([&ring] {
    for (std::uint64_t i = 1; i <= values; ++i)
      if (!test::waitUntil([&] { return ring.push(Wide::of(i)); })) return;
  });
  std::uint64_t torn = 0, misplaced = 0;
  for (std::uint64_t i = 1; i <= values; ++i) {
    Wide value;
    if (!test::waitUntil([&] { return ring.take(value); })) break;
    if (!value.isWhole()) ++torn;
    if (value.words[0] != i) ++misplaced;
  }
  writer.join();
  EXPECT_EQ(torn, 0u);
  EXPECT_EQ(misplaced, 0u);
}

TEST(SpscRingBetweenThreads, LosesExactlyWhatItRefused)
{
  SpscRing<std::uint64_t> ring(64);
  std::uint64_t refused = 0;
  std::thread writer([&] {
    for (std::uint64_t i = 1; i <= values; ++i)
      if (!ring.push(i)) ++refused;
    EXPECT_TRUE(test::waitUntil([&] { return ring.push(0); }));  // end marker
  });
  std::uint64_t taken = 0, last = 0, misplaced = 0;
  EXPECT_TRUE(test::waitUntil([&] {
    std::uint64_t value = 0;
    if (!ring.take(value)) return false;
    if (value == 0) return true;
    if (value <= last) ++misplaced;
    last = value;
    ++taken;
    return false;
  }));
  writer.join();
  EXPECT_EQ(taken + refused, values);
  EXPECT_EQ(misplaced, 0u);
}

}  // namespace
}  // namespace perilymph::realtime
