#pragma once

// What is left of an insertion that the end of the program interrupted.

#include <filesystem>
#include <functional>
#include <vector>

#include "perilymph/session/SessionLibrary.h"

namespace perilymph::gui {

class MainWindow;

/// Reads a recording until it is told to stop, as session::summarize does.
using Summarize = std::function<session::SessionSummary(const std::filesystem::path&,
                                                        const std::function<bool()>& shouldStop)>;

/// Says, once the window is on the screen, what is kept of the insertions that ended with the
/// program, and offers to show them. A recording is read beside the UI thread: one that cannot be
/// read keeps the window from nothing.
void offerRecovery(MainWindow& window, const std::vector<std::filesystem::path>& recordings,
                   const Summarize& summarize = session::summarize);

}  // namespace perilymph::gui
