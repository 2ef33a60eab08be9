// SPDX-License-Identifier: BSD-3-Clause
#include "gui/setup/LandmarkDrawing.h"

#include <QFontMetricsF>
#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>

#include "gui/widgets/Theme.h"
#include "perilymph/anatomy/Population.h"

namespace perilymph::gui {

namespace {

constexpr double step = pi / 60.0;         // between points of the spiral [rad]
constexpr double lastTurn = 3.0 * pi;      // where the drawing ends [rad]
constexpr double ductFraction = 0.58;      // inner / outer radius of the drawn turn
constexpr double sideViewFraction = 0.36;  // of the width
constexpr int narrow_px = 330;             // too narrow for both views

/// Outer radius of the spiral [mm].
double radius_mm(const anatomy::HalfDiameters& half, double angle)
{
  return inMillimeters(meters(anatomy::outerWallRadius(half, radians(angle))));
}

/// A line with a bar at each end.
void paintMeasure(QPainter& painter, const QPointF& from, const QPointF& to)
{
  constexpr double bar_px = 5.0;
  painter.drawLine(from, to);
  const QLineF along(from, to);
  const QLineF across = along.normalVector();
  const QPointF out = (across.p2() - across.p1()) / std::max(across.length(), 1e-9) * bar_px;
  for (const QPointF& end : {from, to}) painter.drawLine(end - out, end + out);
}

}  // namespace

LandmarkDrawing::LandmarkDrawing(QWidget* parent)
    : QWidget(parent), turn_{anatomy::spreadOfA().mean, anatomy::spreadOfB().mean, std::nullopt}
{
  setObjectName(QStringLiteral("landmarkDrawing"));
  setAccessibleName(tr("Landmarks of A, B and H"));
  setMinimumHeight(190);
  setMaximumHeight(300);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
}

void LandmarkDrawing::show(const anatomy::BasalTurn& turn, anatomy::Side side)
{
  turn_ = turn;
  side_ = side;
  update();
}

void LandmarkDrawing::emphasize(Landmark landmark)
{
  emphasized_ = landmark;
  update();
}

void LandmarkDrawing::showPoint(Point point)
{
  point_ = point;
  update();
}

void LandmarkDrawing::paintRing(QPainter& painter, Point point, const QPointF& place) const
{
  if (point != point_) return;
  painter.setPen(QPen(shownTheme().accent, 2.5));
  painter.setBrush(Qt::NoBrush);
  painter.drawEllipse(place, 8.0, 8.0);
  painter.setPen(Qt::NoPen);
  painter.setBrush(shownTheme().accent);
  painter.drawEllipse(place, 3.0, 3.0);
}

QPen LandmarkDrawing::penOf(Landmark landmark) const
{
  const bool isEmphasized = landmark == emphasized_;
  QPen pen(isEmphasized ? shownTheme().accent : shownTheme().text, isEmphasized ? 2.5 : 1.5);
  if (landmark == Landmark::b) pen.setDashPattern({4, 2});
  return pen;
}

void LandmarkDrawing::paintEvent(QPaintEvent*)
{
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  QPainterPath ground;
  ground.addRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), 4, 4);
  painter.fillPath(ground, shownTheme().ground);
  painter.setPen(shownTheme().line);
  painter.drawPath(ground);
  const double split = (1.0 - sideViewFraction) * width();
  const QRectF whole = QRectF(rect()).adjusted(12, sized(18) + 12, -12, -12);
  painter.setFont(typeface(11));
  painter.setPen(shownTheme().quietText);
  if (point_ != Point::none && width() < narrow_px) {
    const bool isBeside = point_ == Point::floor || point_ == Point::apex;
    painter.drawText(QRectF(12, 8, width() - 24, sized(18)), Qt::AlignLeft,
                     isBeside ? tr("Perpendicular view") : tr("Cochlear view"));
    return isBeside ? paintSideView(painter, whole.adjusted(0, 8, 0, -4))
                    : paintCochlearView(painter, whole);
  }
  painter.drawText(QRectF(12, 8, split - 24, sized(18)), Qt::AlignLeft, tr("Cochlear view"));
  painter.drawText(QRectF(split, 8, width() - split - 12, sized(18)), Qt::AlignLeft,
                   tr("Perpendicular view"));
  paintCochlearView(painter, {whole.left(), whole.top(), split - 24, whole.height()});
  paintSideView(painter, {split, whole.top(), width() - split - 12, whole.height()});
}

