// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Devices whose reports contain plain numbers at positions given by the profile: encoder counts and
// motor currents, or positions and forces.

#include <atomic>

#include "codec/CodecParts.h"

namespace perilymph::device {

class PlainCodec final : public DeviceCodec {
public:
  explicit PlainCodec(const DeviceProfile& profile) : profile_(profile) {}

  std::optional<std::uint64_t> decode(const RawReport& report,
                                      DeviceSample& sample) noexcept override;
  void encode(const Wrench& wrench_D, ReportList& reports) noexcept override;
  Result<void> begin(Transport& transport) override;
  void end(Transport& transport) noexcept override;
  ShutdownReports shutdownReports() const override;

private:
  Vector3 position_B(const Vector3& counts) noexcept;
  Vector3 alongAxes(const Vector3& force_D) const noexcept;
  void putOutputs(const Vector3& force_B, RawReport& report) const noexcept;
  void putCounts(RawReport& report) const noexcept;

  const DeviceProfile profile_;
  // Angles of the newest report, for the Jacobian on the writing thread. Each is atomic by itself;
  // angles of two reports a millisecond apart change the force by less than its resolution.
  std::array<std::atomic<double>, 3> angles_{};
  std::atomic<bool> asksForCounts_{false};
};

}  // namespace perilymph::device
