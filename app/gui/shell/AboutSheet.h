// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Version, license and purpose of the program.

#include <QFrame>

namespace perilymph::gui {

/// An overlay of the page.
class AboutSheet : public QFrame {
  Q_OBJECT
public:
  explicit AboutSheet(QWidget* parent);

Q_SIGNALS:
  void closeAsked();
};

}  // namespace perilymph::gui
