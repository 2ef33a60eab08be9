// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Connections of the pages, which do not know each other.

namespace perilymph::gui {

class MainWindow;

/// Connects what every page requests with the window, and what particular pages request beyond that.
void linkPages(MainWindow& window);

}  // namespace perilymph::gui
