// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Location of the program's own state.

#include <filesystem>

namespace perilymph {

/// Folder of log, crash marker, plans and where CTs were read: $XDG_STATE_HOME/perilymph, by default in
/// ~/.local/state.
std::filesystem::path stateFolder();

/// Folder of the plans made in the window, a folder each: `plans` in the state folder.
std::filesystem::path plansFolder();

}  // namespace perilymph
