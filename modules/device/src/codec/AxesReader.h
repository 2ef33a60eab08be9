#pragma once

// Turns the axes and buttons that a descriptor names into a hand: joysticks, SpaceMouse, the input
// side of PID devices.

#include "codec/CodecParts.h"

namespace perilymph::device {

class AxesReader {
public:
  /// Finds the profile's axes and the buttons; the sentence names what is missing.
  static Result<AxesReader> make(const DeviceProfile& profile, const ReportDescriptor& descriptor);

  /// As DeviceCodec::decode(). Real-time safe.
  std::optional<std::uint64_t> decode(const RawReport& report, DeviceSample& hand) noexcept;

  int buttons() const noexcept { return buttons_; }
  /// Counts from the middle of an axis to its end; 0 for an axis that nothing moves.
  double halfRange(std::size_t axis) const noexcept { return axes_[axis].half; }

private:
  struct Axis {
    ReportSlot slot;
    double middle = 0.0;
    double half = 0.0;  ///< Counts from the middle to the end; 0: nothing moves this axis.
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
  double bound_ = 0.0;  ///< Bound of each coordinate that drifts [m]; 0: none.
  std::array<Axis, 6> axes_{};
  // What the reports said so far: each tells a part of the hand.
  std::array<double, 6> deflections_{};
  Vector3 position_D_{};
  std::array<double, 4> rotation_D_{1.0, 0.0, 0.0, 0.0};
  std::uint32_t pressed_ = 0;
  std::array<ButtonSlot, maxButtons> buttonSlots_{};
  int buttons_ = 0;
  std::array<std::uint16_t, 256> reportBytes_{};  ///< Sizes of the input reports; 0: not read here.
};

/// A device that has axes and shows no force.
class AxesCodec final : public DeviceCodec {
public:
  AxesCodec(const DeviceProfile& profile, const AxesReader& reader)
      : profile_(profile), reader_(reader)
  {
  }

  std::optional<std::uint64_t> decode(const RawReport& report, DeviceSample& hand) noexcept override
  {
    return reader_.decode(report, hand);
  }
  void encode(const Wrench&, ReportList& reports) noexcept override { reports.count = 0; }
  Result<Done> begin(Transport& transport) override
  {
    return sendAll(transport, profile_.onOpen, profile_.name);
  }
  void end(Transport& transport) noexcept override { sendQuietly(transport, profile_.onClose); }

private:
  const DeviceProfile profile_;
  AxesReader reader_;
};

}  // namespace perilymph::device
