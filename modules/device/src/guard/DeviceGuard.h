#pragma once

// Somebody who takes the force away when this program cannot: a second, small process.

#include <memory>

#include "perilymph/device/DeviceCodec.h"
#include "perilymph/device/Transport.h"

namespace perilymph::device {

/// A handle to write with, watched over as long as it lives, or the handle as it was and why not.
struct GuardedHandle {
  std::unique_ptr<Transport> handle;
  std::string obstacle;  ///< A sentence; empty if it is guarded.
};

/// Starts `perilymph-device-guard` for a device. It holds the device open too and sends the
/// farewell if this process ends in any way before the handle was destroyed: kill -9 included. A
/// process that stands still while it pushes loses its force after `patience`.
///
/// @param handle    Open for writing.
/// @param file      A descriptor of the device's node (HidPort::fileForGuard), taken over; -1:
/// none.
/// @param farewell  What takes the force away.
GuardedHandle guarded(std::unique_ptr<Transport> handle, int file, const Farewell& farewell,
                      Duration patience);

}  // namespace perilymph::device
