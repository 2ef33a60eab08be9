// SPDX-License-Identifier: BSD-3-Clause

// Waking a thread, and lending an object to another thread. Also run with the thread sanitizer.

#include <gtest/gtest.h>

#include <cstdint>
#include <limits>
#include <thread>

#include "perilymph/realtime/Doorbell.h"
#include "perilymph/realtime/Handoff.h"
#include "perilymph/realtime/Pacer.h"
#include "perilymph/test/waitUntil.h"

namespace perilymph::realtime {
namespace {

constexpr std::int64_t never = std::numeric_limits<std::int64_t>::max() / 2;  // [ns]

TEST(DoorbellBetweenThreads, IsHeardWithAllThatWasDoneBefore)
{
  Doorbell thither, back;
  std::uint64_t value = 0;  // synchronized by the doorbells only
  std::thread other([&] {
    for (int i = 0; i < 2'000; ++i) {
      thither.waitUntil(never);
      ++value;
      back.ring();
    }
  });
  for (std::uint64_t i = 0; i < 2'000; ++i) {
    ASSERT_EQ(value, i);
    thither.ring();
    back.waitUntil(never);
  }
  other.join();
}

TEST(Doorbell, RemembersManyRingsAsOne)
{
  Doorbell bell;
  for (int i = 0; i < 5; ++i) bell.ring();
  EXPECT_TRUE(bell.waitUntil(never));
  EXPECT_FALSE(bell.waitUntil(monotonicNanoseconds()));
}

TEST(Doorbell, EndsItsWaitWhenTheTimeIsUp)
{
  Doorbell bell;
  EXPECT_FALSE(bell.waitUntil(monotonicNanoseconds() + 1000));
  bell.ring();
  EXPECT_TRUE(bell.waitUntil(0));
}

/// Counts its instances.
struct Counted {
  explicit Counted(int& count) : alive(count) { ++alive; }
  ~Counted() { --alive; }
  Counted(const Counted&) = delete;
  Counted& operator=(const Counted&) = delete;
  int& alive;
  std::uint64_t uses = 0;  // by one thread at a time
};

TEST(HandoffBetweenThreads, LendsAndGetsBackEveryOne)
{
  Handoff<Counted> handoff;
  int alive = 0;  // only the owner's thread creates and destroys
  std::uint64_t uses = 0;
  std::thread user([&handoff] {
    for (int lent = 0; lent < 1000; ++lent) {
      Counted* one = nullptr;
      if (!test::waitUntil([&] { return (one = handoff.take()) != nullptr; })) return;
      ++one->uses;
      handoff.giveBack(one);
    }
  });
  for (int i = 0; i < 1000; ++i) {
    handoff.offer(std::make_unique<Counted>(alive));
    std::unique_ptr<Counted> back;
    if (!test::waitUntil([&] { return (back = handoff.reclaim()) != nullptr; })) break;
    uses += back->uses;
  }
  user.join();
  EXPECT_EQ(uses, 1000u);
  EXPECT_EQ(alive, 0);
}

TEST(Handoff, DestroysWhatWasNeverTaken)
{
  int alive = 0;
  {
    Handoff<Counted> handoff;
    handoff.offer(std::make_unique<Counted>(alive));
    handoff.offer(std::make_unique<Counted>(alive));
    EXPECT_EQ(alive, 1);
    EXPECT_NE(handoff.withdraw(), nullptr);
    EXPECT_EQ(handoff.take(), nullptr);
    handoff.offer(std::make_unique<Counted>(alive));
    handoff.giveBack(handoff.take());
  }
  EXPECT_EQ(alive, 0);
}

}  // namespace
}  // namespace perilymph::realtime
