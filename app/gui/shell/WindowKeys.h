#pragma once

// What keys do in the whole window, and what the sheet of keys says of them.

namespace perilymph::gui {

class InsertPage;
class KeyActions;
class MainWindow;

/// Adds the section of the window.
void addWindowKeys(KeyActions& keys, MainWindow& window, InsertPage& page);

}  // namespace perilymph::gui
