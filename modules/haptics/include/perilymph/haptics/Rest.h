// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// When an insertion rests: its state and its time stand still, and it is not recorded.

#include <Eigen/Core>
#include <cstdint>

#include "perilymph/device/HapticDevice.h"
#include "perilymph/foundation/Hash.h"

namespace perilymph::haptics {

/// Times and distances of a rest.
struct RestLimits {
  double after =
      0.0;  ///< Time without motion after which the insertion rests [s]; infinite: never.
  /// Motion of the array that ends the time without motion [m]; 0: an insertion never rests while
  /// the hand holds the device.
  double motion = 0.0;
  /// Motion of a hand that holds the device while it inserts, which ends the time without motion and
  /// the rest [m]: the array follows it. 0: an insertion never rests there.
  double handMotion = 0.0;
};

/// The state of an insertion that may rest. No clock: time is counted in ticks.
class Rest {
public:
  /// Motion of a hand that holds the device at full depth, beyond which the rest ends [m]: several
  /// times the tremor of a hand. The array does not follow it then (choice, low).
  static constexpr double handMotionAtDepth = 2e-3;

  /// What may begin or continue a rest.
  struct Condition {
    bool mayRest = false;      ///< Neither hand nor stylet move the array.
    bool isSteady = false;     ///< The rendered force does not change.
    bool isHeld = false;       ///< The hand holds the device and feels a force.
    bool isInserting = false;  ///< The array follows the hand.
    bool hasBegun = false;     ///< There was a motion; before it, the rest needs no time.
    Eigen::Vector3d tip_W = Eigen::Vector3d::Zero();   ///< [m]
    Eigen::Vector3d hand_D = Eigen::Vector3d::Zero();  ///< [m]
  };

  Rest(const RestLimits& limits, double timeStep);

  bool isOn() const noexcept { return isOn_; }
  /// The hand holds the device at rest: the rendered force is that of the tick before.
  bool isHeld() const noexcept { return isOn_ && isHeld_; }

  /// Whether a sample ends a held rest: the button is released, or the hand is elsewhere.
  bool isLeftBy(const device::DeviceSample& sample) const noexcept;
  /// The rest ends; a held one begins again after the whole time only.
  void end() noexcept;
  /// Counts the ticks without motion; rests when there are enough.
  void note(const Condition& now) noexcept;

  /// Adds all data that the next tick depends on.
  void addTo(Hash& hash) const noexcept;

private:
  RestLimits limits_;
  double timeStep_;
  bool isOn_;
  bool isHeld_ = false;
  std::uint64_t ticksStill_ = 0;
  bool isInserting_ = false;
  Eigen::Vector3d tip_W_ = Eigen::Vector3d::Zero();        // at the last motion [m]
  Eigen::Vector3d movedHand_D_ = Eigen::Vector3d::Zero();  // at the last motion [m]
  Eigen::Vector3d hand_D_ = Eigen::Vector3d::Zero();       // at the beginning of the rest [m]
};

}  // namespace perilymph::haptics
