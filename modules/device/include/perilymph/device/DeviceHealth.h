#pragma once

// How a device and the way to it are doing, for people: the status bar, the doctor, the session.

#include <cstdint>
#include <string>

namespace perilymph::device {

/// What the reading side counted since the device was opened.
struct ReadingFigures {
  std::uint64_t fresh = 0;       ///< Reports that told something new.
  std::uint64_t lost = 0;        ///< Missing in the device's own count.
  std::uint64_t duplicates = 0;  ///< With the count of the one before.
  std::uint64_t old = 0;         ///< Overtaken, or waited too long in a queue that overflowed.
  std::uint64_t foreign = 0;     ///< Not this hand's, or malformed.
  double rate = 0.0;             ///< Fresh reports a second, over the last second.
  double intervalMedian = 0.0;   ///< Between fresh reports as the haptic thread saw them [s].
  double intervalP99 = 0.0;      ///< [s]
  double intervalMax = 0.0;      ///< [s]
  double silence = 0.0;          ///< Since the last fresh report [s].
};

/// What the writing side counted since the device was opened.
struct WritingFigures {
  std::uint64_t accepted = 0;        ///< Forces the device took.
  std::uint64_t refused = 0;         ///< Forces it did not take.
  double timeMedian = 0.0;           ///< For one force, all its reports [s].
  double timeP99 = 0.0;              ///< [s]
  double timeMax = 0.0;              ///< [s]
  bool hasRealTimePriority = false;  ///< The writer goes before ordinary threads.
};

struct DeviceHealth {
  bool isConnected = false;
  bool isBlocked = false;  ///< It takes no force at the moment.
  ReadingFigures reading;
  WritingFigures writing;
  double period = 0.0;            ///< Between reports, measured on opening [s]; else the profile's.
  bool isPeriodMeasured = false;  ///< On opening.
  double delay = 0.0;             ///< On the way to the device and back, without waiting [s].
  /// From a force to the report that shows it [s]: measured where the device answers, else the most
  /// it can be, the way there and a period of reports.
  double roundTrip = 0.0;
  bool isRoundTripMeasured = false;  ///< On opening.
  std::uint64_t reconnections = 0;   ///< Times it came back.
  std::uint64_t blockedWrites = 0;   ///< Times it took no force for too long.
  bool isGuarded = false;            ///< Another process takes the force away if this one dies.
  std::string guardObstacle;         ///< A sentence: why a device that shows force is not guarded.
  std::string error;                 ///< A sentence; empty while all is well.
};

}  // namespace perilymph::device
