// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// A force test of a device: a small force along every axis, a small torque about every axis.

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>
#include <cstdint>

#include "perilymph/device/HapticDevice.h"
#include "perilymph/haptics/Safety.h"
#include "perilymph/haptics/SampleValidator.h"

namespace perilymph::haptics {

/// Tests a device's force and torque, one of its actuated axes after the other: up to `maxForce` or
/// `maxTorque` and back to zero within a second, only while the dead-man's button is held, and
/// through the safety chain of an insertion. Releasing the button removes the force at once and
/// restarts the axis; so do reports that are missing. An axis that is not tested within `patience`
/// ends the test. No clock: one step per tick.
class ForceTrial {
public:
  static constexpr double maxForce = 0.5;  ///< [N]; at most a fifth of the device's maximum.
  /// [N.m]; at most a fifth of the device's maximum. That of `maxForce` at a lever of 4 cm.
  static constexpr double maxTorque = 0.02;
  static constexpr double timeForAxis = 1.0;  ///< Duration of one axis [s].
  static constexpr double patience = 20.0;    ///< For one axis, with every interruption [s].
  static constexpr int axes = 6;              ///< Along D's x, y, z, then about them.

  /// @param traits    Of the open device.
  /// @param timeStep  Between steps [s].
  ForceTrial(const device::DeviceTraits& traits, double timeStep);

  /// Result of one axis.
  struct Axis {
    double peak = 0.0;   ///< Maximum force along it [N], or torque about it [N.m].
    double moved = 0.0;  ///< Motion of the device along or about it meanwhile [m], [rad].
    /// Mean of the motion along or about it, weighted by the force [m], [rad]: negative against it.
    double leaned = 0.0;
    bool isAgainst = false;  ///< The handle moved clearly against the force: its sign may be wrong.
    std::uint32_t limits = 0;  ///< What kept the force below the intended one: bits of Status.
    bool isActuated = false;   ///< The device states that it renders it.
    bool isDone = false;       ///< The push was not interrupted.
  };

  /// The force and torque to render for this sample.
  device::Wrench step(const device::DeviceSample& sample) noexcept;

  /// Every actuated axis was tested.
  bool isDone() const noexcept { return axis_ >= axes; }
  /// The test has ended: every axis was tested, or one was not within its time.
  bool isOver() const noexcept { return isDone() || spent_ >= patience; }
  /// The current axis: 0, 1, 2 along D's x, y, z; 3, 4, 5 about them.
  int axis() const noexcept { return axis_; }
  bool isHeld() const noexcept { return isHeld_; }
  /// Maximum force of the test [N].
  double greatest() const noexcept { return greatest_; }
  /// Maximum torque of the test [N.m].
  double greatestTorque() const noexcept { return greatestTorque_; }
  const std::array<Axis, axes>& results() const noexcept { return results_; }

private:
  double placeOf(const HandState& hand) const noexcept;
  void note(const HandState& hand, double wanted, double shown, std::uint32_t limits) noexcept;
  void skipFixedAxes() noexcept;

  double timeStep_;
  double greatest_, greatestTorque_;
  SampleValidator validator_;
  Safety safety_, torqueSafety_;
  int axis_ = 0;
  std::array<Axis, axes> results_;
  double pushed_ = 0.0;  // sum of the forces of the push
  double begin_ = 0.0;   // position along the axis at the beginning of the push [m]
  Eigen::Quaterniond beginRotation_D_ = Eigen::Quaterniond::Identity();
  double time_ = 0.0;   // within the push [s]
  double rest_ = 0.0;   // until the handle has come to rest after an interruption [s]
  double spent_ = 0.0;  // on the axis, with every interruption [s]
  bool isHeld_ = false;
};

}  // namespace perilymph::haptics
