// SPDX-License-Identifier: BSD-3-Clause
#include "gui/pages/compare/ComparisonPlot.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <array>
#include <cmath>

#include "gui/text/Numbers.h"
#include "gui/widgets/FocusRing.h"
#include "gui/widgets/Theme.h"

namespace perilymph::gui {

namespace {

constexpr double left_px = 56.0, right_px = 20.0, top_px = 36.0, bottom_px = 44.0;
// Below the resolution of the plot: the vibration of an array at rest does not move the axis.
constexpr double negligible_N = 0.01;
constexpr double step_mm = 0.1, bigStep_mm = 1.0;

double millimetersOf(double travel) { return inMillimeters(meters(travel)); }

}  // namespace

QPen penOfRun(std::size_t run)
{
  const Theme& theme = shownTheme();
  const std::array<QColor, 4> colors = {theme.accent, theme.ghost, theme.warning, theme.pink};
  QPen pen(colors[run % colors.size()], 2.0, Qt::SolidLine, Qt::FlatCap, Qt::RoundJoin);
  const std::array<QVector<qreal>, 4> dashes = {QVector<qreal>{}, QVector<qreal>{5, 2},
                                                QVector<qreal>{2, 2}, QVector<qreal>{7, 2, 1.5, 2}};
  const auto& dash = dashes[(run + run / colors.size()) % dashes.size()];
  if (!dash.isEmpty()) pen.setDashPattern(dash);
  return pen;
}

ComparisonPlot::ComparisonPlot(QWidget* parent) : QWidget(parent)
{
  setObjectName(QStringLiteral("comparisonPlot"));
  setAccessibleName(tr("Insertion force over travel"));
  setMouseTracking(true);
  setFocusPolicy(Qt::StrongFocus);
  setMinimumHeight(200);
  setFont(typeface(11));
  fitAxes();
}

void ComparisonPlot::setRuns(std::vector<analysis::ComparedInsertion> runs)
{
  runs_ = std::move(runs);
  fitAxes();
  update();
}

void ComparisonPlot::setPublished(const std::optional<analysis::Reference>& published)
{
  published_ = published;
  fitAxes();
  update();
}

void ComparisonPlot::fitAxes()
{
  // initial ranges equal to those of the insertion chart
  double nearest = 0.0, farthest = 17.0, lowest = 0.0, highest = 0.2;
  for (const analysis::ComparedInsertion& run : runs_)
    for (const analysis::CurvePoint& point : run.profile.curve) {
      nearest = std::min(nearest, millimetersOf(point.travel));
      farthest = std::max(farthest, millimetersOf(point.travel));
      lowest = std::min(lowest, point.force);
      highest = std::max(highest, point.force);
    }
  if (lowest > -negligible_N) lowest = 0.0;
  x_ = figures::axisOver({}, nearest, farthest);
  y_ = figures::axisOver({}, lowest, highest);
  cursor_mm_ = std::clamp(cursor_mm_, x_.low, x_.high);
}

QRectF ComparisonPlot::place() const
{
  return QRectF(rect()).adjusted(left_px, top_px, -right_px, -bottom_px);
}

QPointF ComparisonPlot::at(double travel_mm, double force_N) const
{
  const QRectF inside = place();
  return {inside.left() + (travel_mm - x_.low) / (x_.high - x_.low) * inside.width(),
          inside.bottom() - (force_N - y_.low) / (y_.high - y_.low) * inside.height()};
}

void ComparisonPlot::setCursor_mm(double travel_mm)
{
  const double inside = std::clamp(travel_mm, x_.low, x_.high);
  if (inside == cursor_mm_) return;
  cursor_mm_ = inside;
  update();
  Q_EMIT cursorMoved(cursor_mm_);
}

void ComparisonPlot::paintEvent(QPaintEvent*)
{
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  QPainterPath ground;
  ground.addRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), 4.0, 4.0);
  painter.fillPath(ground, shownTheme().ground);
  painter.setPen(shownTheme().line);
  painter.drawPath(ground);
  paintAxes(painter);
  paintCursor(painter);
  painter.save();
  painter.setClipRect(place().adjusted(-6, -6, 6, 6));
  paintPublished(painter);
  paintRuns(painter);
  painter.restore();
  if (hasFocus()) paintFocusRing(painter, rect());
}

