// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Channel for values of which only the newest matters, such as pictures for the screen.

#include <array>
#include <atomic>
#include <cstdint>
#include <type_traits>

namespace perilymph::realtime {

/// Passes the newest value from one writer thread to one reader thread. Neither side ever blocks;
/// values that the reader does not take in time are dropped.
template <class Value>
class TripleBuffer {
  static_assert(std::is_trivially_copyable_v<Value>, "publish() must not allocate or throw");

public:
  /// Makes `value` the newest. Writer thread only. Real-time safe.
  void publish(const Value& value) noexcept
  {
    draft() = value;
    publishDraft();
  }

  /// The value the writer may build in place, for values too large to copy each tick. It holds an
  /// older value, a different one after each publication. Writer thread only.
  Value& draft() noexcept { return slots_[back_]; }

  /// Makes the draft the newest. Writer thread only. Real-time safe.
  void publishDraft() noexcept
  {
    const auto offered = static_cast<std::uint8_t>(back_ | isFresh);
    back_ = middle_.exchange(offered, std::memory_order_acq_rel) & slotMask;
  }

  /// Takes the newest value if the reader has not taken it yet. Reader thread only.
  bool refresh() noexcept
  {
    if ((middle_.load(std::memory_order_relaxed) & isFresh) == 0) return false;
    front_ = middle_.exchange(front_, std::memory_order_acq_rel) & slotMask;
    return true;
  }

  /// The value that the last refresh() took; unchanged until the next one. Reader thread only.
  const Value& latest() const noexcept { return slots_[front_]; }

private:
  static constexpr std::uint8_t slotMask = 0b011;
  static constexpr std::uint8_t isFresh = 0b100;

  std::array<Value, 3> slots_{};
  alignas(64) std::atomic<std::uint8_t> middle_{1};
  alignas(64) std::uint8_t back_ = 0;   // owned by the writer
  alignas(64) std::uint8_t front_ = 2;  // owned by the reader
};

}  // namespace perilymph::realtime
