// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Folder of the program's own state: log and crash marker.

#include <filesystem>

namespace perilymph::gui {

/// $XDG_STATE_HOME/perilymph, by default in ~/.local/state.
std::filesystem::path stateFolder();

}  // namespace perilymph::gui
