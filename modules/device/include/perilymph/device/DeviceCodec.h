#pragma once

// What turns raw reports into a hand and a force into raw reports, for one kind of device.

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "perilymph/device/FixedReport.h"
#include "perilymph/device/HapticDevice.h"
#include "perilymph/device/Transport.h"
#include "perilymph/foundation/Result.h"

namespace perilymph::device {

/// The output reports that show one force. Fixed room: filled on the writer's thread without
/// allocating.
struct ReportList {
  static constexpr std::size_t capacity = 4;
  std::array<RawReport, capacity> reports{};
  std::size_t count = 0;
};

/// What takes a force away when nobody is left who could compute one.
struct Farewell {
  std::vector<FixedReport> noForce;    ///< Every actuator at zero; the device goes on.
  std::vector<FixedReport> switchOff;  ///< Effects stopped, actuators off: nothing follows.
};

/// A codec is built from a device profile and, where the device describes itself, from its report
/// descriptor. decode() belongs to the reading thread, encode(), begin() and end() to the writing
/// one; decode() and encode() may run at the same time.
class DeviceCodec {
public:
  virtual ~DeviceCodec() = default;

  /// Takes what an input report says into `hand` (SI, frame D), all but `sequence` and `isValid`.
  /// @return the device's own counter of reports where it has one, else 0; nothing for a report
  ///         that is not this hand's or is malformed: `hand` then stays as it was. Real-time safe.
  virtual std::optional<std::uint64_t> decode(const RawReport& report,
                                              DeviceSample& hand) noexcept = 0;

  /// The output reports that make the device show this wrench. Real-time safe.
  virtual void encode(const Wrench& wrench_D, ReportList& reports) noexcept = 0;

  /// Makes the device ready to show forces, with zero force: enables actuators, creates effects.
  /// Blocks. The sentence says what the device refused.
  virtual Result<Done> begin(Transport& transport) = 0;
  /// Stops every effect and disables the actuators, as far as the device still listens. Blocks.
  virtual void end(Transport& transport) noexcept = 0;
  /// The reports of end(), for somebody else to send; after begin(). Empty for a device that shows
  /// no force.
  virtual Farewell farewell() const { return {}; }
};

struct DeviceProfile;
class ReportDescriptor;

/// The codec for a device of this profile that describes itself so. An empty descriptor will do
/// where the profile says by itself where everything stands (`encoders`, `vector`). The sentence
/// says what does not fit.
Result<std::unique_ptr<DeviceCodec>> makeCodec(const DeviceProfile& profile,
                                               const ReportDescriptor& descriptor);

}  // namespace perilymph::device
