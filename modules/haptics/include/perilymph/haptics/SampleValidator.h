// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Validation of a device's samples.

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cstdint>

#include "perilymph/device/HapticDevice.h"
#include "perilymph/foundation/Hash.h"

namespace perilymph::haptics {

/// The hand in one tick, in the device's frame D; all values are finite.
struct HandState {
  Eigen::Vector3d position_D = Eigen::Vector3d::Zero();  ///< [m]
  Eigen::Vector3d moved_D = Eigen::Vector3d::Zero();     ///< Displacement since the previous tick
                                                         ///< [m].
  Eigen::Vector3d velocity_D = Eigen::Vector3d::Zero();  ///< Smoothed over a few samples [m/s].
  Eigen::Quaterniond rotation_D = Eigen::Quaterniond::Identity();
  bool isHeld = false;      ///< The dead-man's button is pressed.
  bool isStale = true;      ///< No fresh, accepted sample for too long.
  bool isLost = false;      ///< The device reports that it is gone.
  bool hasJumped = false;   ///< The hand is farther away than it could have moved: take a new
                            ///< anchor.
  bool isRejected = false;  ///< The sample was rejected.
};

/// Classifies samples: fresh, finite, physically possible.
///
/// A sample with an unchanged sequence number is not fresh. A sample that is not finite, farther
/// than 10 m away or without a valid rotation is rejected; it does not count as fresh, but a
/// released button in it is honored. After `staleTime` without an accepted sample the hand is
/// stale. A fresh position that no hand could have reached (1 m/s, 30 rad/s), or the first one
/// after a stale period, is a jump: the hand's position is taken, but not as a motion.
class SampleValidator {
public:
  /// Lag of the smoothed velocity [s], the price of smoothing encoder quantization: 0.055 mm in 1 ms
  /// reads as 55 mm/s.
  static constexpr double velocityLag = 2e-3;

  /// @param timeStep      Of the ticks [s].
  /// @param samplePeriod  Nominal, of the device [s].
  SampleValidator(double timeStep, double samplePeriod);

  /// Three nominal periods of a device, at least 3 ms and at most 30 ms [s].
  static double staleTime(double samplePeriod) noexcept;

  /// The hand after this sample.
  const HandState& take(const device::DeviceSample& sample) noexcept;

  /// Adds all data that the next tick depends on.
  void addTo(Hash& hash) const noexcept;

private:
  bool isFresh(const device::DeviceSample& sample) noexcept;
  void follow(const Eigen::Vector3d& position_D, const Eigen::Quaterniond& rotation_D) noexcept;

  double timeStep_;
  std::uint64_t staleTicks_;
  std::uint64_t ticksWithout_;  // since the last accepted sample
  std::uint64_t sequence_ = 0;
  bool hasSequence_ = false;
  bool hasPlace_ = false;  // at least one sample was accepted
  Eigen::Vector3d rawVelocity_D_ = Eigen::Vector3d::Zero();
  HandState hand_;
};

}  // namespace perilymph::haptics
