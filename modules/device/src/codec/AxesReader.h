// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Decodes the axes and buttons named by a descriptor: joysticks, SpaceMouse, the input side of PID
// devices.

#include "codec/CodecParts.h"

namespace perilymph::device {

class AxesReader {
public:
  /// Finds the profile's axes and buttons; the error names what is missing.
  static Result<AxesReader> make(const DeviceProfile& profile, const ReportDescriptor& descriptor);

  /// See DeviceCodec::decode(). Real-time safe.
  std::optional<std::uint64_t> decode(const RawReport& report, DeviceSample& sample) noexcept;

  int buttons() const noexcept { return buttons_; }
  /// Counts from the center of an axis to its end; 0 for an undriven axis.
  double halfRange(std::size_t axis) const noexcept { return axes_[axis].half; }

private:
  struct Axis {
    ReportSlot slot;
    double middle = 0.0;
    double half = 0.0;  ///< Counts from the center to the end; 0: undriven axis.
    double sign = 1.0;
  };
  struct ButtonSlot {
    ReportSlot slot;
    std::uint32_t bit = 0;  ///< Bit of DeviceSample::buttons.
  };
  static constexpr std::size_t maxButtons = 32;

  double deflection(const Axis& axis, std::span<const std::uint8_t> bytes) const noexcept;
  void place() noexcept;
  void drift(std::uint8_t report) noexcept;

  AxesLayout layout_;
  std::array<double, 9> mount_DB_{};
  double period_ = 0.0;
  double bound_ = 0.0;  ///< Maximum magnitude of each integrated coordinate [m]; 0: unlimited.
  std::array<Axis, 6> axes_{};
  // State accumulated from reports: each contains a part of the sample.
  std::array<double, 6> deflections_{};
  Vector3 position_D_{};
  std::array<double, 4> rotation_D_{1.0, 0.0, 0.0, 0.0};
  std::uint32_t pressed_ = 0;
  std::array<ButtonSlot, maxButtons> buttonSlots_{};
  int buttons_ = 0;
  std::array<std::uint16_t, 256> reportBytes_{};  ///< Sizes of the input reports; 0: not used here.
};

/// A device with axes that renders no force.
class AxesCodec final : public DeviceCodec {
public:
  AxesCodec(const DeviceProfile& profile, const AxesReader& reader)
      : profile_(profile), reader_(reader)
  {
  }

  std::optional<std::uint64_t> decode(const RawReport& report,
                                      DeviceSample& sample) noexcept override
  {
    return reader_.decode(report, sample);
  }
  void encode(const Wrench&, ReportList& reports) noexcept override { reports.count = 0; }
  Result<void> begin(Transport& transport) override
  {
    return sendAll(transport, profile_.onOpen, profile_.name);
  }
  void end(Transport& transport) noexcept override { sendQuietly(transport, profile_.onClose); }

private:
  const DeviceProfile profile_;
  AxesReader reader_;
};

}  // namespace perilymph::device
