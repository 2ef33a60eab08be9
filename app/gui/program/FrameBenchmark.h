#pragma once

// What --measure-frames does: insertions by themselves, and what their frames took.

#include <cstdint>
#include <optional>

namespace perilymph::gui {

class MainWindow;

/// Starts the demonstration, prints at its end what its frames took and how many of its ticks were
/// late, and ends the application.
///
/// @param ticks  With it: goes in and out until so many ticks were recorded. The frames of the last
///               way in are then set beside those of the first, for a window must not grow slow.
void measureFrames(MainWindow& window, std::optional<std::uint64_t> ticks);

}  // namespace perilymph::gui
