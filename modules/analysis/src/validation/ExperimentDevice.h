// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The test rig that pushes the array in an experiment: constant speed and residual tremor.

#include <algorithm>
#include <limits>

#include "perilymph/analysis/Variability.h"
#include "perilymph/device/HapticDevice.h"

namespace perilymph::analysis {

/// Moves along D's -z from its first report on until rest(), with a sinusoidal tremor along each axis
/// of D. One read() is one time step.
class ExperimentDevice final : public device::HapticDevice {
public:
  explicit ExperimentDevice(const DrawnInsertion& drawn);

  device::DeviceTraits traits() const override;
  Result<Done> open() override { return Done{}; }
  void close() noexcept override {}
  device::DeviceSample read() noexcept override;
  void write(const device::Wrench&) noexcept override {}

  /// Advances no further; the tremor goes on.
  void rest() noexcept { lastStep_ = std::min(lastStep_, steps_); }

private:
  double speed_, timeStep_, amplitude_, frequency_;
  std::array<double, 3> phase_;
  device::DeviceSample sample_;
  double steps_ = 0.0;                                         // since it grasped
  double lastStep_ = std::numeric_limits<double>::infinity();  // that advances
};

}  // namespace perilymph::analysis
