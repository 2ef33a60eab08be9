// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// A simulated HID device through the kernel's /dev/uhid.

#include <cstdint>
#include <memory>
#include <span>
#include <string>

#include "perilymph/foundation/Result.h"

namespace perilymph::hidstack {

/// Events from the kernel.
enum class UhidEvent : std::uint8_t {
  nothing,           ///< No event.
  output,            ///< An output report arrived, in `report`.
  featureSet,        ///< A feature report arrived, in `report`; requires accept() or refuse().
  featureRequested,  ///< A feature report is requested, its number in `report`; requires answer() or
                     ///< refuse().
  other,             ///< Started, opened, closed: no action required.
};

/// Connected during its lifetime.
class UhidDevice {
public:
  UhidDevice();
  ~UhidDevice();
  UhidDevice(const UhidDevice&) = delete;
  UhidDevice& operator=(const UhidDevice&) = delete;

  /// Connects under this name.
  Result<void> plug(const std::string& name, std::uint16_t vendor, std::uint16_t product,
                    std::span<const std::uint8_t> descriptor);
  /// Disconnects the device, even if it is open.
  void unplug() noexcept;
  bool isPlugged() const noexcept { return file_ >= 0; }

  /// For poll(): readable when an event is pending.
  int file() const noexcept { return file_; }
  /// Sends an input report; false if the kernel is not ready for it.
  bool send(std::span<const std::uint8_t> report) noexcept;
  /// Takes one event.
  UhidEvent take(std::span<const std::uint8_t>& report) noexcept;
  /// Response to the feature report of the last event. The requester waits for at most five
  /// seconds.
  void refuse() noexcept;
  void accept() noexcept;
  void answer(std::span<const std::uint8_t> report) noexcept;

private:
  void reply(int error, std::span<const std::uint8_t> report) noexcept;

  struct Buffers;  ///< One event in each direction; they are large.
  std::unique_ptr<Buffers> buffers_;
  int file_ = -1;
};

}  // namespace perilymph::hidstack
