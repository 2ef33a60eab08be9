// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Devices implemented outside the project as shared libraries: see PluginApi.h.

#include <filesystem>
#include <memory>
#include <stop_token>
#include <string>
#include <vector>

#include "perilymph/device/HapticDevice.h"
#include "perilymph/foundation/Result.h"
#include "perilymph/foundation/Units.h"

namespace perilymph::device {

/// Longest time of loading a plug-in, and of opening its device (a choice): devices that look for their
/// hardware or load their firmware take seconds.
inline constexpr Duration patienceForLoading = Duration::fromSi(10.0);
/// Longest time of a survey: plug-ins that take longer are listed without their traits.
inline constexpr Duration patienceForSurvey = Duration::fromSi(5.0);

/// Loads a plug-in in a process of its own and wraps its device; the process lives as long as the
/// device. A plug-in that crashes or hangs ends with its process, and its force with it: samples are
/// invalid from then on, health() states why, and open() loads it again.
///
/// The error states why a library is refused: not found, not readable, changeable by others, not a
/// plug-in, another version, incomplete, invalid traits, too slow. Loading executes the library's
/// code, never in this process: load only trusted libraries.
///
/// @param stop  Ends loading, and the opening of the device, with an error.
Result<std::unique_ptr<HapticDevice>> loadPluginDevice(const std::filesystem::path& library,
                                                       Duration patience = patienceForLoading,
                                                       const std::stop_token& stop = {});

/// An installed plug-in.
struct FoundPlugin {
  std::filesystem::path file;
  std::string name;     ///< Name of its device; the file's name without ending if it is refused.
  DeviceTraits traits;  ///< As it states them; only if it is usable.
  Sentence obstacle;    ///< Why it cannot be used; empty if it can.

  bool isUsable() const noexcept { return obstacle.empty(); }
};

/// The folders in which plug-ins are installed: the user's own ($XDG_DATA_HOME/perilymph/plugins, by
/// default in ~/.local/share), then that of the package.
std::vector<std::filesystem::path> pluginFolders();

/// The shared libraries in a folder and its subfolders, sorted.
std::vector<std::filesystem::path> pluginLibraries(const std::filesystem::path& folder);

/// Loads all installed plug-ins at once for a moment, each in a process of its own, without opening
/// their devices: whether one is connected shows when it is opened. Takes as long as the slowest, at
/// most `patience`.
std::vector<FoundPlugin> surveyPlugins(
    const std::vector<std::filesystem::path>& folders = pluginFolders(),
    Duration patience = patienceForSurvey);

/// The plug-in with this path, else that with this device name or file name (with or without its
/// ending); null if none has it. An error if several have it, with their paths.
Result<const FoundPlugin*> pluginNamed(const std::vector<FoundPlugin>& survey,
                                       const std::string& name);

}  // namespace perilymph::device
