#pragma once

// The language of the window.

#include <QString>

class QCoreApplication;

namespace perilymph::gui {

/// Words and numbers of windows made from now on.
///
/// @param word  "en", "de", or "system" for the language and the numbers of the user's locale.
void useLanguage(QCoreApplication& application, const QString& word);

}  // namespace perilymph::gui
