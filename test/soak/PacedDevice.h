// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "perilymph/device/HapticDevice.h"

namespace perilymph::test {

/// A hand that goes in and comes back to exactly where it began: its place is a whole number of
/// steps, so that no rounding adds up over a million of them.
class PacedDevice final : public device::HapticDevice {
public:
  enum class Direction { rest, in, out, home };

  /// @param step  Along D's -z in one read() [m].
  explicit PacedDevice(double step) : step_(step) {}

  /// Rests with the button released; in and out with the button pressed; home, released, to where
  /// it began.
  void go(Direction direction) noexcept { direction_ = direction; }
  bool isHome() const noexcept { return place_ == 0; }

  device::DeviceTraits traits() const override;
  Result<void> open() override { return {}; }
  void close() noexcept override {}
  device::DeviceSample read() noexcept override;
  void write(const device::Wrench&) noexcept override {}

private:
  double step_;
  Direction direction_ = Direction::rest;
  long place_ = 0;  // steps in
  std::uint64_t sequence_ = 0;
  bool hadHold_ = false;
};

}  // namespace perilymph::test
