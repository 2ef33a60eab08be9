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
  /// UI thread: moves the target across the axis, along D's x and y [m].
  void shiftBy(double right, double up) noexcept;
  /// UI thread: rotates the array about its axis [rad].
  void rollBy(double angle) noexcept;
  /// UI thread: grasps or releases the array (the dead-man's button).
  void grasp(bool held) noexcept;

  DeviceTraits traits() const override;
  Result<Done> open() override;
  void close() noexcept override;
  DeviceSample read() noexcept override;
  void write(const Wrench& wrench_D) noexcept override;

private:
  /// Requests of the window not yet taken by read().
  std::atomic<double> askedAdvance_{0.0}, askedRight_{0.0}, askedUp_{0.0}, askedRoll_{0.0};
  std::atomic<bool> isHeld_{false};
  double timeStep_;
  // Owned by the haptic thread. Advance, right, up [m]; roll [rad].
  std::array<double, 4> wanted_{};
  std::array<double, 4> place_{};
  std::array<double, 4> velocity_{};  ///< Velocity of the position, per second.
  DeviceSample sample_;
};

}  // namespace perilymph::device
