// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The haptic loop: device input, tick, device output; one thread, which exchanges values by channels and atomics.

#include <cstdint>
#include <memory>

#include "perilymph/device/HapticDevice.h"
#include "perilymph/foundation/Result.h"
#include "perilymph/haptics/InsertionEngine.h"
#include "perilymph/haptics/Snapshot.h"
#include "perilymph/realtime/LockedMemory.h"

namespace perilymph::haptics {

/// Timing statistics of the loop since its start.
struct LoopStatistics {
  std::uint64_t ticks = 0;
  std::uint64_t lateTicks = 0;    ///< Began more than one period late.
  std::uint64_t missedTicks = 0;  ///< Never took place: the thread was blocked for too long.
  std::uint64_t overruns = 0;     ///< Took longer than one period.
  std::uint64_t lostRecords = 0;
  double tickTimeMedian = 0.0;       ///< [s]
  double tickTimeP99 = 0.0;          ///< [s]
  double tickTimeMax = 0.0;          ///< [s]
  bool hasRealTimePriority = false;  ///< SCHED_FIFO was granted.
  bool isMemoryLocked = false;       ///< The loop's buffers and its stack stay in RAM.
};

/// Runs an engine with a device, either by the clock on a thread of its own or tick by tick in the
/// caller's thread (virtual time: command line, tests, validation).
class HapticLoop {
public:
  /// Limits the engine's maximum force to that of the device.
  ///
  /// @param device  Open. Must outlive the loop.
  /// @throws std::invalid_argument without an engine.
  HapticLoop(device::HapticDevice& device, std::unique_ptr<InsertionEngine> engine);
  ~HapticLoop();  ///< Stops the thread; sets the device's force to zero.
  HapticLoop(const HapticLoop&) = delete;
  HapticLoop& operator=(const HapticLoop&) = delete;

  /// Starts the haptic thread. Requests SCHED_FIFO and locked memory and continues without them. If the device reports
  /// once per tick, within 10 %, each tick is triggered by a report, which minimizes latency;
  /// otherwise, and while reports are missing, by the machine's clock.
  /// @throws std::system_error if the system has no more threads.
  void start();
  /// What start() locked in RAM; the stack of the thread is not counted.
  const realtime::LockedMemory& lockedMemory() const noexcept;
  /// Stops the thread and sets the force to zero.
  void stop() noexcept;

  /// Runs one tick in the caller's thread, while no thread runs.
  void runOnce() noexcept;

  /// UI thread: sends a command. False if eight commands are waiting: try again later.
  bool send(const Command& command) noexcept;

  /// UI thread: stops the insertion in the next tick (Command::Kind::stop), after which the safety
  /// chain removes the force within its off time. Cannot be refused, because it does not use the
  /// queue of commands; commands that wait there are discarded.
  void requestStop() noexcept;
  /// UI thread: the same at a later time of the monotonic clock [ns], even if this thread is
  /// blocked then. The earlier of two requests applies. Never due in virtual time.
  void requestStopAt(std::int64_t time) noexcept;
  /// UI thread: withdraws a request for a later time; does not affect requestStop().
  void cancelStopAt() noexcept;

  /// UI thread: takes the newest snapshot; false if it was already taken.
  bool refresh() noexcept;
  /// UI thread: the snapshot of the last refresh().
  const Snapshot& latest() const noexcept;
  /// Recorder thread: takes the oldest record not yet taken.
  bool take(TickRecord& record) noexcept;

  /// Statistics; only after stop(), or between runOnce() calls.
  LoopStatistics statistics() const;
  const InsertionEngine& engine() const noexcept;

private:
  struct Content;
  std::unique_ptr<Content> content_;
};

}  // namespace perilymph::haptics
