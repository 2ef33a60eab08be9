// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Curves of several insertions over one axis, with a common cursor.

#include <QWidget>
#include <optional>
#include <vector>

#include "perilymph/analysis/Comparison.h"

namespace perilymph::gui {

/// The line style of a run: color and dashes.
QPen penOfRun(std::size_t run);

/// Axial force over travel. The cursor follows the mouse; Left and Right move it by 0.1 mm, with
/// Shift by 1 mm.
class ComparisonPlot : public QWidget {
  Q_OBJECT
public:
  explicit ComparisonPlot(QWidget* parent);

  void setRuns(std::vector<analysis::ComparedInsertion> runs);
  /// Values drawn behind the curves, or none.
  void setPublished(const std::optional<analysis::Reference>& published);
  void setCursor_mm(double travel_mm);
  double cursor_mm() const { return cursor_mm_; }

Q_SIGNALS:
  void cursorMoved(double travel_mm);

protected:
  void paintEvent(QPaintEvent*) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

private:
  QRectF place() const;
  QPointF at(double travel_mm, double force_N) const;
  void paintAxes(QPainter& painter) const;
  void paintPublished(QPainter& painter) const;
  void paintRuns(QPainter& painter) const;
  void paintCursor(QPainter& painter) const;
  void fitAxes();

  std::vector<analysis::ComparedInsertion> runs_;
  std::optional<analysis::Reference> published_;
  figures::FigureAxis x_, y_;
  double cursor_mm_ = 0.0;
};

}  // namespace perilymph::gui