void LandmarkDrawing::paintCochlearView(QPainter& painter, const QRectF& place) const
{
  const anatomy::HalfDiameters half = anatomy::likeliestHalfDiameters(turn_.a, turn_.b);
  const double mirror = side_ == anatomy::Side::left ? -1.0 : 1.0;
  // the round window straight down, as in the cochlear view of a CT
  const auto direction = [&](double angle) {
    return QPointF(mirror * std::sin(angle), std::cos(angle));
  };
  const double a1 = radius_mm(half, 0.0), a2 = radius_mm(half, pi);
  const double b1 = radius_mm(half, 0.5 * pi), b2 = radius_mm(half, 1.5 * pi);
  const double letters_px = sized(26);  // room for names at both ends
  const double scale = std::min((place.width() - 2.0 * letters_px) / (b1 + b2),
                                (place.height() - letters_px) / (a1 + a2));
  const QPointF axis =
      place.center() - 0.5 * scale * ((a1 - a2) * direction(0.0) + (b1 - b2) * direction(0.5 * pi));
  const auto at = [&](double angle, double radius) {
    return axis + scale * radius * direction(angle);
  };

  QPainterPath outer, inner;
  outer.moveTo(at(0.0, a1));
  inner.moveTo(at(0.0, ductFraction * a1));
  for (double angle = step; angle < lastTurn; angle += step) {
    const double radius = std::max(radius_mm(half, angle), 0.4);
    outer.lineTo(at(angle, radius));
    inner.lineTo(at(angle, ductFraction * radius));
  }
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(shownTheme().quietText, 1.5));
  painter.drawPath(outer);
  painter.setPen(QPen(shownTheme().ahead, 1.0));
  painter.drawPath(inner);

  const QPointF window = at(0.0, a1), far = at(pi, a2);
  painter.setPen(penOf(Landmark::b));
  paintMeasure(painter, at(0.5 * pi, b1), at(1.5 * pi, b2));
  painter.setPen(penOf(Landmark::a));
  paintMeasure(painter, window, far);
  painter.setPen(Qt::NoPen);
  painter.setBrush(shownTheme().warning);
  painter.drawEllipse(window, 4.0, 4.0);
  painter.setBrush(shownTheme().text);
  painter.drawEllipse(axis, 3.0, 3.0);
  paintRing(painter, Point::roundWindow, window);
  paintRing(painter, Point::farWall, far);
  paintRing(painter, Point::nearB, at(0.5 * pi, b1));
  paintRing(painter, Point::farB, at(1.5 * pi, b2));
  paintRing(painter, Point::modiolus, axis);

  painter.setFont(typeface(13, QFont::DemiBold));
  const auto name = [&](Landmark landmark, const QPointF& where, const QString& text) {
    painter.setPen(landmark == emphasized_ ? shownTheme().accent : shownTheme().text);
    QRectF letter(0, 0, sized(40), sized(20));
    letter.moveCenter(where);
    painter.drawText(letter, Qt::AlignCenter, text);
  };
  name(Landmark::a, far + QPointF(sized(14), -4.0), QStringLiteral("A"));
  name(Landmark::b, at(0.5 * pi, b1) + QPointF(mirror * sized(12), -2.0), QStringLiteral("B"));
  painter.setFont(typeface(11));
  painter.setPen(shownTheme().quietText);
  const QString windowName = tr("round window");
  QRectF beside(0, 0, QFontMetricsF(painter.font()).horizontalAdvance(windowName) + 1, sized(18));
  beside.moveCenter(window + QPointF(0.5 * beside.width() + sized(12), 0.0));
  painter.drawText(beside, Qt::AlignCenter, windowName);
  painter.drawText(QRectF(axis.x() + 6, axis.y() + 4, sized(80), sized(18)), Qt::AlignLeft,
                   tr("modiolus"));
}

void LandmarkDrawing::paintSideView(QPainter& painter, const QRectF& place) const
{
  // a cone of turns that narrow toward the apex
  constexpr int turns = 3;
  constexpr double widths[turns] = {1.0, 0.66, 0.36};
  const double wide = std::min(place.width() - 12.0 - sized(22), 1.4 * place.height());
  const double high = 0.8 * wide;
  const double left = place.left() + 6.0, base = place.center().y() + 0.5 * high;
  const double each = high / turns;
  painter.setBrush(Qt::NoBrush);
  for (int i = 0; i < turns; ++i) {
    painter.setPen(QPen(shownTheme().quietText, 1.5));
    const double width = widths[i] * wide;
    painter.drawRoundedRect(QRectF(left + 0.5 * (wide - width), base - (i + 1) * each, width, each),
                            0.45 * each, 0.45 * each);
  }
  painter.setPen(QPen(shownTheme().ahead, 1.0, Qt::DashLine));
  painter.drawLine(QPointF(left + 0.5 * wide, base + 6.0),
                   QPointF(left + 0.5 * wide, base - high - 6.0));
  const double line = left + wide + 12.0;
  painter.setPen(penOf(Landmark::h));
  paintMeasure(painter, {line, base}, {line, base - high});
  painter.setFont(typeface(13, QFont::DemiBold));
  painter.setPen(emphasized_ == Landmark::h ? shownTheme().accent : shownTheme().text);
  QRectF letter(line + 4.0, 0.0, sized(18), sized(20));
  letter.moveCenter({letter.center().x(), base - 0.5 * high});
  painter.drawText(letter, Qt::AlignCenter, QStringLiteral("H"));
  paintRing(painter, Point::floor, {left + 0.5 * wide, base});
  paintRing(painter, Point::apex, {left + 0.5 * wide, base - high});
}

}  // namespace perilymph::gui
