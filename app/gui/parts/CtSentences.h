// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Sentences about a CT and the cochlea measured in it, which the engine says in English.

#include <QString>

namespace perilymph::gui {

/// Whether a sentence, its numbers replaced by %1, %2 and so on, is one of these and has a
/// translation in the context "Data".
bool isCtSentence(const QString& pattern);

}  // namespace perilymph::gui
