// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Translation of texts that come from data files and from the engine, which speaks English.

#include <QString>
#include <string>

#include "perilymph/figures/Figure.h"

namespace perilymph::gui {

/// A shipped text in the window's language, its numbers with the window's decimal sign. Unknown
/// texts are returned unchanged.
QString dataText(const std::string& text);

/// A figure with all its texts in the window's language.
figures::Figure translated(figures::Figure figure);

}  // namespace perilymph::gui
