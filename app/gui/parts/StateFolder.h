#pragma once

// Where the program keeps what is its own: its log, and the mark of a run.

#include <filesystem>

namespace perilymph::gui {

/// $XDG_STATE_HOME/perilymph, by default below ~/.local/state.
std::filesystem::path stateFolder();

}  // namespace perilymph::gui
