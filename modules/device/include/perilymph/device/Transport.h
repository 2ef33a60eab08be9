#pragma once

// How raw HID reports get in and out of one device node: hidraw, a fake in tests, a recording.

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "perilymph/foundation/Result.h"
#include "perilymph/foundation/Units.h"

namespace perilymph::device {

/// Longest report of a HID device that Perilymph takes, with its number [bytes].
inline constexpr std::size_t longestReport = 1024;

/// One report as it goes over the wire. `bytes[0]` is the report's number, 0 where the device does
/// not number its reports; what follows is the report itself.
struct RawReport {
  std::array<std::uint8_t, longestReport> bytes{};
  std::size_t size = 0;  ///< Number of valid bytes, the report's number included.

  std::span<const std::uint8_t> view() const noexcept { return {bytes.data(), size}; }
};

/// How a read or a write ended.
enum class Transfer : std::uint8_t {
  done,     ///< A report was moved.
  nothing,  ///< Nothing was there to read in the time given.
  failed,   ///< This one did not go through; the device is still there.
  gone,     ///< The device is unplugged or closed: nothing will go through again.
};

/// One handle on one HID node. A handle serves one thread; a device that is read in one thread and
/// written in another is opened twice.
class Transport {
public:
  virtual ~Transport() = default;

  /// Takes the oldest waiting input report. A `timeout` of zero never waits and is real-time safe.
  virtual Transfer read(RawReport& report, Duration timeout) noexcept = 0;
  /// Sends an output report. May block: for a USB frame, or for seconds if the device is stuck.
  virtual Transfer write(const RawReport& report) noexcept = 0;
  /// Sends a feature report. May block.
  virtual Transfer setFeature(const RawReport& report) noexcept = 0;
  /// Asks for the feature report whose number is in `report.bytes[0]`; `report.size` says how long
  /// it may be, and afterwards how long it is. May block.
  virtual Transfer getFeature(RawReport& report) noexcept = 0;
};

}  // namespace perilymph::device
