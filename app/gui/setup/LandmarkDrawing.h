// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Drawing of the landmarks that a patient's measures refer to.

#include <QWidget>

#include "perilymph/anatomy/Patient.h"

namespace perilymph::gui {

/// The cochlear view with A and B, and the view perpendicular to it with H. The spiral is that of
/// the typed A and B (Pietsch et al. 2017), to scale; a left ear is the mirror image.
class LandmarkDrawing : public QWidget {
  Q_OBJECT
public:
  enum class Landmark { none, a, b, h };
  /// The ends of A, B and H, and the modiolus.
  enum class Point { none, roundWindow, farWall, nearB, farB, floor, apex, modiolus };

  explicit LandmarkDrawing(QWidget* parent);

  void show(const anatomy::BasalTurn& turn, anatomy::Side side);
  /// Emphasizes the measure of the field with the focus.
  void emphasize(Landmark landmark);
  /// Rings the point that is being placed. A narrow drawing shows the view that has it, alone.
  void showPoint(Point point);

  QSize sizeHint() const override { return {400, 250}; }
  QSize minimumSizeHint() const override { return {240, 160}; }

protected:
  void paintEvent(QPaintEvent*) override;

private:
  void paintCochlearView(QPainter& painter, const QRectF& place) const;
  void paintSideView(QPainter& painter, const QRectF& place) const;
  void paintRing(QPainter& painter, Point point, const QPointF& place) const;
  QPen penOf(Landmark landmark) const;

  anatomy::BasalTurn turn_;
  anatomy::Side side_ = anatomy::Side::right;
  Landmark emphasized_ = Landmark::none;
  Point point_ = Point::none;
};

}  // namespace perilymph::gui
