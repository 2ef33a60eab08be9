// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// A force test of a device: a small force on every axis.

#include <Eigen/Core>
#include <array>
#include <cstdint>

#include "perilymph/device/HapticDevice.h"
#include "perilymph/haptics/Safety.h"
#include "perilymph/haptics/SampleValidator.h"

namespace perilymph::haptics {

/// Tests a device's force, one axis after the other: up to `maxForce` and back to zero within a
/// second, only while the dead-man's button is held, and through the safety chain of an insertion.
/// Releasing the button removes the force at once and restarts the axis; so do reports that are
/// missing. An axis that is not tested within `patience` ends the test. No clock: one step per tick.
class ForceTrial {
public:
  static constexpr double maxForce = 0.5;     ///< [N]; at most a fifth of the device's maximum.
  static constexpr double timeForAxis = 1.0;  ///< Duration of one axis [s].
  static constexpr double patience = 20.0;    ///< For one axis, with every interruption [s].

  /// @param traits    Of the open device.
  /// @param timeStep  Between steps [s].
  ForceTrial(const device::DeviceTraits& traits, double timeStep);

  /// Result of one axis.
  struct Axis {
    double peak = 0.0;         ///< Maximum force rendered along it [N].
    double moved = 0.0;        ///< Motion of the device along it during the push [m].
    std::uint32_t limits = 0;  ///< What kept the force below the intended one: bits of Status.
    bool isDone = false;       ///< The push was not interrupted.
  };

  /// The force to render for this sample.
  device::Wrench step(const device::DeviceSample& sample) noexcept;

  /// Every axis was tested.
  bool isDone() const noexcept { return axis_ >= axes_; }
  /// The test has ended: every axis was tested, or one was not within its time.
  bool isOver() const noexcept { return isDone() || spent_ >= patience; }
  /// The current axis: 0, 1, 2 for D's x, y, z.
  int axis() const noexcept { return axis_; }
  bool isHeld() const noexcept { return isHeld_; }
  /// Maximum force of the test [N].
  double greatest() const noexcept { return greatest_; }
  /// D's x, y, z; only the axes of the device are used.
  const std::array<Axis, 3>& results() const noexcept { return results_; }

private:
  void note(const HandState& hand, double wanted, double shown, std::uint32_t limits) noexcept;

  double timeStep_;
  double greatest_;
  int axes_;
  SampleValidator validator_;
  Safety safety_;
  int axis_ = 0;
  std::array<Axis, 3> results_;
  double begin_ = 0.0;  // position of the device along the axis at the beginning of the push [m]
  double time_ = 0.0;   // within the push [s]
  double spent_ = 0.0;  // on the axis, with every interruption [s]
  bool isHeld_ = false;
};

}  // namespace perilymph::haptics
