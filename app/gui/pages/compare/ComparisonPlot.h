// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Curves of several insertions over one axis, with a common cursor.

#include <QPen>
#include <QStringList>
#include <QWidget>
#include <optional>
#include <vector>

#include "perilymph/analysis/ComparisonGroups.h"

namespace perilymph::gui {

/// The line style of a run or of a group: color and dashes.
QPen penOfRun(std::size_t run);

/// The place [m or rad] that is shown as a number in mm or degrees.
double placeAt(analysis::CurveAxis axis, double shown);
/// "3.2 mm", "210°".
QString placeText(analysis::CurveAxis axis, double shown);

/// One curve of the plot.
struct PlottedCurve {
  QPen pen;
  std::vector<analysis::AxisPoint> points;
  std::vector<double> sd;  ///< Standard deviation at each point [N]; empty for a single insertion.
};

/// A mark at a point, with a text beside it.
struct PlottedNote {
  double place = 0.0;  ///< [m] or [rad]
  double force = 0.0;  ///< [N]
  QString text;        ///< Empty: the mark alone.
  QColor color;
};

/// What a plot shows.
struct PlottedContent {
  analysis::CurveAxis axis = analysis::CurveAxis::travel;
  std::vector<PlottedCurve> curves;
  std::vector<PlottedNote> notes;
  std::optional<analysis::Reference> published;  ///< Drawn over travel only.
};

/// Axial force over travel, insertion depth or tip angle. The cursor follows the mouse; Left and Right
/// move it by 0.1 mm or one degree, with Shift by ten times that.
class ComparisonPlot : public QWidget {
  Q_OBJECT
public:
  explicit ComparisonPlot(QWidget* parent);

  void setContent(PlottedContent content);
  const PlottedContent& content() const { return content_; }
  /// "71.8 mN" of each curve at the cursor, with its standard deviation in a group; a dash where a curve
  /// has none.
  QStringList valuesAtCursor() const;
  /// In mm or degrees.
  void setCursorPlace(double place);
  double cursorPlace() const { return cursor_; }

Q_SIGNALS:
  void cursorMoved(double place);

protected:
  void paintEvent(QPaintEvent*) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

private:
  QRectF place() const;
  QPointF at(double shown, double force_N) const;
  QPointF at(const analysis::AxisPoint& point, double offset_N = 0.0) const;
  double step() const;
  void paintAxes(QPainter& painter) const;
  void paintPublished(QPainter& painter) const;
  void paintBands(QPainter& painter) const;
  void paintCurves(QPainter& painter) const;
  void paintNotes(QPainter& painter) const;
  void paintCursor(QPainter& painter) const;
  /// What the curves have at the cursor, in a corner: a line of each and its value.
  void paintValues(QPainter& painter) const;
  void fitAxes();

  PlottedContent content_;
  figures::FigureAxis x_, y_;
  double cursor_ = 0.0;  ///< [mm] or [degrees]
};

}  // namespace perilymph::gui
