// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// A cochlea in the cochlear view on paper: the scala tympani within a ring of angles, with a scale
// bar and the name of the ear.

#include "gui/report/InsertionPicture.h"
#include "gui/report/ReportSheet.h"
#include "gui/report/ScalaProjection.h"

namespace perilymph::gui {

/// Maps the projection's millimeters to a rectangle of a page [dots].
class CochlearView {
public:
  /// @param hasRing  Whether there is room for paintFrame() around the cochlea.
  CochlearView(const QRectF& place, const anatomy::ScalaTympani& scala, anatomy::Side side,
               bool hasRing = true);

  const ScalaProjection& plane() const { return plane_; }
  /// Dots per millimeter of the cochlea.
  double scale() const { return scale_; }
  QPointF operator()(const QPointF& point_mm) const { return center_ + scale_ * point_mm; }

  /// Paints scala and array of `pictured` as an image: abutting areas show seams if they are
  /// smoothed one by one.
  void paintScala(QPainter& painter, const PicturedInsertion& pictured) const;
  /// Paints ring, scale bar and ear.
  void paintFrame(ReportSheet& sheet) const;

private:
  void paintRing(ReportSheet& sheet) const;

  QRectF place_;
  QPointF center_;
  anatomy::Side side_;
  ScalaProjection plane_;
  double radius_mm_, half_mm_;
  double scale_;
};

/// Draws text with its center at a point.
void drawCentered(QPainter& painter, const QPointF& at, const QString& text);

}  // namespace perilymph::gui
