// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Implementation of --measure-frames with --bone: the bone of a CT that turns.

#include <filesystem>

namespace perilymph::gui {

class MainWindow;

/// Opens a CT, waits for its measured cochlea, turns the bone alone on the page by dragging, and
/// ends the application with its frame times.
void measureBoneFrames(MainWindow& window, const std::filesystem::path& ct);

}  // namespace perilymph::gui
