// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Content of an overlay that may be larger than the window.

#include <QScrollArea>

namespace perilymph::gui {

/// Shows its content whole where there is space, and scrolls it where there is not.
class SheetScroll : public QScrollArea {
  Q_OBJECT
public:
  SheetScroll(QWidget* content, QWidget* parent);
  QSize sizeHint() const override;
  QSize minimumSizeHint() const override { return {80, 80}; }
};

/// Gives an overlay the size of its content, at most that of its window, and centers it.
void fitSheet(QWidget& sheet);

}  // namespace perilymph::gui
