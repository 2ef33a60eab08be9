#pragma once

// A drawing that fills its widget, for flat views that are drawn anew several times a second.

#include <QWidget>
#include <functional>

#include "perilymph/figures/Drawing.h"

namespace perilymph::gui {

/// Shows what a function draws in the widget's pixels. Painted by Qt: costs no OpenGL context.
class PlotView : public QWidget {
  Q_OBJECT
public:
  using Draw = std::function<figures::Drawing(double width, double height)>;

  PlotView(Draw draw, QWidget* parent);

  /// What it shows has changed.
  void refresh() { update(); }
  QSize minimumSizeHint() const override { return {120, 60}; }

protected:
  void paintEvent(QPaintEvent*) override;

private:
  Draw draw_;
};

}  // namespace perilymph::gui
