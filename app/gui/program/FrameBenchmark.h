// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Implementation of --measure-frames: automatic insertions and their frame times.

#include <cstdint>
#include <optional>

namespace perilymph::gui {

class MainWindow;

/// Starts the demonstration in a window as large as the screen, prints frame times and late ticks at its end, and ends the
/// application.
///
/// @param ticks  If given: inserts and withdraws until this number of ticks was recorded, and
///               compares the frame times of the last insertion with the first, to detect slowdown.
void measureFrames(MainWindow& window, std::optional<std::uint64_t> ticks);

}  // namespace perilymph::gui
