// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// A recording as input device.

#include <vector>

#include "perilymph/device/HapticDevice.h"

namespace perilymph::device {

/// Returns recorded samples one after the other, unchanged, including faults. After the last one it
/// repeats it: no sample is fresh, and the force goes to zero as for a stale device.
class ReplayDevice final : public HapticDevice {
public:
  /// @param samples   One per read.
  /// @param timeStep  Between reads [s].
  ReplayDevice(std::vector<DeviceSample> samples, double timeStep);

  /// True after the last sample.
  bool isOver() const noexcept { return next_ >= samples_.size(); }

  DeviceTraits traits() const override;
  /// Starts from the first sample. Fails if there are no samples.
  Result<void> open() override;
  void close() noexcept override {}
  DeviceSample read() noexcept override;
  void write(const Wrench& wrench_D) noexcept override;

private:
  std::vector<DeviceSample> samples_;
  double timeStep_;
  std::size_t next_ = 0;
};

}  // namespace perilymph::device
