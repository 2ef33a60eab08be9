// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// A device wrapper that records when each sample was read and when each force was ready.

#include <optional>
#include <vector>

#include "TickLog.h"
#include "perilymph/device/DeviceHealth.h"
#include "perilymph/device/HapticDevice.h"

namespace perilymph::hidstack {

/// Forwards everything to another device. Only the engine runs between the two times of a tick. The
/// log belongs to the ticking thread; read it after that thread has ended.
class TimedDevice final : public device::HapticDevice {
public:
  /// @param hand  Must outlive this object.
  /// @param most  Ticks to make room for; what comes later is not noted.
  TimedDevice(device::HapticDevice& hand, std::size_t capacity);

  device::DeviceTraits traits() const override { return hand_.traits(); }
  Result<void> open() override { return hand_.open(); }
  void close() noexcept override { hand_.close(); }
  device::DeviceSample read() noexcept override;
  void write(const device::Wrench& wrench_D) noexcept override;
  device::Awaited await(Duration timeout) noexcept override { return hand_.await(timeout); }
  std::optional<device::DeviceHealth> health() override { return hand_.health(); }

  const std::vector<LoopTick>& ticks() const { return ticks_; }

private:
  device::HapticDevice& hand_;
  std::vector<LoopTick> ticks_;
  LoopTick tick_;
};

}  // namespace perilymph::hidstack
