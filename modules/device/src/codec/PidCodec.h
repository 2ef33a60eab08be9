#pragma once

// Forces on USB physical interface devices: constant-force effects that live in the device and are
// told new magnitudes.

#include "codec/AxesReader.h"
#include "codec/PidReports.h"

namespace perilymph::device {

class PidCodec final : public DeviceCodec {
public:
  PidCodec(const DeviceProfile& profile, const AxesReader& reader, const PidReports& reports)
      : profile_(profile), reader_(reader), reports_(reports)
  {
  }

  std::optional<std::uint64_t> decode(const RawReport& report, DeviceSample& hand) noexcept override
  {
    return reader_.decode(report, hand);
  }
  /// No reports before begin() made the effects, or after end() freed them.
  void encode(const Wrench& wrench_D, ReportList& reports) noexcept override;
  /// Stops what other programs left behind, resets, creates the effects with zero force and starts
  /// them; the actuators are enabled last.
  Result<Done> begin(Transport& transport) override;
  void end(Transport& transport) noexcept override;
  Farewell farewell() const override;

private:
  struct Effect {
    std::int64_t block = 0;
    std::size_t axis = 0;  ///< Axis of D before the mount; unused for rotations.
  };

  Result<Done> create(Transport& transport);
  Result<Done> addEffect(Transport& transport, std::size_t axis);
  Result<Done> tell(Transport& transport, std::optional<RawReport> report, const char* what);
  bool isMoved(std::size_t axis) const noexcept;
  void encodeDirection(const Vector3& magnitude, ReportList& reports) const noexcept;

  const DeviceProfile profile_;
  AxesReader reader_;
  const PidReports reports_;
  // Writing thread only.
  std::array<Effect, 3> effects_{};
  std::size_t effectCount_ = 0;
};

}  // namespace perilymph::device
