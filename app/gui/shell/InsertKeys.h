// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Keys of the insertion page and their descriptions.

#include <functional>

namespace perilymph::gui {

class InsertPage;
class InsertionController;
class KeyActions;

/// Restricts a key action to the insertion page; on other pages the key is not handled.
/// @param act  Receives the index of the key among those of its action.
std::function<bool(int)> onPage(InsertPage& page, std::function<void(int)> act);

/// Adds the sections of insertion, 3D view and replay.
void addInsertKeys(KeyActions& keys, InsertionController& insertion, InsertPage& page);

}  // namespace perilymph::gui
