// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// An error with its remedy, over the 3D view.

#include <QFrame>

class QLabel;

namespace perilymph::gui {

/// Hidden while there is no error.
class Banner : public QFrame {
  Q_OBJECT
public:
  explicit Banner(QWidget* parent);

  void setSentence(const QString& sentence);

private:
  QLabel* text_;
};

}  // namespace perilymph::gui
