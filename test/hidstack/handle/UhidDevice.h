// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// A HID device made of a program: the kernel's /dev/uhid.

#include <cstdint>
#include <memory>
#include <span>
#include <string>

#include "perilymph/foundation/Result.h"

namespace perilymph::hidstack {

/// What the kernel tells the device.
enum class UhidEvent : std::uint8_t {
  nothing,       ///< Nothing waits.
  output,        ///< An output report came: `report` holds it.
  featureSet,    ///< A feature report came: `report` holds it; wants accept() or refuse().
  featureAsked,  ///< One is asked for: `report` holds its number; wants answer() or refuse().
  other,         ///< Started, opened, closed: nothing to do.
};

/// Plugged in while it lives; unplugged when it is destroyed.
class UhidDevice {
public:
  UhidDevice();
  ~UhidDevice();
  UhidDevice(const UhidDevice&) = delete;
  UhidDevice& operator=(const UhidDevice&) = delete;

  /// Appears on the bus under this name.
  Result<Done> plug(const std::string& name, std::uint16_t vendor, std::uint16_t product,
                    std::span<const std::uint8_t> descriptor);
  /// Disconnects the device, even if it is open.
  void unplug() noexcept;
  bool isPlugged() const noexcept { return file_ >= 0; }

  /// For poll(): readable when an event waits.
  int file() const noexcept { return file_; }
  /// Sends an input report; false while the kernel is not ready for it.
  bool send(std::span<const std::uint8_t> report) noexcept;
  /// Takes one event.
  UhidEvent take(std::span<const std::uint8_t>& report) noexcept;
  /// About the feature report of the last event. Whoever set it or asked for it waits meanwhile,
  /// for five seconds at most.
  void refuse() noexcept;
  void accept() noexcept;
  void answer(std::span<const std::uint8_t> report) noexcept;

private:
  void reply(int error, std::span<const std::uint8_t> report) noexcept;

  struct Buffers;  ///< One event each way; they are large.
  std::unique_ptr<Buffers> buffers_;
  int file_ = -1;
};

}  // namespace perilymph::hidstack
