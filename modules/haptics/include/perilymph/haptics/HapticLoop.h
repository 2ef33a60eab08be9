#pragma once

// The loop around the tick: device in, device out, one thread, four channels.

#include <memory>

#include "perilymph/device/HapticDevice.h"
#include "perilymph/foundation/Result.h"
#include "perilymph/haptics/InsertionEngine.h"
#include "perilymph/haptics/Snapshot.h"

namespace perilymph::haptics {

/// What the loop measured of itself since it started.
struct LoopStatistics {
  std::uint64_t ticks = 0;
  std::uint64_t lateTicks = 0;    ///< Began more than one period late.
  std::uint64_t missedTicks = 0;  ///< Never took place: the thread stood still for too long.
  std::uint64_t overruns = 0;     ///< Took longer than one period.
  std::uint64_t lostRecords = 0;
  double tickTimeMedian = 0.0;       ///< [s]
  double tickTimeP99 = 0.0;          ///< [s]
  double tickTimeMax = 0.0;          ///< [s]
  bool hasRealTimePriority = false;  ///< SCHED_FIFO was granted.
};

/// Runs an engine against a device, either on a thread of its own by the clock or, tick by tick, in
/// the caller's thread (virtual time: command line, tests, validation).
class HapticLoop {
public:
  /// Lowers the engine's greatest force to the device's own.
  ///
  /// @param device  Open. Outlives the loop.
  /// @throws std::invalid_argument without an engine.
  HapticLoop(device::HapticDevice& device, std::unique_ptr<InsertionEngine> engine);
  ~HapticLoop();  ///< Stops the thread; the device is shown zero force.
  HapticLoop(const HapticLoop&) = delete;
  HapticLoop& operator=(const HapticLoop&) = delete;

  /// Starts the haptic thread. Asks for SCHED_FIFO and goes on without it. Where the device reports
  /// once a tick, within 10 %, each tick begins when a report comes, so that a force is as young as
  /// it can be; without reports, and with every other hand, ticks begin by the machine's clock.
  /// @throws std::system_error if the system has no more threads.
  void start();
  /// Stops it and shows zero force.
  void stop() noexcept;

  /// One tick in the caller's thread, while no thread runs.
  PERILYMPH_REALTIME void runOnce() noexcept;

  /// UI thread: asks for something. False when eight requests are waiting: try again.
  bool send(const Command& command) noexcept;
  /// UI thread: takes the newest picture, if there is one it has not seen.
  bool refresh() noexcept;
  /// UI thread: the picture the last refresh() took.
  const Snapshot& latest() const noexcept;
  /// Recorder thread: takes the oldest record not yet taken.
  bool take(TickRecord& record) noexcept;

  /// After stop(), or between runOnce() calls.
  LoopStatistics statistics() const;
  const InsertionEngine& engine() const noexcept;

private:
  struct Content;
  std::unique_ptr<Content> content_;
};

}  // namespace perilymph::haptics
