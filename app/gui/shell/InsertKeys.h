#pragma once

// What keys do on the page of the insertion, and what the sheet of keys says of them.

#include <functional>

namespace perilymph::gui {

class InsertPage;
class KeyActions;

/// What a key does while the page of the insertion is shown; when it is not, the key is for others.
/// @param act  Given the place of the key among those of its action.
std::function<bool(int)> onPage(InsertPage& page, std::function<void(int)> act);

/// Adds the sections of the insertion, the picture and the replay.
void addInsertKeys(KeyActions& keys, InsertPage& page);

}  // namespace perilymph::gui
