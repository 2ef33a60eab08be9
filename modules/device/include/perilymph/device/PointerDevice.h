#pragma once

// Mouse and keyboard as a hand: the window says where the hand wants to be, a smooth motion
// follows.

#include <atomic>

#include "perilymph/device/HapticDevice.h"

namespace perilymph::device {

/// The hand moves toward the place asked for like a critically damped spring, with bounds:
///
///     a = w^2 (wanted - place) - 2 w v,   |a| <= 0.4 m/s^2,   |v| <= 20 mm/s
///
/// so that wheel clicks and key presses become motion a rod can follow. What is asked for while the
/// array is let go is dropped: the array never moves by itself when it is held again.
class PointerDevice final : public HapticDevice {
public:
  /// @param timeStep  Between reads [s].
  explicit PointerDevice(double timeStep);

  /// UI thread: moves the place asked for, along the insertion axis [m], positive into the cochlea.
  void advanceBy(double distance) noexcept;
  /// UI thread: moves the place asked for across the axis, along D's x and y [m].
  void shiftBy(double right, double up) noexcept;
  /// UI thread: turns the array about its axis [rad].
  void rollBy(double angle) noexcept;
  /// UI thread: holds or lets go of the array (the dead-man's button).
  void grasp(bool held) noexcept;

  DeviceTraits traits() const override;
  Result<Done> open() override;
  void close() noexcept override;
  DeviceSample read() noexcept override;
  void write(const Wrench& wrench_D) noexcept override;

private:
  /// What the window asked for and read() has not taken yet.
  std::atomic<double> askedAdvance_{0.0}, askedRight_{0.0}, askedUp_{0.0}, askedRoll_{0.0};
  std::atomic<bool> isHeld_{false};
  double timeStep_;
  // The haptic thread's. Advance, right, up [m]; roll [rad].
  std::array<double, 4> wanted_{};
  std::array<double, 4> place_{};
  std::array<double, 4> velocity_{};  ///< Velocity of the place, per second.
  DeviceSample sample_;
};

}  // namespace perilymph::device
