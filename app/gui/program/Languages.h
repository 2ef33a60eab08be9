// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The language of the window.

#include <QString>

class QCoreApplication;

namespace perilymph::gui {

/// Sets texts and number format of windows made afterwards.
///
/// @param word  "en", "de", or "system" for the user's locale.
void useLanguage(QCoreApplication& application, const QString& word);

}  // namespace perilymph::gui
