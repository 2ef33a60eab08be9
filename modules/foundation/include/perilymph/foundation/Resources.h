// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Locations of shipped files and of the user's own files.

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "perilymph/foundation/Result.h"

namespace perilymph {

/// The folder that contains `resources/` and `plugins/`: the environment variable
/// PERILYMPH_RESOURCES, else the installation, else the source tree this program was built from.
std::filesystem::path resourceRoot();

/// Path of a shipped file, such as "resources/scenarios/contour-published.toml".
std::filesystem::path resource(std::string_view relative);

/// Resolves `FILE|NAME`, as in `--scenario FILE|NAME`, to the path of a TOML file. Bare names are
/// searched in the folder and one level below. The error for an unknown name lists the known ones.
Result<std::filesystem::path> findByName(std::string_view kind, std::string_view folder,
                                         const std::string& nameOrFile);

/// The names that findByName() accepts in a folder, sorted.
std::vector<std::string> shippedNames(std::string_view folder);

/// The TOML files in a folder and its direct subfolders, sorted by path.
std::vector<std::filesystem::path> tomlFilesIn(const std::filesystem::path& folder);

/// Folder of the user's own device profiles: `devices` beside the folder of recordings.
std::filesystem::path deviceProfileFolder();

/// Folder of recorded sessions: $XDG_DATA_HOME/perilymph/sessions, by default in ~/.local/share.
std::filesystem::path sessionFolder();

/// Folder of the patients entered by the user: `patients` beside the folder of recordings.
std::filesystem::path patientFolder();

}  // namespace perilymph
