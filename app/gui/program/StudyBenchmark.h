// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Implementation of --measure-frames with --study: a filter that changes with every frame.

#include <filesystem>

namespace perilymph::gui {

class MainWindow;

/// Opens a study, moves the limit of the cochlear size with every frame, prints frame times and ends
/// the application.
void measureStudyFrames(MainWindow& window, const std::filesystem::path& file);

}  // namespace perilymph::gui
