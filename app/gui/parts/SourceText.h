// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Sentences that a report prints from shipped files: where a value comes from, and what limits it.

#include <QString>

namespace perilymph::gui {

/// Whether a sentence, its numbers replaced by %1, %2 and so on, is one of these and has a
/// translation in the context "Data".
bool isShippedSource(const QString& pattern);

}  // namespace perilymph::gui
