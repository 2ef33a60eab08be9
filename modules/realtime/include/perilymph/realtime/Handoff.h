#pragma once

// The channel for things that are made and destroyed by one thread and used by another.

#include <atomic>
#include <memory>

#include "perilymph/foundation/RealTime.h"

namespace perilymph::realtime {

/// Lends one object at a time from its owner's thread to a user's thread and back. Neither side
/// ever waits, and the user's side neither allocates nor frees.
template <class Value>
class Handoff {
public:
  Handoff() = default;
  /// Both threads have ended, or use it no longer.
  ~Handoff()
  {
    delete offered_.load(std::memory_order_relaxed);
    delete returned_.load(std::memory_order_relaxed);
  }
  Handoff(const Handoff&) = delete;
  Handoff& operator=(const Handoff&) = delete;

  /// Offers an object to the user. One that is still on offer is replaced and destroyed.
  /// Owner's thread only.
  void offer(std::unique_ptr<Value> value) noexcept
  {
    delete offered_.exchange(value.release(), std::memory_order_acq_rel);
  }

  /// Takes back what was offered and never taken. Owner's thread only.
  std::unique_ptr<Value> withdraw() noexcept
  {
    return std::unique_ptr<Value>(offered_.exchange(nullptr, std::memory_order_acq_rel));
  }

  /// Takes what the user gave back; nothing if it gave nothing back. Owner's thread only.
  std::unique_ptr<Value> reclaim() noexcept
  {
    return std::unique_ptr<Value>(returned_.exchange(nullptr, std::memory_order_acq_rel));
  }

  /// Takes what is on offer; null if nothing is. The user gives back what it had before it takes
  /// another. User's thread only. Real-time safe.
  PERILYMPH_REALTIME Value* take() noexcept
  {
    if (offered_.load(std::memory_order_relaxed) == nullptr) return nullptr;
    return offered_.exchange(nullptr, std::memory_order_acq_rel);
  }

  /// Gives an object back to its owner; the user does not touch it again. Each only once, and only
  /// after the one before was reclaimed. User's thread only. Real-time safe.
  PERILYMPH_REALTIME void giveBack(Value* value) noexcept
  {
    returned_.store(value, std::memory_order_release);
  }

private:
  std::atomic<Value*> offered_{nullptr};
  std::atomic<Value*> returned_{nullptr};
};

}  // namespace perilymph::realtime
