// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Conversion between raw reports and samples or forces, for one kind of device.

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "codec/FixedReport.h"
#include "hid/Transport.h"
#include "perilymph/device/HapticDevice.h"
#include "perilymph/foundation/Result.h"

namespace perilymph::device {

/// The output reports that render one force. Fixed capacity: filled on the writer's thread without
/// allocating.
struct ReportList {
  static constexpr std::size_t capacity = 4;
  std::array<RawReport, capacity> reports{};
  std::size_t count = 0;
};

/// The reports that remove the force when the program can no longer compute one.
struct ShutdownReports {
  std::vector<FixedReport> noForce;    ///< Every actuator at zero; the device stays enabled.
  std::vector<FixedReport> switchOff;  ///< Effects stopped, actuators off; the last reports.
};

/// Built from a device profile and, if the device describes itself, from its report descriptor.
/// decode() is called by the reading thread, encode(), begin() and end() by the writing thread;
/// decode() and encode() may run concurrently.
class DeviceCodec {
public:
  virtual ~DeviceCodec() = default;

  /// Decodes an input report into `hand` (SI, frame D), except `sequence` and `isValid`.
  /// @return the device's own report counter if it has one, else 0; empty for a report of another
  ///         collection or a malformed one: `hand` is then unchanged. Real-time safe.
  virtual std::optional<std::uint64_t> decode(const RawReport& report,
                                              DeviceSample& sample) noexcept = 0;

  /// The output reports that render this wrench. Real-time safe.
  virtual void encode(const Wrench& wrench_D, ReportList& reports) noexcept = 0;

  /// Prepares the device to render forces, with zero force: enables actuators, creates effects.
  /// Blocks. The error names the step that the device refused.
  virtual Result<void> begin(Transport& transport) = 0;
  /// Stops every effect and disables the actuators, as far as the device still responds. Blocks.
  virtual void end(Transport& transport) noexcept = 0;
  /// The reports of end(), to be sent by another process; valid after begin(). Empty for a device
  /// that renders no force.
  virtual ShutdownReports shutdownReports() const { return {}; }
};

struct DeviceProfile;
class ReportDescriptor;

/// Makes the codec of a device with this profile and report descriptor. The descriptor may be empty
/// for profiles that define all positions themselves (`encoders`, `vector`). An error if they are
/// inconsistent.
Result<std::unique_ptr<DeviceCodec>> makeCodec(const DeviceProfile& profile,
                                               const ReportDescriptor& descriptor);

}  // namespace perilymph::device
