// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// A plug-in that is being loaded, so that several can be at the same time.

#include <filesystem>
#include <memory>
#include <stop_token>

#include "perilymph/device/HapticDevice.h"
#include "perilymph/foundation/Result.h"
#include "perilymph/foundation/Units.h"
#include "plugin/PluginProcess.h"

namespace perilymph::device::plugin {

struct LoadingPlugin {
  std::filesystem::path file;  ///< As it was given, for messages.
  std::unique_ptr<PluginProcess> process;
};

/// Checks the file and starts the process that loads it.
Result<LoadingPlugin> beginToLoad(const std::filesystem::path& file);

/// Waits until it is loaded, checks its traits, and wraps its device. `stop` ends this and the first opening
/// of the device.
Result<std::unique_ptr<HapticDevice>> awaitDevice(LoadingPlugin loading, Duration patience,
                                                  const std::stop_token& stop = {});

}  // namespace perilymph::device::plugin
