// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// What a window that is made again, for other colors or another language, continues.

#include <QString>

#include "gui/pages/insert/InsertionController.h"

namespace perilymph::gui {

class MainWindow;

struct WindowMemory {
  InsertionController::Memory insertion;
  QString focus;  ///< Name of the widget with the keyboard focus; empty for the window itself.
};

WindowMemory memoryOf(MainWindow& window);
/// Continues in a new window with the same scenario, before it is opened.
void resume(MainWindow& window, const WindowMemory& memory);

}  // namespace perilymph::gui
