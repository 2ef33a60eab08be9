// SPDX-License-Identifier: BSD-3-Clause
#include "gui/widgets/Icon.h"

#include <QPainter>
#include <QPainterPath>
#include <cmath>

#include "gui/widgets/Theme.h"
#include "perilymph/foundation/Units.h"

namespace perilymph::gui {

namespace {

/// Icons are drawn in a square of this size.
constexpr double box = 16.0;
constexpr double line = 1.5;

void paintHome(QPainter& painter)
{
  painter.drawPolyline(QPolygonF({{1.5, 8.0}, {8.0, 2.2}, {14.5, 8.0}}));
  painter.drawPolyline(QPolygonF({{3.6, 6.8}, {3.6, 13.8}, {12.4, 13.8}, {12.4, 6.8}}));
}

/// A picture with a crosshair.
void paintCt(QPainter& painter)
{
  painter.drawRoundedRect(QRectF(1.5, 1.5, 13.0, 13.0), 2.0, 2.0);
  for (int side = 0; side < 4; ++side) {
    painter.drawLine(QPointF(8.0, 4.0), QPointF(8.0, 6.2));
    painter.translate(8.0, 8.0);
    painter.rotate(90.0);
    painter.translate(-8.0, -8.0);
  }
  painter.drawPoint(QPointF(8.0, 8.0));
}

/// Bands of three arrays with their medians.
void paintPlan(QPainter& painter)
{
  constexpr double bands[][3] = {{2.0, 10.0, 6.5}, {5.0, 14.0, 10.5}, {3.5, 8.5, 6.0}};
  for (int row = 0; row < 3; ++row) {
    const double y = 3.2 + 4.8 * row;
    painter.drawLine(QPointF(bands[row][0], y), QPointF(bands[row][1], y));
    painter.drawLine(QPointF(bands[row][2], y - 1.8), QPointF(bands[row][2], y + 1.8));
  }
}

/// An array in the turns of a cochlea.
void paintInsert(QPainter& painter)
{
  QPainterPath spiral(QPointF(1.0, 14.2));
  spiral.lineTo(8.6, 14.2);
  constexpr int steps = 48;
  for (int i = 0; i <= steps; ++i) {
    const double part = double(i) / steps;
    const double angle = (0.5 - 2.0 * 1.6 * part) * pi;
    const double radius = 6.0 - 4.6 * part;
    spiral.lineTo(8.6 + radius * std::cos(angle), 8.2 + radius * std::sin(angle));
  }
  painter.drawPath(spiral);
}

/// Values beside what was predicted: points about a diagonal.
void paintOutcomes(QPainter& painter)
{
  painter.drawPolyline(QPolygonF({{1.8, 1.5}, {1.8, 14.2}, {14.5, 14.2}}));
  painter.drawLine(QPointF(3.6, 12.4), QPointF(13.6, 2.4));
  for (const QPointF& each : {QPointF(5.0, 9.0), QPointF(9.6, 8.4), QPointF(12.4, 5.6)})
    painter.drawEllipse(each, 0.8, 0.8);
}

/// Contacts along a spiral, the last one found in a ring.
void paintOutcome(QPainter& painter)
{
  QPainterPath course(QPointF(2.0, 13.6));
  course.cubicTo(8.0, 14.8, 14.2, 12.0, 14.0, 7.6);
  course.cubicTo(13.8, 3.4, 7.2, 2.4, 6.0, 6.4);
  painter.drawPath(course);
  painter.drawEllipse(QPointF(6.4, 8.2), 2.0, 2.0);
  painter.drawEllipse(QPointF(13.6, 6.2), 0.9, 0.9);
  painter.drawEllipse(QPointF(9.0, 13.8), 0.9, 0.9);
}

/// Two curves over one axis.
void paintCompare(QPainter& painter)
{
  painter.drawPolyline(QPolygonF({{1.8, 1.5}, {1.8, 14.2}, {14.5, 14.2}}));
  QPainterPath one(QPointF(4.0, 11.5));
  one.cubicTo(8.0, 11.0, 8.5, 3.0, 14.0, 2.6);
  QPainterPath other(QPointF(4.0, 8.5));
  other.cubicTo(7.0, 4.0, 10.0, 11.0, 14.0, 8.4);
  painter.drawPath(one);
  painter.drawPath(other);
}

/// A check mark in a circle.
void paintValidate(QPainter& painter)
{
  painter.drawEllipse(QPointF(8.0, 8.0), 6.5, 6.5);
  painter.drawPolyline(QPolygonF({{4.9, 8.3}, {7.2, 10.6}, {11.2, 5.6}}));
}

/// A recording to be played.
void paintSessions(QPainter& painter)
{
  painter.drawRoundedRect(QRectF(1.5, 2.5, 13.0, 11.0), 2.0, 2.0);
  painter.drawPolygon(QPolygonF({{6.4, 5.4}, {10.8, 8.0}, {6.4, 10.6}}));
}

/// Points over two axes.
void paintStudies(QPainter& painter)
{
  painter.drawPolyline(QPolygonF({{1.8, 1.5}, {1.8, 14.2}, {14.5, 14.2}}));
  painter.setBrush(painter.pen().color());
  painter.setPen(Qt::NoPen);
  constexpr double points[][2] = {{5.0, 10.6}, {7.4, 7.8}, {10.4, 9.6}, {9.6, 4.8}, {13.2, 3.4}};
  for (const auto& at : points) painter.drawEllipse(QPointF(at[0], at[1]), 1.3, 1.3);
}

/// A gear with eight teeth.
void paintSettings(QPainter& painter)
{
  constexpr double radius = 5.0, tooth = 2.1;
  painter.translate(0.5 * box, 0.5 * box);
  painter.drawEllipse(QPointF(0.0, 0.0), radius, radius);
  painter.drawEllipse(QPointF(0.0, 0.0), 0.35 * radius, 0.35 * radius);
  QPen teeth = painter.pen();
  teeth.setWidthF(2.0);
  teeth.setCapStyle(Qt::FlatCap);
  painter.setPen(teeth);
  for (int i = 0; i < 8; ++i) {
    painter.drawLine(QPointF(radius, 0.0), QPointF(radius + tooth, 0.0));
    painter.rotate(45.0);
  }
}

void paint(Icon icon, QPainter& painter)
{
  switch (icon) {
    case Icon::home:
      return paintHome(painter);
    case Icon::ct:
      return paintCt(painter);
    case Icon::plan:
      return paintPlan(painter);
    case Icon::insert:
      return paintInsert(painter);
    case Icon::outcome:
      return paintOutcome(painter);
    case Icon::compare:
      return paintCompare(painter);
    case Icon::validate:
      return paintValidate(painter);
    case Icon::sessions:
      return paintSessions(painter);
    case Icon::studies:
      return paintStudies(painter);
    case Icon::outcomes:
      return paintOutcomes(painter);
    case Icon::settings:
      return paintSettings(painter);
  }
}

QPixmap pictureOf(Icon icon, int size_px, double pixelRatio, const QColor& color)
{
  QPixmap picture(QSize(size_px, size_px) * pixelRatio);
  picture.setDevicePixelRatio(pixelRatio);
  picture.fill(Qt::transparent);
  QPainter painter(&picture);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.scale(size_px / box, size_px / box);
  painter.setPen(QPen(color, line, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  paint(icon, painter);
  return picture;
}

}  // namespace

QIcon iconOf(Icon icon, int size_px, double pixelRatio)
{
  QIcon made(pictureOf(icon, size_px, pixelRatio, shownTheme().quietText));
  made.addPixmap(pictureOf(icon, size_px, pixelRatio, shownTheme().text), QIcon::Normal, QIcon::On);
  return made;
}

}  // namespace perilymph::gui
