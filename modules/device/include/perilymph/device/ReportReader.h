#pragma once

// The reading half of a HID hand: out of all waiting reports, the newest true one.

#include <cstdint>

#include "perilymph/device/DeviceCodec.h"
#include "perilymph/device/DeviceHealth.h"
#include "perilymph/device/ReportCount.h"
#include "perilymph/foundation/RealTime.h"
#include "perilymph/realtime/TimeHistogram.h"

namespace perilymph::device {

/// Time on the monotonic clock, or a test's own [ns].
using Clock = std::int64_t (*)() noexcept;

/// Drains a transport and keeps what the newest report said. The system keeps 63 waiting reports
/// and, when they are not taken, drops the *new* ones: a queue found full is old, and nothing in it
/// is believed. One thread; real-time safe but for what the transport does.
class ReportReader {
public:
  /// Reports that Linux keeps for one handle (HIDRAW_BUFFER_SIZE less one).
  static constexpr int queueLength = 63;

  /// @param codec   Outlives the reader.
  /// @param period  Between reports [s].
  ReportReader(DeviceCodec& codec, double period, Clock clock) noexcept;

  /// Takes every waiting report without waiting. `done` if one was fresh, `gone` if the device is.
  PERILYMPH_REALTIME Transfer drain(Transport& transport) noexcept;
  /// Waits for one report at most so long, and keeps it for the next drain().
  Transfer await(Transport& transport, Duration timeout) noexcept;
  /// Takes a report that came another way. True if it was fresh.
  PERILYMPH_REALTIME bool accept(const RawReport& report) noexcept;

  /// What the newest fresh report said. `sequence` counts fresh reports.
  const DeviceSample& newest() const noexcept { return sample_; }
  /// When it came [ns]; 0 before the first.
  std::int64_t lastFresh() const noexcept { return lastFresh_; }
  /// For a device whose silence means that it stands still: calls the last report fresh again.
  PERILYMPH_REALTIME void repeat() noexcept
  {
    if (lastFresh_ != 0) ++sample_.sequence;
  }
  /// Another handle: counts and times begin anew, figures and sequence go on.
  PERILYMPH_REALTIME void startOver() noexcept;

  /// Counts so far; rate and intervals of the last full second.
  const ReadingFigures& figures() const noexcept { return figures_; }

private:
  void note(std::int64_t now) noexcept;

  DeviceCodec* codec_;
  Clock clock_;
  std::int64_t emptyAt_ = ReportCount::never;  ///< When the queue was last seen empty [ns].
  ReportCount count_;
  RawReport report_;
  bool isHolding_ = false;  // report_ was awaited and not looked at yet
  DeviceSample sample_;
  std::int64_t lastFresh_ = 0;
  std::int64_t secondBegan_ = 0;     // [ns]
  std::uint64_t freshInSecond_ = 0;  // since then
  realtime::TimeHistogram intervals_;
  ReadingFigures figures_;
};

}  // namespace perilymph::device
