#pragma once

// A picture of the window, kept among the user's pictures.

#include <QString>

class QWidget;

namespace perilymph::gui {

/// Writes a PNG named after the time of day; never over another one.
/// @return A sentence that says where it is, or why it could not be kept.
QString keepPicture(QWidget& window);

}  // namespace perilymph::gui
