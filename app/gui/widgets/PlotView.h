// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// A widget showing a drawing that is updated several times a second.

#include <QWidget>
#include <functional>

#include "perilymph/figures/Drawing.h"

namespace perilymph::gui {

/// Shows the drawing made by a function, in the widget's pixels. Painted by Qt, without an OpenGL
/// context.
class PlotView : public QWidget {
  Q_OBJECT
public:
  using Draw = std::function<figures::Drawing(double width, double height)>;

  PlotView(Draw draw, QWidget* parent);

  /// The drawing must be updated.
  void refresh() { update(); }
  QSize minimumSizeHint() const override { return {120, 60}; }

protected:
  void paintEvent(QPaintEvent*) override;

private:
  Draw draw_;
};

}  // namespace perilymph::gui
