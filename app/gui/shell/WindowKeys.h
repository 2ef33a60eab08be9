// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Keys of the whole window and their descriptions.

namespace perilymph::gui {

class InsertPage;
class InsertionController;
class KeyActions;
class MainWindow;

/// Adds the section of the window.
void addWindowKeys(KeyActions& keys, MainWindow& window, InsertPage& page);

}  // namespace perilymph::gui
