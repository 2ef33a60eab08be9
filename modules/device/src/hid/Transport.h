// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Transfer of raw HID reports to and from one device node: hidraw, a test double, a recording.

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "perilymph/foundation/Result.h"
#include "perilymph/foundation/Units.h"

namespace perilymph::device {

/// Maximum size of a HID report, with its number [bytes].
inline constexpr std::size_t longestReport = 1024;

/// One report as on the wire. `bytes[0]` is the report number, 0 if the device does not number its
/// reports; the report itself follows.
struct RawReport {
  std::array<std::uint8_t, longestReport> bytes{};
  std::size_t size = 0;  ///< Number of valid bytes, report number included.

  std::span<const std::uint8_t> view() const noexcept { return {bytes.data(), size}; }
};

/// Result of a read or a write.
enum class Transfer : std::uint8_t {
  done,     ///< A report was transferred.
  nothing,  ///< No report arrived in time.
  failed,   ///< The transfer failed; the device is still there.
  gone,     ///< The device is disconnected or closed: all further transfers fail.
};

/// One handle to one HID node. A handle is used by one thread; a device that is read and written by
/// different threads is opened twice.
class Transport {
public:
  virtual ~Transport() = default;

  /// Takes the oldest waiting input report. With a `timeout` of zero it never blocks and is
  /// real-time safe.
  virtual Transfer read(RawReport& report, Duration timeout) noexcept = 0;
  /// Sends an output report. May block for a USB frame, or for seconds if the device hangs.
  virtual Transfer write(const RawReport& report) noexcept = 0;
  /// Sends a feature report. May block.
  virtual Transfer setFeature(const RawReport& report) noexcept = 0;
  /// Requests the feature report with the number `report.bytes[0]`; `report.size` is its maximum
  /// length, and afterwards its actual length. May block.
  virtual Transfer getFeature(RawReport& report) noexcept = 0;
};

}  // namespace perilymph::device
