// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Version, license and purpose of the program.

#include <QFrame>

namespace perilymph::gui {

/// An overlay of the page.
class AboutOverlay : public QFrame {
  Q_OBJECT
public:
  explicit AboutOverlay(QWidget* parent);

Q_SIGNALS:
  void closeRequested();
};

}  // namespace perilymph::gui
