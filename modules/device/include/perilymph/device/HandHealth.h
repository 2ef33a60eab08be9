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
  double intervalMost = 0.0;     ///< [s]
  double silence = 0.0;          ///< Since the last fresh report [s].
};

/// What the writing side counted since the device was opened.
struct WritingFigures {
  std::uint64_t accepted = 0;  ///< Forces the device took.
  std::uint64_t refused = 0;   ///< Forces it did not take.
  double timeMedian = 0.0;     ///< For one force, all its reports [s].
  double timeP99 = 0.0;        ///< [s]
  double timeMost = 0.0;       ///< [s]
};

struct HandHealth {
  bool isConnected = false;
  bool isBlocked = false;  ///< It takes no force at the moment.
  ReadingFigures reading;
  WritingFigures writing;
  double period = 0.0;            ///< Between reports, measured on opening [s]; else the profile's.
  bool isPeriodMeasured = false;  ///< On opening.
  double delay = 0.0;             ///< From a force to the report that shows it [s].
  std::uint64_t reconnections = 0;  ///< Times it came back.
  std::uint64_t blockedWrites = 0;  ///< Times it took no force for too long.
  std::string trouble;              ///< A sentence; empty while all is well.
};

}  // namespace perilymph::device
