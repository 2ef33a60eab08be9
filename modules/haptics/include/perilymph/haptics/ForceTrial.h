#pragma once

// A small force on every axis of a device, for whoever holds it to feel.

#include <Eigen/Core>

#include "perilymph/device/HapticDevice.h"
#include "perilymph/haptics/Safety.h"
#include "perilymph/haptics/SampleValidator.h"

namespace perilymph::haptics {

/// Tries a device's force, one axis after the other: up to `maxForce` and back to zero within a second,
/// only while the dead-man's button is held, and through the safety chain of an insertion. Letting
/// go takes the force away at once and begins the axis anew. No clock: one step a tick.
class ForceTrial {
public:
  static constexpr double maxForce = 0.5;     ///< [N]; a fifth of the device's own, if less.
  static constexpr double timeForAxis = 1.0;  ///< [s]

  /// @param traits    Of the open device.
  /// @param timeStep  Between steps [s].
  ForceTrial(const device::DeviceTraits& traits, double timeStep);

  /// The force to show for this sample.
  PERILYMPH_REALTIME device::Wrench step(const device::DeviceSample& sample) noexcept;

  /// Every axis was shown.
  bool isOver() const noexcept { return axis_ >= axes_; }
  /// The axis being tried: 0, 1, 2 for D's x, y, z.
  int axis() const noexcept { return axis_; }
  bool isHeld() const noexcept { return isHeld_; }
  /// Greatest force that the trial shows [N].
  double greatest() const noexcept { return greatest_; }

private:
  double timeStep_;
  double greatest_;
  int axes_;
  SampleValidator validator_;
  Safety safety_;
  int axis_ = 0;
  double time_ = 0.0;  // of the axis [s]
  bool isHeld_ = false;
};

}  // namespace perilymph::haptics
