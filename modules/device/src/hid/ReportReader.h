// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The reading side of a HID device: keeps the newest valid one of all waiting reports.

#include <cstdint>

#include "codec/DeviceCodec.h"
#include "hid/ReportCount.h"
#include "perilymph/device/DeviceHealth.h"
#include "perilymph/realtime/TimeHistogram.h"

namespace perilymph::device {

/// Time on the monotonic clock, or that of a test [ns].
using Clock = std::int64_t (*)() noexcept;

/// Drains a transport and keeps the content of the newest report. The kernel queues 63 reports and
/// drops *new* ones when the queue is full: a full queue is old, and its content is rejected.
/// Single-threaded; real-time safe as far as the transport is.
class ReportReader {
public:
  /// Number of reports that Linux queues for one handle (HIDRAW_BUFFER_SIZE less one).
  static constexpr int queueLength = 63;

  /// @param codec   Must outlive the reader.
  /// @param period  Between reports [s].
  ReportReader(DeviceCodec& codec, double period, Clock clock) noexcept;

  /// Takes all waiting reports without blocking. `done` if one was fresh, `gone` if the device is
  /// gone.
  Transfer drain(Transport& transport) noexcept;
  /// Waits for one report at most `timeout`, and keeps it for the next drain().
  Transfer await(Transport& transport, Duration timeout) noexcept;
  /// Takes a report from another source. True if it was fresh.
  bool accept(const RawReport& report) noexcept;

  /// Content of the newest fresh report. `sequence` counts fresh reports.
  const DeviceSample& newest() const noexcept { return sample_; }
  /// Arrival time of the newest fresh report [ns]; 0 before the first.
  std::int64_t lastFresh() const noexcept { return lastFresh_; }
  /// For a device whose silence means no motion: counts the last report as fresh again.
  void repeat() noexcept
  {
    if (lastFresh_ != 0) ++sample_.sequence;
  }
  /// Restarts with another handle: counters and times restart, figures and sequence continue.
  void reset() noexcept;

  /// Counters so far; rate and intervals of the last full second and overall.
  ReadingFigures figures() const noexcept;

private:
  void note(std::int64_t now) noexcept;

  DeviceCodec* codec_;
  Clock clock_;
  std::int64_t emptyAt_ = ReportCount::never;  ///< Time at which the queue was last seen empty
                                               ///< [ns].
  ReportCount count_;
  RawReport report_;
  bool isHolding_ = false;  // report_ was awaited and is not yet processed
  DeviceSample sample_;
  std::int64_t lastFresh_ = 0;
  std::int64_t secondBegan_ = 0;     // [ns]
  std::uint64_t freshInSecond_ = 0;  // since then
  realtime::TimeHistogram intervals_;
  std::int64_t firstEver_ = 0, lastEver_ = 0;  // fresh reports, whatever the handle [ns]
  realtime::TimeHistogram allIntervals_;
  // Quantiles of these, computed in turn by figures().
  mutable double median_ = 0.0, p99_ = 0.0;
  mutable std::uint64_t asked_ = 0;
  ReadingFigures figures_;
};

}  // namespace perilymph::device
