// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Forces on USB physical interface devices: constant-force effects stored in the device, whose
// magnitudes are updated.

#include "codec/AxesReader.h"
#include "codec/PidReports.h"

namespace perilymph::device {

class PidCodec final : public DeviceCodec {
public:
  PidCodec(const DeviceProfile& profile, const AxesReader& reader, const PidReports& reports)
      : profile_(profile), reader_(reader), reports_(reports)
  {
  }

  std::optional<std::uint64_t> decode(const RawReport& report,
                                      DeviceSample& sample) noexcept override
  {
    return reader_.decode(report, sample);
  }
  /// Returns no reports before begin() created the effects, or after end() released them.
  void encode(const Wrench& wrench_D, ReportList& reports) noexcept override;
  /// Stops effects of other programs, resets, creates the effects with zero force and starts them;
  /// the actuators are enabled last.
  Result<void> begin(Transport& transport) override;
  void end(Transport& transport) noexcept override;
  ShutdownReports shutdownReports() const override;

private:
  struct Effect {
    std::int64_t block = 0;
    std::size_t axis = 0;  ///< Axis of D before the mount; unused for variable directions.
  };

  Result<void> create(Transport& transport);
  Result<void> addEffect(Transport& transport, std::size_t axis);
  Result<void> tell(Transport& transport, std::optional<RawReport> report, const char* what);
  bool isMoved(std::size_t axis) const noexcept;
  void encodeDirection(const Vector3& magnitude, ReportList& reports) const noexcept;

  const DeviceProfile profile_;
  AxesReader reader_;
  const PidReports reports_;
  // Used by the writing thread only.
  std::array<Effect, 3> effects_{};
  std::size_t effectCount_ = 0;
};

}  // namespace perilymph::device
