// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Queue for values that must all arrive: records for the file, commands for the loop.

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <span>
#include <stdexcept>
#include <type_traits>
#include <vector>

namespace perilymph::realtime {

/// A queue of fixed capacity from one writer thread to one reader thread. Values arrive complete
/// and in order. Neither side ever blocks: push() fails if the ring is full, take() if it is empty.
template <class Value>
class SpscRing {
  static_assert(std::is_trivially_copyable_v<Value>, "push() must not allocate or throw");

public:
  /// @param capacity  Capacity [values], 1 or more. All memory is allocated here.
  explicit SpscRing(std::size_t capacity) : slots_(capacity)
  {
    if (capacity == 0) throw std::invalid_argument("A ring of 0 values holds nothing; give it 1.");
  }

  std::size_t capacity() const noexcept { return slots_.size(); }
  /// Where the values lie, to be locked in RAM.
  std::span<const std::byte> memory() const noexcept { return std::as_bytes(std::span(slots_)); }

  /// Appends a value. False if the ring is full. Writer thread only. Real-time safe.
  bool push(const Value& value) noexcept
  {
    const std::uint64_t at = written_.load(std::memory_order_relaxed);
    if (at - readSeen_ == slots_.size()) {
      readSeen_ = read_.load(std::memory_order_acquire);
      if (at - readSeen_ == slots_.size()) return false;
    }
    slots_[at % slots_.size()] = value;
    written_.store(at + 1, std::memory_order_release);
    return true;
  }

  /// Takes the oldest value. False if there is none. Reader thread only. Real-time safe.
  bool take(Value& value) noexcept
  {
    const std::uint64_t at = read_.load(std::memory_order_relaxed);
    if (at == writtenSeen_) {
      writtenSeen_ = written_.load(std::memory_order_acquire);
      if (at == writtenSeen_) return false;
    }
    value = slots_[at % slots_.size()];
    read_.store(at + 1, std::memory_order_release);
    return true;
  }

private:
  std::vector<Value> slots_;
  alignas(64) std::atomic<std::uint64_t> written_{0};  // number of values ever written
  alignas(64) std::uint64_t readSeen_ = 0;             // the writer's last read of read_
  alignas(64) std::atomic<std::uint64_t> read_{0};     // number of values ever read
  alignas(64) std::uint64_t writtenSeen_ = 0;          // the reader's last read of written_
};

}  // namespace perilymph::realtime
