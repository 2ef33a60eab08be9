#pragma once

// Where the things that ship with the program are, and where people's own things go.

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "perilymph/foundation/Result.h"

namespace perilymph {

/// The folder that holds `resources/` and `plugins/`: the environment's PERILYMPH_RESOURCES, else
/// the installed place, else the source tree this program was built from.
std::filesystem::path resourceRoot();

/// The place of a shipped file, such as "resources/scenarios/contour-published.toml".
std::filesystem::path resource(std::string_view relative);

/// Finds a shipped TOML file by a folder and either a bare name or the path of a file: what
/// `--scenario FILE|NAME` means. Names are looked for in the folder and one level below.
/// An unknown name is answered with the names there are.
Result<std::filesystem::path> findByName(std::string_view kind, std::string_view folder,
                                         const std::string& nameOrFile);

/// The names that findByName() knows in a folder, sorted.
std::vector<std::string> shippedNames(std::string_view folder);

/// Where sessions are kept: $XDG_DATA_HOME/perilymph/sessions, by default below ~/.local/share.
std::filesystem::path sessionFolder();

/// Where the patients that were typed in are kept: the folder `patients` beside it.
std::filesystem::path patientFolder();

}  // namespace perilymph
