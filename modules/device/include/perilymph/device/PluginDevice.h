// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Devices implemented outside the project as shared libraries: see PluginApi.h.

#include <filesystem>
#include <memory>
#include <vector>

#include "perilymph/device/HapticDevice.h"
#include "perilymph/foundation/Result.h"

namespace perilymph::device {

/// Loads a plug-in in a process of its own and wraps its device; the process lives as long as the
/// device. A plug-in that crashes or hangs ends with its process, and its force with it: samples are
/// invalid from then on, health() states why, and open() loads it again.
///
/// The error states why a library is refused: not found, not a plug-in, another version, incomplete,
/// invalid traits. Loading executes the library's code: load only trusted libraries.
Result<std::unique_ptr<HapticDevice>> loadPluginDevice(const std::filesystem::path& library);

/// The shared libraries in a folder and its subfolders, sorted.
std::vector<std::filesystem::path> pluginLibraries(const std::filesystem::path& folder);

}  // namespace perilymph::device
