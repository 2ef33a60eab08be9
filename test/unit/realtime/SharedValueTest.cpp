// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/realtime/SharedValue.h"

#include <gtest/gtest.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <new>
#include <thread>

#include "perilymph/test/waitUntil.h"

namespace perilymph::realtime {
namespace {

/// Two values of which the second follows from the first.
struct Pair {
  std::uint64_t number = 0;
  std::array<std::uint64_t, 12> copies{};

  static Pair of(std::uint64_t number)
  {
    Pair pair{number, {}};
    pair.copies.fill(number * 3);
    return pair;
  }
  bool isWhole() const
  {
    for (const std::uint64_t copy : copies)
      if (copy != number * 3) return false;
    return true;
  }
};

TEST(SharedValue, IsTakenOnceAndAgainWhenItIsNew)
{
  SharedValue<Pair> channel;
  Pair taken;
  std::uint64_t seen = 0;
  EXPECT_FALSE(channel.take(taken, seen));
  channel.publish(Pair::of(7));
  ASSERT_TRUE(channel.take(taken, seen));
  EXPECT_EQ(taken.number, 7u);
  EXPECT_FALSE(channel.take(taken, seen));
  channel.publish(Pair::of(8));
  channel.publish(Pair::of(9));
  ASSERT_TRUE(channel.take(taken, seen));
  EXPECT_EQ(taken.number, 9u);
}

TEST(SharedValue, ArrivesWholeWhileItIsOverwritten)
{
  constexpr std::uint64_t last = 200'000;
  SharedValue<Pair> channel;
  std::thread writer([&] {
    for (std::uint64_t i = 1; i <= last; ++i) channel.publish(Pair::of(i));
  });
  Pair taken;
  std::uint64_t seen = 0, before = 0;
  bool isOrdered = true, isWhole = true;
  const bool ended = test::waitUntil([&] {
    if (!channel.take(taken, seen)) return false;
    isOrdered = isOrdered && taken.number > before;
    isWhole = isWhole && taken.isWhole();
    before = taken.number;
    return before == last;
  });
  writer.join();
  EXPECT_TRUE(ended);
  EXPECT_TRUE(isOrdered);
  EXPECT_TRUE(isWhole);
}

TEST(SharedValue, CrossesProcesses)
{
  using Channel = SharedValue<Pair>;
  void* const place =
      ::mmap(nullptr, sizeof(Channel), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  ASSERT_NE(place, MAP_FAILED);
  auto* const channel = new (place) Channel;
  const pid_t child = ::fork();
  if (child == 0) {
    channel->publish(Pair::of(5));
    ::_exit(0);
  }
  ASSERT_EQ(::waitpid(child, nullptr, 0), child);
  Pair taken;
  std::uint64_t seen = 0;
  EXPECT_TRUE(channel->take(taken, seen));
  EXPECT_EQ(taken.number, 5u);
  ::munmap(place, sizeof(Channel));
}

TEST(SharedValue, IsNotTakenFromAWriterThatDiedWhileItWrote)
{
  SharedValue<Pair> channel;
  channel.publish(Pair::of(1));
  // The counter is the first member; a writer that died leaves it odd.
  std::uint64_t odd = 3;
  std::memcpy(static_cast<void*>(&channel), &odd, sizeof odd);
  Pair taken;
  std::uint64_t seen = 2;
  EXPECT_FALSE(channel.take(taken, seen));
  channel.publish(Pair::of(2));
  EXPECT_TRUE(channel.take(taken, seen));
  EXPECT_EQ(taken.number, 2u);
}

}  // namespace
}  // namespace perilymph::realtime
