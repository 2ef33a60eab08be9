// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Channel for objects that one thread creates and destroys and another uses.

#include <atomic>
#include <memory>

namespace perilymph::realtime {

/// Lends one object at a time from its owner's thread to a user's thread and back. Neither side
/// ever blocks, and the user's side neither allocates nor frees.
template <class Value>
class Handoff {
public:
  Handoff() = default;
  /// Call when both threads have ended or no longer use it.
  ~Handoff()
  {
    delete offered_.load(std::memory_order_relaxed);
    delete returned_.load(std::memory_order_relaxed);
  }
  Handoff(const Handoff&) = delete;
  Handoff& operator=(const Handoff&) = delete;

  /// Offers an object to the user. An object still on offer is replaced and destroyed. Owner's
  /// thread only.
  void offer(std::unique_ptr<Value> value) noexcept
  {
    delete offered_.exchange(value.release(), std::memory_order_acq_rel);
  }

  /// Takes back an offered object that was not taken. Owner's thread only.
  std::unique_ptr<Value> withdraw() noexcept
  {
    return std::unique_ptr<Value>(offered_.exchange(nullptr, std::memory_order_acq_rel));
  }

  /// Takes the object that the user gave back; null if there is none. Owner's thread only.
  std::unique_ptr<Value> reclaim() noexcept
  {
    return std::unique_ptr<Value>(returned_.exchange(nullptr, std::memory_order_acq_rel));
  }

  /// Takes the offered object; null if there is none. The user gives back its previous object
  /// before it takes another. User's thread only. Real-time safe.
  Value* take() noexcept
  {
    if (offered_.load(std::memory_order_relaxed) == nullptr) return nullptr;
    return offered_.exchange(nullptr, std::memory_order_acq_rel);
  }

  /// Gives an object back to its owner; the user must not access it again. Give each object back
  /// once, and only after the previous one was reclaimed. User's thread only. Real-time safe.
  void giveBack(Value* value) noexcept { returned_.store(value, std::memory_order_release); }

private:
  std::atomic<Value*> offered_{nullptr};
  std::atomic<Value*> returned_{nullptr};
};

}  // namespace perilymph::realtime
