#pragma once

// The virtual handle read and written on its node alone, without the device layer.

#include <optional>
#include <string>

#include "HandleReports.h"
#include "perilymph/device/HapticDevice.h"

namespace perilymph::hidstack {

/// One file, one thread.
class DirectHand final : public device::HapticDevice {
public:
  explicit DirectHand(std::string node) : node_(std::move(node)) {}
  ~DirectHand() override { close(); }

  device::DeviceTraits traits() const override;
  Result<Done> open() override;
  void close() noexcept override;
  device::DeviceSample read() noexcept override;
  void write(const device::Wrench& wrench_D) noexcept override;

  /// The oldest report not yet taken.
  std::optional<InputReport> take() noexcept;

private:
  std::string node_;
  int file_ = -1;
  device::DeviceSample sample_;
};

}  // namespace perilymph::hidstack
