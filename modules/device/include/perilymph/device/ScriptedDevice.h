// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// An input device without hardware: constant speed in, stop, constant speed out.

#include <atomic>

#include "perilymph/device/HapticDevice.h"

namespace perilymph::device {

/// Moves along D's -z at a constant speed while commanded. One read() is one time step.
class ScriptedDevice final : public HapticDevice {
public:
  using Motion = ScriptedMotion;

  /// @param speed     Of the hand [m/s].
  /// @param timeStep  Between reads [s].
  ScriptedDevice(double speed, double timeStep);

  /// Any thread: stops with the button released, or moves with it pressed.
  void move(Motion motion) noexcept override { motion_ = motion; }
  Motion motion() const noexcept { return motion_; }
  /// Any thread [m/s].
  void setSpeed(double speed) noexcept { speed_ = speed; }
  double speed() const noexcept { return speed_; }

  DeviceTraits traits() const override;
  Result<void> open() override;
  void close() noexcept override;
  DeviceSample read() noexcept override;
  void write(const Wrench& wrench_D) noexcept override;

private:
  std::atomic<Motion> motion_{Motion::hold};
  std::atomic<double> speed_;
  double timeStep_;
  DeviceSample sample_;
};

}  // namespace perilymph::device
