// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Preview of a print figure in the window's colors.

#include <QWidget>

#include "perilymph/figures/Drawing.h"

class QPainter;

namespace perilymph::gui {

/// Paints a drawing as large as the widget allows.
class DrawingView : public QWidget {
  Q_OBJECT
public:
  explicit DrawingView(QWidget* parent);

  void show(figures::Drawing drawing);
  const figures::Drawing& drawing() const { return drawing_; }

protected:
  void paintEvent(QPaintEvent*) override;

private:
  figures::Drawing drawing_;
};

}  // namespace perilymph::gui
