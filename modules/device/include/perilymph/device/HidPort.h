#pragma once

// Where a device is plugged in: it gives handles on the device as often as the device comes back.

#include <memory>

#include "perilymph/device/HidNodes.h"
#include "perilymph/device/Transport.h"

namespace perilymph::device {

/// One thread at a time.
class HidPort {
public:
  virtual ~HidPort() = default;

  /// A new handle on the device, wherever it is now. Blocks for a moment.
  virtual Result<std::unique_ptr<Transport>> open() = 0;

  /// A descriptor of the device open() found, that only writes: for another process that shall
  /// outlive this one. The caller closes it. -1 where there is none.
  virtual int fileForGuard() noexcept { return -1; }

  /// Waits until something was plugged in or out, at most so long; it may also return early.
  virtual void awaitChange(Duration timeout) noexcept = 0;
};

/// The port of a device found by findHidNodes(). After it was plugged in again it is found by what
/// it is, whatever the number of its node; changes are told by udev, where there is a udev.
std::unique_ptr<HidPort> hidPort(HidNode node, SystemRoots roots = {});

}  // namespace perilymph::device
