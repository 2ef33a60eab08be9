// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Sentences of the engine, which speaks English, and texts of shipped files in the window's language.

#include <QString>

#include "perilymph/figures/Figure.h"
#include "perilymph/foundation/Sentence.h"

namespace perilymph::gui {

/// A sentence in the window's language, the numbers in it with the window's decimal sign; a text of a
/// shipped file as its translation says. What has no translation stays English.
QString dataText(const Sentence& text);

/// A figure with all its texts in the window's language.
figures::Figure translated(figures::Figure figure);

}  // namespace perilymph::gui
