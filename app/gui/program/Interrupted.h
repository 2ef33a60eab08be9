#pragma once

// What is left of a run that ended without a word, offered to whoever starts the program next.

#include <filesystem>
#include <vector>

namespace perilymph::gui {

class MainWindow;

/// Once its first frame is shown, the window offers the library of sessions for a recording that
/// was being written when the program ended; says nothing of one in which nothing had moved.
void offerInterrupted(MainWindow& window, const std::vector<std::filesystem::path>& recordings);

}  // namespace perilymph::gui
