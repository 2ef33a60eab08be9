// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// A device that pushes at a constant speed with a tremor: the rig of an experiment, or a hand.

#include <algorithm>
#include <array>
#include <limits>

#include "perilymph/device/HapticDevice.h"
#include "perilymph/foundation/Units.h"

namespace perilymph::analysis {

/// A push with a sinusoidal tremor along each axis of D.
struct TremblingPush {
  double speed = 0.0;                   ///< [m/s]
  double tremorAmplitude = 0.0;         ///< [m]
  double tremorFrequency = 0.0;         ///< [Hz]
  std::array<double, 3> tremorPhase{};  ///< Along D's axes [rad].
};

/// Moves along D's -z from its first report on until rest(), trembling. One read() is one
/// time step.
class ExperimentDevice final : public device::HapticDevice {
public:
  ExperimentDevice(const TremblingPush& push, Duration timeStep);

  device::DeviceTraits traits() const override;
  Result<void> open() override { return {}; }
  void close() noexcept override {}
  device::DeviceSample read() noexcept override;
  void write(const device::Wrench&) noexcept override {}

  /// Advances no further; the tremor continues.
  void rest() noexcept { lastStep_ = std::min(lastStep_, steps_); }

private:
  TremblingPush push_;
  double timeStep_;  // [s]
  device::DeviceSample sample_;
  double steps_ = 0.0;                                         // since it grasped
  double lastStep_ = std::numeric_limits<double>::infinity();  // that advances
};

}  // namespace perilymph::analysis