void ComparisonPlot::paintAxes(QPainter& painter) const
{
  painter.setFont(typeface(11));
  const QRectF inside = place();
  const auto ticksOf = [](const figures::FigureAxis& axis) {
    return int(std::lround((axis.high - axis.low) / axis.tick));
  };
  for (int i = 0; i <= ticksOf(y_); ++i) {
    const double force = y_.low + i * y_.tick;
    const QPointF here = at(x_.low, force);
    painter.setPen(QPen(shownTheme().line, 1.0));
    painter.drawLine(here, QPointF(inside.right(), here.y()));
    painter.setPen(shownTheme().quietText);
    painter.drawText(QRectF(0, here.y() - 10, left_px - 8, 20), Qt::AlignRight | Qt::AlignVCenter,
                     numberText(inMillinewtons(newtons(force)), 0));
  }
  for (int i = 0; i <= ticksOf(x_); ++i) {
    const double travel = x_.low + i * x_.tick;
    const QPointF here = at(travel, y_.low);
    painter.setPen(QPen(shownTheme().line, 1.0));
    painter.drawLine(here, QPointF(here.x(), inside.top()));
    painter.setPen(shownTheme().quietText);
    painter.drawText(QRectF(here.x() - 30, here.y() + 4, 60, 16), Qt::AlignCenter,
                     numberText(travel, 0));
  }
  painter.drawText(QRectF(inside.left(), inside.bottom() + 22, inside.width(), 18), Qt::AlignCenter,
                   tr("travel, mm"));
  painter.drawText(QRectF(8, 8, 260, 20), Qt::AlignLeft | Qt::AlignVCenter,
                   tr("insertion force, mN"));
}

void ComparisonPlot::paintPublished(QPainter& painter) const
{
  if (!published_ || published_->points.empty()) return;
  constexpr double cap_px = 4.0, ring_px = 4.0;
  for (const analysis::PrintedForce& point : published_->points) {
    const double travel = millimetersOf(point.travel);
    const QPointF low = at(travel, point.mean - point.standardDeviation);
    const QPointF high = at(travel, point.mean + point.standardDeviation);
    painter.setPen(QPen(shownTheme().text, 1.0));
    painter.drawLine(low, high);
    for (const QPointF& end : {low, high})
      painter.drawLine(end - QPointF(cap_px, 0), end + QPointF(cap_px, 0));
    painter.setPen(QPen(shownTheme().text, 1.6));
    painter.setBrush(shownTheme().ground);
    painter.drawEllipse(at(travel, point.mean), ring_px, ring_px);
  }
}

void ComparisonPlot::paintRuns(QPainter& painter) const
{
  painter.setBrush(Qt::NoBrush);
  for (std::size_t i = 0; i < runs_.size(); ++i) {
    QPolygonF line;
    for (const analysis::CurvePoint& point : runs_[i].profile.curve)
      line << at(millimetersOf(point.travel), point.force);
    painter.setPen(penOfRun(i));
    painter.drawPolyline(line);
  }
}

void ComparisonPlot::paintCursor(QPainter& painter) const
{
  if (runs_.empty()) return;
  const QRectF inside = place();
  const double x = at(cursor_mm_, 0.0).x();
  painter.setPen(QPen(shownTheme().quietText, 1.0));
  painter.drawLine(QPointF(x, inside.top()), QPointF(x, inside.bottom()));
  for (std::size_t i = 0; i < runs_.size(); ++i) {
    const auto force = analysis::forceAt(runs_[i].profile.curve, millimeters(cursor_mm_).si());
    if (!force) continue;
    painter.setPen(QPen(shownTheme().ground, 1.5));
    painter.setBrush(penOfRun(i).color());
    painter.drawEllipse(at(cursor_mm_, *force), 4.5, 4.5);
  }
  const QString text = tr("%1 mm").arg(numberText(cursor_mm_, 1));
  const bool isRight = x > inside.right() - 70.0;
  painter.setPen(shownTheme().text);
  painter.drawText(QRectF(isRight ? x - 76 : x + 6, inside.top() - 22, 70, 20),
                   int(isRight ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter, text);
}

void ComparisonPlot::mousePressEvent(QMouseEvent* event) { mouseMoveEvent(event); }

void ComparisonPlot::mouseMoveEvent(QMouseEvent* event)
{
  const QRectF inside = place();
  const double fraction = (event->pos().x() - inside.left()) / inside.width();
  const double travel = x_.low + fraction * (x_.high - x_.low);
  setCursor_mm(std::round(travel / step_mm) * step_mm);
}

void ComparisonPlot::keyPressEvent(QKeyEvent* event)
{
  const bool isShift = (event->modifiers() & Qt::ShiftModifier) != 0;
  const double step = isShift ? bigStep_mm : step_mm;
  if (event->key() == Qt::Key_Left) return setCursor_mm(cursor_mm_ - step);
  if (event->key() == Qt::Key_Right) return setCursor_mm(cursor_mm_ + step);
  QWidget::keyPressEvent(event);
}

}  // namespace perilymph::gui
