#pragma once

// A figure for print, shown as the sheet it will be.

#include <QWidget>

#include "perilymph/analysis/Drawing.h"

class QPainter;

namespace perilymph::gui {

/// Paints a drawing as large as the widget allows, on its white sheet.
class DrawingView : public QWidget {
  Q_OBJECT
public:
  explicit DrawingView(QWidget* parent);

  void show(analysis::Drawing drawing);
  const analysis::Drawing& drawing() const { return drawing_; }

protected:
  void paintEvent(QPaintEvent*) override;

private:
  analysis::Drawing drawing_;
};

}  // namespace perilymph::gui
