// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The title of the window.

#include <QString>

namespace perilymph::gui {

class InsertionController;
class Page;

/// "P-017: FLEX28 — Perilymph". The program's name is last: a desktop that adds it finds it there.
QString windowTitleOf(const Page& page, const InsertionController& insertion);

}  // namespace perilymph::gui
