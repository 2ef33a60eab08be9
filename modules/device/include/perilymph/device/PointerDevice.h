// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Mouse and keyboard as input device: the window sets a target, which the position follows
// smoothly.

#include <atomic>

#include "perilymph/device/HapticDevice.h"

namespace perilymph::device {

/// The position follows the target like a critically damped spring, with limits:
///
///     a = w^2 (wanted - place) - 2 w v,   |a| <= 0.4 m/s^2,   |v| <= 20 mm/s
///
/// so that wheel clicks and key presses become motion that a rod can follow. Requests while the
/// array is released are dropped: the array never moves on its own when it is grasped again.
class PointerDevice final : public HapticDevice {
public:
  /// @param timeStep  Between reads [s].
  explicit PointerDevice(double timeStep);

  /// UI thread: moves the target along the insertion axis [m], positive into the cochlea.
  void advanceBy(double distance) noexcept;
  /// UI thread: moves the target along the insertion axis at a velocity [m/s], positive into the
  /// cochlea, until the next call, by at most `maxDistance` [m] and for at most longestDrive_s. The
  /// reads time the motion: it does not depend on how often the window calls. Velocities above
  /// 20 mm/s are limited.
  void driveAt(double velocity, double maxDistance) noexcept;
  /// A window that stops calling stops the motion: the reads of two frames at 1 frame per second.
  static constexpr double longestDrive_s = 2.0;
  /// UI thread: moves the target across the axis, along D's x and y [m].
  void shiftBy(double right, double up) noexcept;
  /// UI thread: rotates the array about its axis [rad].
  void rollBy(double angle) noexcept;
  /// UI thread: grasps or releases the array (the dead-man's button).
  void grasp(bool held) noexcept;

  DeviceTraits traits() const override;
  Result<void> open() override;
  void close() noexcept override;
  DeviceSample read() noexcept override;
  void write(const Wrench& wrench_D) noexcept override;

private:
  double driven() noexcept;

  /// Requests of the window not yet taken by read().
  std::atomic<double> askedAdvance_{0.0}, askedRight_{0.0}, askedUp_{0.0}, askedRoll_{0.0};
  /// Velocity [m/s], and distance [m] of a driveAt() not yet taken; negative: none.
  std::atomic<double> askedVelocity_{0.0}, askedDistance_{-1.0};
  std::atomic<bool> isHeld_{false};
  double timeStep_;
  // Owned by the haptic thread. Advance, right, up [m]; roll [rad].
  std::array<double, 4> wanted_{};
  std::array<double, 4> place_{};
  std::array<double, 4> velocity_{};  ///< Velocity of the position, per second.
  double driveDistance_ = 0.0;        ///< Remaining distance of the drive [m].
  double driveTime_ = 0.0;            ///< Remaining time of the drive [s].
  DeviceSample sample_;
};

}  // namespace perilymph::device
