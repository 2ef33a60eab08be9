#pragma once

// Devices of a new kind, built outside the project as shared libraries: see PluginApi.h.

#include <filesystem>
#include <memory>
#include <vector>

#include "perilymph/device/HapticDevice.h"
#include "perilymph/foundation/Result.h"

namespace perilymph::device {

/// Loads a plug-in and wraps its device; the library stays loaded as long as the device lives. The
/// sentence says why a library is not taken: not there, not a plug-in, another version, incomplete,
/// impossible traits. Loading runs the library's code: load what you trust.
Result<std::unique_ptr<HapticDevice>> loadPluginDevice(const std::filesystem::path& library);

/// The shared libraries in a folder and the folders in it, sorted.
std::vector<std::filesystem::path> pluginLibraries(const std::filesystem::path& folder);

}  // namespace perilymph::device
