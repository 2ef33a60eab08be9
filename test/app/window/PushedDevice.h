// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// A force-feedback device that exists only here: a hand pushes it inward to a depth and holds it there,
// button pressed. Notes each force with its time.

#include <array>
#include <atomic>
#include <cstdint>
#include <memory>

#include "perilymph/device/HapticDevice.h"

namespace perilymph::test {

/// What a device was told, seen from any thread.
class ForceLog {
public:
  struct Entry {
    std::int64_t time = 0;   ///< Monotonic [ns].
    double magnitude = 0.0;  ///< [N]
  };
  /// Haptic thread.
  void add(double magnitude) noexcept;

  /// The hand begins to push.
  std::atomic<bool> isPushed{false};
  /// It holds the device at the depth to which it pushes.
  std::atomic<bool> isAtDepth{false};

  /// While it is held up, the device answers no read, and its loop takes no command.
  void holdUp(bool isOn);
  std::atomic<bool> holdsUp{false};
  /// A read waits for that.
  std::atomic<bool> isHeldUp{false};

  std::size_t size() const { return count_; }
  const Entry& operator[](std::size_t i) const { return entries_[i]; }
  double newest() const { return size() == 0 ? 0.0 : entries_[size() - 1].magnitude; }
  /// Index of the first entry at or after a time, monotonic [ns]; size() if there is none.
  std::size_t firstAfter(std::int64_t time) const;

private:
  static constexpr std::size_t capacity = 200'000;  // more than three minutes
  std::array<Entry, capacity> entries_{};
  std::atomic<std::size_t> count_{0};
};

/// Rests with its button pressed; once it is pushed, moves at 20 mm/s to 24 mm and holds: with a force
/// scale of 20 the coupling is soft, and the array comes half as deep.
class PushedDevice : public device::HapticDevice {
public:
  static constexpr double maxForce = 3.3;  // [N], of the 3D Systems Touch (CHAI3D)

  explicit PushedDevice(std::shared_ptr<ForceLog> log) : log_(std::move(log)) {}

  device::DeviceTraits traits() const override;
  Result<void> open() override { return {}; }
  void close() noexcept override {}
  device::DeviceSample read() noexcept override;
  void write(const device::Wrench& wrench_D) noexcept override;

private:
  std::shared_ptr<ForceLog> log_;
  device::DeviceSample sample_;
};

}  // namespace perilymph::test
