#pragma once

// A recording as a hand.

#include <vector>

#include "perilymph/device/HapticDevice.h"

namespace perilymph::device {

/// Gives recorded samples one after the other, as they were, faults included. After the last one it
/// repeats it: nothing fresh comes any more, and the force goes to zero as with a stale device.
class ReplayDevice final : public HapticDevice {
public:
  /// @param samples   One for each read.
  /// @param timeStep  Between reads [s].
  ReplayDevice(std::vector<DeviceSample> samples, double timeStep);

  /// Every sample was given.
  bool isOver() const noexcept { return next_ >= samples_.size(); }

  DeviceTraits traits() const override;
  /// Fails if there is nothing to play. Starts from the first sample.
  Result<Done> open() override;
  void close() noexcept override {}
  DeviceSample read() noexcept override;
  void write(const Wrench& wrench_D) noexcept override;

private:
  std::vector<DeviceSample> samples_;
  double timeStep_;
  std::size_t next_ = 0;
};

}  // namespace perilymph::device
