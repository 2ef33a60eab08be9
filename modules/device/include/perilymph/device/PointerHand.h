#pragma once

// Mouse and keyboard as a hand: the window says where the hand wants to be, a smooth motion follows.

#include <atomic>

#include "perilymph/device/HapticDevice.h"

namespace perilymph::device {

/// The hand moves toward the place asked for, no faster than a surgeon's would and without jumps of
/// speed, so that wheel clicks and key presses become motion a rod can follow.
class PointerHand final : public HapticDevice {
public:
  /// @param timeStep  Between reads [s].
  explicit PointerHand(double timeStep);

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
  std::atomic<double> wantedAdvance_{0.0}, wantedRight_{0.0}, wantedUp_{0.0}, wantedRoll_{0.0};
  std::atomic<bool> isHeld_{false};
  double timeStep_;
  std::array<double, 4> place_{};     ///< Advance, right, up [m]; roll [rad].
  std::array<double, 4> velocity_{};  ///< Of the same, per second.
  DeviceSample sample_;
};

}  // namespace perilymph::device
