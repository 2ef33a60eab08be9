// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Starts a second, small process that removes the force if this program cannot.

#include <memory>

#include "codec/DeviceCodec.h"
#include "hid/Transport.h"

namespace perilymph::device {

/// A guarded handle for writing, or the unguarded handle and the reason.
struct GuardedHandle {
  std::unique_ptr<Transport> handle;
  std::string obstacle;  ///< A sentence; empty if it is guarded.
};

/// Starts `perilymph-device-guard` for a device. The guard also has the device open and sends the
/// farewell if this process ends before the handle was destroyed, even by kill -9. If this process
/// is stopped while it renders a force, the guard removes the force after `patience`.
///
/// @param handle    Open for writing.
/// @param file      Descriptor of the device's node (HidPort::fileForGuard), taken over; -1: none.
/// @param farewell  The reports that remove the force.
GuardedHandle guarded(std::unique_ptr<Transport> handle, int file,
                      const ShutdownReports& shutdownReports, Duration patience);

}  // namespace perilymph::device
