#pragma once

// What the charts say, in the window's language.

namespace perilymph::gui {

/// Gives the charts their words; after the language was chosen, before a window is made.
void translateCharts();

}  // namespace perilymph::gui
