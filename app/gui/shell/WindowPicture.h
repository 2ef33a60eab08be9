// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Screenshots of the window, saved among the user's pictures.

#include <QString>

class QWidget;

namespace perilymph::gui {

/// Writes a PNG named by the time of day; never overwrites a file.
/// @return A message with its path, or why it could not be saved.
QString keepPicture(QWidget& window);

}  // namespace perilymph::gui
