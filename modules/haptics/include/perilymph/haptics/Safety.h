// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The safety chain between physics and hand: clamps and slew-limits the force, monitors the hand,
// and sets the force to zero in case of doubt.

#include <Eigen/Core>
#include <cstdint>

#include "perilymph/device/HapticDevice.h"
#include "perilymph/foundation/Hash.h"
#include "perilymph/haptics/Passivity.h"

namespace perilymph::haptics {

struct SafetyLimits {
  double maxForce = 3.3;   ///< Maximum magnitude of the rendered force [N]; the device's if lower.
  double maxSlew = 100.0;  ///< Maximum slew rate of the rendered force [N/s].
  double rampTime = 0.5;   ///< Duration of the fade-in after a pause or a fault [s].
  /// Time from maximum force to zero when the force is switched off, no longer than the timeout of
  /// the device's own guard [s]; 0: limited by maxSlew only.
  double offTime = 3e-3;
  double reach = 0.0;  ///< Reach of the device around D's origin [m]; 0: unknown, no limit.
};

/// The limits with the device's maximum force, if it renders force.
SafetyLimits limitsFor(SafetyLimits limits, const device::DeviceTraits& traits) noexcept;

/// State of the hand that receives the force.
struct HandCondition {
  Eigen::Vector3d moved_D = Eigen::Vector3d::Zero();  ///< Displacement since the previous tick [m].
  double distance = 0.0;                              ///< From D's origin [m].
  bool isHeld = false;   ///< The dead-man's button is pressed and the workflow allows force.
  bool isStale = false;  ///< No fresh sample for too long.
  bool hasFault = false;
  bool hasJumped = false;  ///< The hand is not where the force was computed for: fade in again.
};

/// The chain that every force passes through, in this order:
///
///   1. a force that is not finite is replaced by zero;
///   2. its magnitude is clamped, its direction kept;
///   3. it fades in over the ramp time after the hand grasped, came back or jumped;
///   4. it is zero if the button is released, no sample is fresh, or there is a fault;
///   5. it fades out over the last tenth of the device's reach: a motor must not push into a stop;
///   6. energy returned by the device is damped (Passivity), within the clamp;
///   7. from one tick to the next it changes by at most maxSlew dt, in both directions; if 4.
///      applies, it reaches zero after offTime.
///
/// Because the slew limit is last, no input produces a step: from the clamp to zero takes maxForce
/// / maxSlew, 33 ms, and offTime when the force is switched off.
class Safety {
public:
  /// @throws std::invalid_argument for limits that are not positive.
  Safety(const SafetyLimits& limits, double timeStep);

  /// The force to render in this tick. Adds the limits that acted to `status` (bits of Status).
  Eigen::Vector3d show(const Eigen::Vector3d& wanted_D, const HandCondition& hand,
                       std::uint32_t& status) noexcept;

  /// Lowers the clamp [N]; never raises it.
  void lowerMaxForce(double maxForce) noexcept;

  const SafetyLimits& limits() const noexcept { return limits_; }
  double energy() const noexcept { return passivity_.energy(); }
  /// The rendered force is zero, and the next one fades in from the beginning.
  bool isZero() const noexcept { return shown_D_.isZero(0.0) && ramp_ == 0.0; }

  /// Adds all data that the next tick depends on.
  void addTo(Hash& hash) const noexcept;

private:
  double fractionWithinReach(double distance) const noexcept;

  SafetyLimits limits_;
  double timeStep_;
  Passivity passivity_;
  double ramp_ = 0.0;  // rendered fraction of the force, 0 to 1
  Eigen::Vector3d shown_D_ = Eigen::Vector3d::Zero();
};

}  // namespace perilymph::haptics
