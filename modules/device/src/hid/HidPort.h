// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The connection of a device, which opens handles to it again after it was reconnected.

#include <memory>

#include "hid/Transport.h"
#include "perilymph/device/HidNodes.h"

namespace perilymph::device {

/// Used by one thread at a time.
class HidPort {
public:
  virtual ~HidPort() = default;

  /// A new handle to the device, at its current node. Blocks briefly.
  virtual Result<std::unique_ptr<Transport>> open() = 0;

  /// A write-only descriptor of the device found by open(), for a guard process that outlives this
  /// one. The caller closes it. -1 if there is none.
  virtual int fileForGuard() noexcept { return -1; }

  /// Waits until a device was connected or disconnected, at most `timeout`; may return early.
  virtual void awaitChange(Duration timeout) noexcept = 0;
};

/// The port of a device found by findHidNodes(). After reconnection it is found by its identity,
/// whatever its node number; changes are reported by udev, if available.
std::unique_ptr<HidPort> hidPort(HidNode node, SystemRoots roots = {});

}  // namespace perilymph::device
