// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Wakes a sleeping thread from one that must not wait.

#include <semaphore.h>
#include <time.h>

#include <atomic>
#include <cerrno>
#include <cstdint>

namespace perilymph::realtime {

/// Whose memory a channel is in.
enum class Sharing {
  threads,    ///< One process.
  processes,  ///< Memory that two processes share.
};

/// One thread sleeps until another rings. Rings while nobody sleeps count as
/// one. A ring never blocks and enters the kernel only to wake a sleeper.
class Doorbell {
public:
  explicit Doorbell(Sharing sharing = Sharing::threads) noexcept
  {
    sem_init(&bell_, sharing == Sharing::processes ? 1 : 0, 0);
  }
  ~Doorbell() { sem_destroy(&bell_); }
  Doorbell(const Doorbell&) = delete;
  Doorbell& operator=(const Doorbell&) = delete;

  /// Wakes the sleeping thread. Any thread. Real-time safe.
  void ring() noexcept
  {
    if (!isRung_.exchange(true, std::memory_order_acq_rel)) sem_post(&bell_);
  }

  /// Sleeps until a ring, at most until `deadline` on the monotonic clock [ns].
  /// False on timeout. One thread only.
  bool waitUntil(std::int64_t deadline) noexcept
  {
    constexpr std::int64_t second = 1'000'000'000;
    timespec until{};
    until.tv_sec = static_cast<time_t>(deadline / second);
    until.tv_nsec = static_cast<long>(deadline % second);
    while (sem_clockwait(&bell_, CLOCK_MONOTONIC, &until) != 0) {
      if (errno != EINTR) return false;
    }
    // Acquire: what was written before the ring is visible after it.
    isRung_.exchange(false, std::memory_order_acq_rel);
    return true;
  }

private:
  sem_t bell_;
  std::atomic<bool> isRung_{false};
};

}  // namespace perilymph::realtime
