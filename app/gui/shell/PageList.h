// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The list of the window's pages.

#include <functional>
#include <vector>

class QWidget;

namespace perilymph::gui {

class InsertionController;
class Page;

/// Makes a page. The insertion continues while any page is shown.
using PageMaker = std::function<Page*(InsertionController& insertion, QWidget* parent)>;

/// In the order of their buttons; InsertPage is one of them. The first one is the start page (Alt+Home); the others have the keys
/// Alt+1, Alt+2 and so on.
using PageList = std::vector<PageMaker>;

PageList standardPages();

}  // namespace perilymph::gui
