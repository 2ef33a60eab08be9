#pragma once

// What stands between the physics and a hand: a force is clamped, slewed, watched, and goes to zero
// on any doubt.

#include <Eigen/Core>
#include <cstdint>

#include "perilymph/device/HapticDevice.h"
#include "perilymph/foundation/Hash.h"
#include "perilymph/foundation/RealTime.h"
#include "perilymph/haptics/Passivity.h"

namespace perilymph::haptics {

struct SafetyLimits {
  double maxForce =
      3.3;  ///< Maximum magnitude of the shown force [N]; the device's if that is lower.
  double maxSlew = 100.0;  ///< Maximum slew rate of the shown force [N/s].
  double rampTime = 0.5;   ///< Over which the force fades in after a pause or a fault [s].
  /// From the greatest force to none, once there shall be none: as soon as the device's own guard,
  /// which waits for at least as long [s]; 0: no faster than maxSlew.
  double offTime = 3e-3;
  double reach = 0.0;  ///< Reach of the device around D's origin [m]; 0: unknown, no limit.
};

/// The limits with a device's own greatest force, where it renders any.
SafetyLimits limitsFor(SafetyLimits limits, const device::DeviceTraits& traits) noexcept;

/// What a tick knows of the hand the force is for.
struct HandCondition {
  Eigen::Vector3d moved_D = Eigen::Vector3d::Zero();  ///< Since the tick before [m].
  double distance = 0.0;                              ///< From D's origin [m].
  bool isHeld = false;  ///< The dead-man's button is pressed and the workflow lets a force through.
  bool isStale = false;  ///< Nothing fresh came for too long.
  bool hasFault = false;
  bool hasJumped = false;  ///< The hand is somewhere else than the force was for: fade in anew.
};

/// The chain every force goes through, in this order:
///
///   1. a force that is not finite is none;
///   2. its magnitude is clamped, its direction kept;
///   3. it fades in over the ramp time after the hand took hold, came back or jumped;
///   4. nobody holds, nothing fresh, a fault: no force;
///   5. over the last tenth of the device's reach it fades out: a motor does not push into a stop;
///   6. energy that came back from the device is damped (Passivity), within the clamp;
///   7. from one tick to the next it changes by at most maxSlew dt, toward zero as away from it;
///      where 4. says no force, it is gone after offTime.
///
/// Because the slew limit stands last, no input whatever gives a step: from the clamp to zero takes
/// maxForce / maxSlew, 33 ms, and offTime where there shall be none.
class Safety {
public:
  /// @throws std::invalid_argument for limits that are not above zero.
  Safety(const SafetyLimits& limits, double timeStep);

  /// The force to show in this tick. Adds what it did to `status` (bits of Status).
  PERILYMPH_REALTIME Eigen::Vector3d show(const Eigen::Vector3d& wanted_D,
                                          const HandCondition& hand,
                                          std::uint32_t& status) noexcept;

  /// The hand let go of one array and takes another: its energy account starts anew. The shown
  /// force does not jump.
  PERILYMPH_REALTIME void forgetEnergy() noexcept { passivity_.reset(); }

  /// Lowers the clamp; never raises it [N].
  void lowerMaxForce(double maxForce) noexcept;

  const SafetyLimits& limits() const noexcept { return limits_; }
  double energy() const noexcept { return passivity_.energy(); }

  /// Adds all that the next tick depends on.
  void addTo(Hash& hash) const noexcept;

private:
  double fractionWithinReach(double distance) const noexcept;

  SafetyLimits limits_;
  double timeStep_;
  Passivity passivity_;
  double ramp_ = 0.0;  // share of the force that is shown, 0 to 1
  Eigen::Vector3d shown_D_ = Eigen::Vector3d::Zero();
};

}  // namespace perilymph::haptics
