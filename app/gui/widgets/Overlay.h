// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// A frame that stands over a page and follows its size.

#include <QFrame>

namespace perilymph::gui {

/// Placed anew whenever its page gets another size while the frame is shown.
class Overlay : public QFrame {
  Q_OBJECT
public:
  explicit Overlay(QWidget* page);

protected:
  /// Moves the frame to its place on the page.
  virtual void place() = 0;
  bool eventFilter(QObject* target, QEvent* event) override;
};

}  // namespace perilymph::gui
