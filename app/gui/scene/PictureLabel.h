// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Small texts on the 3D view.

class QLabel;
class QWidget;

namespace perilymph::gui {

/// A quiet text on its plate, which lets the mouse through.
QLabel* pictureLabel(QWidget* parent, const char* name);
/// The same in one line that yields to others where the view is narrow.
QLabel* elidedPictureLabel(QWidget* parent, const char* name);

}  // namespace perilymph::gui
