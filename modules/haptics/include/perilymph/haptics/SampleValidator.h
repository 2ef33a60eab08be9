#pragma once

// What the engine believes of a device's samples.

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cstdint>

#include "perilymph/device/HapticDevice.h"
#include "perilymph/foundation/Hash.h"
#include "perilymph/foundation/RealTime.h"

namespace perilymph::haptics {

/// The hand in one tick, in the device's frame D, every number finite.
struct HandState {
  Eigen::Vector3d position_D = Eigen::Vector3d::Zero();  ///< [m]
  Eigen::Vector3d moved_D = Eigen::Vector3d::Zero();     ///< Since the tick before [m].
  Eigen::Vector3d velocity_D = Eigen::Vector3d::Zero();  ///< Smoothed over a few samples [m/s].
  Eigen::Quaterniond rotation_D = Eigen::Quaterniond::Identity();
  bool isHeld = false;      ///< The dead-man's button is pressed.
  bool isStale = true;      ///< Nothing fresh and believable came for too long.
  bool isLost = false;      ///< The device says it is gone.
  bool hasJumped = false;   ///< The hand is not where it could have moved to: take a new anchor.
  bool isRejected = false;  ///< The sample was not believed.
};

/// Judges samples: fresh or not, finite or not, possible for a hand or not.
///
/// A sample whose sequence number did not change is not fresh. One with numbers that are not
/// finite, farther than 10 m away or without a rotation is not believed; it counts as not fresh,
/// but a button it says is released is released. After `staleTime` without a believed one the hand
/// is stale. A fresh place that no hand could have reached (1 m/s, 30 rad/s), or the first one
/// after a stale time, is a jump: the hand is there, but did not move there.
class SampleValidator {
public:
  /// @param timeStep      Of the ticks [s].
  /// @param samplePeriod  Nominal, of the device [s].
  SampleValidator(double timeStep, double samplePeriod);

  /// Three nominal periods of a device, at least 3 ms and at most 30 ms [s].
  static double staleTime(double samplePeriod) noexcept;

  /// The hand as of this sample.
  PERILYMPH_REALTIME const HandState& take(const device::DeviceSample& sample) noexcept;

  /// Adds all that the next tick depends on.
  void addTo(Hash& hash) const noexcept;

private:
  bool isFresh(const device::DeviceSample& sample) noexcept;
  void follow(const Eigen::Vector3d& position_D, const Eigen::Quaterniond& rotation_D) noexcept;

  double timeStep_;
  std::uint64_t staleTicks_;
  std::uint64_t ticksWithout_;  // since the last believed sample
  std::uint64_t sequence_ = 0;
  bool hasSequence_ = false;
  bool hasPlace_ = false;  // some sample was believed
  Eigen::Vector3d rawVelocity_D_ = Eigen::Vector3d::Zero();
  HandState hand_;
};

}  // namespace perilymph::haptics
