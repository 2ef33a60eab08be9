// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Health of a device and its connection, for the status bar, `perilymph-cli devices` and the recording.

#include <cstdint>
#include <string>

namespace perilymph::device {

/// Rate of fresh reports and intervals between them, as seen by the haptic thread.
struct ReportTiming {
  double rate = 0.0;            ///< Reports per second.
  double intervalMedian = 0.0;  ///< [s]
  double intervalP99 = 0.0;     ///< [s]
  double intervalMax = 0.0;     ///< [s]
};

/// Counters of the reading side since the device was opened.
struct ReadingFigures {
  std::uint64_t fresh = 0;       ///< Reports with new data.
  std::uint64_t lost = 0;        ///< Missing according to the device's counter.
  std::uint64_t duplicates = 0;  ///< With the same counter as the previous report.
  std::uint64_t old = 0;         ///< Out of order, or delayed in a queue that overflowed.
  std::uint64_t foreign = 0;     ///< From another collection, or malformed.
  double rate = 0.0;             ///< Fresh reports per second, over the last second.
  double intervalMedian = 0.0;   ///< Between fresh reports, as seen by the haptic thread [s].
  double intervalP99 = 0.0;      ///< [s]
  double intervalMax = 0.0;      ///< [s]
  ReportTiming overall;          ///< Since the device was opened, reconnections included.
  double silence = 0.0;          ///< Since the last fresh report, or since it was opened [s].
};

/// Counters of the writing side since the device was opened.
struct WritingFigures {
  std::uint64_t accepted = 0;        ///< Forces accepted by the device.
  std::uint64_t refused = 0;         ///< Forces not accepted.
  double timeMedian = 0.0;           ///< Duration of sending one force, all its reports [s].
  double timeP99 = 0.0;              ///< [s]
  double timeMax = 0.0;              ///< [s]
  bool hasRealTimePriority = false;  ///< The writer has real-time priority.
};

struct DeviceHealth {
  bool isConnected = false;
  bool isBlocked = false;  ///< It currently accepts no force.
  ReadingFigures reading;
  WritingFigures writing;
  double period = 0.0;            ///< Between reports, measured on opening [s]; else the profile's.
  bool isPeriodMeasured = false;  ///< On opening.
  double delay = 0.0;             ///< Transport delay to the device and back, without waiting [s].
  /// From a force to the report that shows its effect [s]: measured if the device answers, else an
  /// upper bound: the write time plus one report period.
  double roundTrip = 0.0;
  bool isRoundTripMeasured = false;  ///< On opening.
  std::uint64_t reconnections = 0;   ///< Number of reconnections.
  std::uint64_t blockedWrites = 0;   ///< Number of times it accepted no force for too long.
  bool isGuarded = false;            ///< A guard process removes the force if this process dies.
  std::string guardObstacle;         ///< A sentence: why a device that renders force is not
                                     ///< guarded.
  std::string error;                 ///< A sentence; empty if there is no error.
};

}  // namespace perilymph::device
