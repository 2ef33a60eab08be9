// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Channel between two processes for values of which only the newest matters.

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <type_traits>

namespace perilymph::realtime {

/// Passes the newest value from one writer to one reader through memory that
/// two processes share. Neither side ever blocks. It holds no index or pointer:
/// a process that overwrites it can falsify values, but cannot make the other
/// one access other memory, and a writer that dies while it writes leaves no
/// value.
///
/// A counter is odd while the value is written (a sequence lock); the value is
/// stored in atomic words, so that reading it meanwhile is defined.
template <class Value>
class SharedValue {
  static_assert(std::is_trivially_copyable_v<Value>, "a value crosses processes byte by byte");
  static_assert(std::atomic<std::uint64_t>::is_always_lock_free);

public:
  /// Makes `value` the newest. Writer only. Real-time safe.
  void publish(const Value& value) noexcept
  {
    std::array<std::uint64_t, words> copy{};
    std::memcpy(copy.data(), &value, sizeof value);
    const std::uint64_t before = counter_.load(std::memory_order_relaxed) & ~std::uint64_t{1};
    counter_.store(before + 1, std::memory_order_relaxed);
    // Release: a reader that finds one of these words finds the odd counter.
    for (std::size_t i = 0; i < words; ++i) word_[i].store(copy[i], std::memory_order_release);
    counter_.store(before + 2, std::memory_order_release);
  }

  /// Takes the newest value. False if it was already taken, or is being
  /// written.
  ///
  /// @param seen  The reader's own memory of what it took; 0 at first.
  bool take(Value& value, std::uint64_t& seen) const noexcept
  {
    std::array<std::uint64_t, words> copy{};
    for (int i = 0; i < maxAttempts; ++i) {
      const std::uint64_t before = counter_.load(std::memory_order_acquire);
      if (before == seen || (before & 1) != 0) return false;
      for (std::size_t k = 0; k < words; ++k) copy[k] = word_[k].load(std::memory_order_acquire);
      if (counter_.load(std::memory_order_relaxed) != before) continue;
      seen = before;
      std::memcpy(static_cast<void*>(&value), copy.data(), sizeof value);
      return true;
    }
    return false;
  }

private:
  static constexpr std::size_t words = (sizeof(Value) + 7) / 8;
  // The writer overtakes a reader once a period, not three times while 100
  // bytes are copied.
  static constexpr int maxAttempts = 3;

  alignas(64) std::atomic<std::uint64_t> counter_{0};
  std::array<std::atomic<std::uint64_t>, words> word_{};
};

}  // namespace perilymph::realtime
