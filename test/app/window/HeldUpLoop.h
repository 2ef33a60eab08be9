// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// A haptic loop that is held up while the window hears of a stop: how many of its ticks pass before
// the force has ended does not depend on how busy the machine is.

#include <atomic>
#include <ctime>
#include <memory>
#include <thread>

#include "PushedDevice.h"

namespace perilymph::test {

/// The device's force around a stop. Use in the window's thread.
class HeldUpLoop {
public:
  /// Ticks from the stop to the last force, at most: with the millisecond before the first of them,
  /// five milliseconds of the loop's time.
  static constexpr std::size_t maxTicks = 4;

  explicit HeldUpLoop(std::shared_ptr<ForceLog> log);
  ~HeldUpLoop();  ///< Lets the loop go on.
  HeldUpLoop(const HeldUpLoop&) = delete;
  HeldUpLoop& operator=(const HeldUpLoop&) = delete;

  /// Holds the loop up in a read. False if it is not in one within half a minute.
  [[nodiscard]] bool begin();

  /// The window hears of a stop; the first time counts. The loop goes on as soon as the window has used
  /// a millisecond of processor time or has handled the event. A busy machine may keep the window waiting
  /// far longer than that. A window that waits for its loop gets it back after ten seconds.
  void setTone();
  /// When it heard, monotonic [ns]; 0 before.
  std::int64_t heardAt() const { return heardAt_; }

  /// The window has handled the event: blocks its thread until the device was told 50 forces from a
  /// time on, monotonic [ns]. False if it was not within half a minute.
  [[nodiscard]] bool block(std::int64_t due);

  /// Expects the largest force before a time, none after `maxTicks` ticks, and none later. Prints
  /// what was measured.
  /// @param due  When the force has to end, monotonic [ns].
  void expectStop(const char* way, std::int64_t due) const;

private:
  std::shared_ptr<ForceLog> log_;
  std::int64_t heardAt_ = 0;
  std::atomic<bool> isHandled_{false};
  std::size_t entriesBefore_ = 0;  // that the loop had written when it was held up
  clockid_t windowClock_{};        // processor time of the window's thread
  std::thread release_;
};

}  // namespace perilymph::test
