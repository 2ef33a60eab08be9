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
constexpr int bigSteps = 10;
constexpr int valueDecimals = 1;  // of a force at the cursor, as in the tables

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

double placeAt(analysis::CurveAxis axis, double shown)
{
  return axis == analysis::CurveAxis::angle ? degrees(shown).si() : millimeters(shown).si();
}

QString placeText(analysis::CurveAxis axis, double shown)
{
  return axis == analysis::CurveAxis::angle ? ComparisonPlot::tr("%1°").arg(numberText(shown, 0))
                                            : ComparisonPlot::tr("%1 mm").arg(numberText(shown, 1));
}

ComparisonPlot::ComparisonPlot(QWidget* parent) : QWidget(parent)
{
  setObjectName(QStringLiteral("comparisonPlot"));
  setAccessibleName(tr("Insertion force"));
  setMouseTracking(true);
  setFocusPolicy(Qt::StrongFocus);
  setMinimumHeight(sized(200));
  setFont(typeface(11));
  fitAxes();
}

void ComparisonPlot::setContent(PlottedContent content)
{
  content_ = std::move(content);
  fitAxes();
  update();
}

double ComparisonPlot::step() const
{
  return analysis::shownPlace(content_.axis, analysis::stepOf(content_.axis));
}

void ComparisonPlot::fitAxes()
{
  // initial ranges: those of the insertion chart, one turn of the cochlea
  double nearest = 0.0, farthest = content_.axis == analysis::CurveAxis::angle ? 360.0 : 17.0;
  double lowest = 0.0, highest = 0.05;
  for (const PlottedCurve& curve : content_.curves)
    for (std::size_t i = 0; i < curve.points.size(); ++i) {
      const double sd = curve.sd.empty() ? 0.0 : curve.sd[i];
      nearest = std::min(nearest, analysis::shownPlace(content_.axis, curve.points[i].place));
      farthest = std::max(farthest, analysis::shownPlace(content_.axis, curve.points[i].place));
      lowest = std::min(lowest, curve.points[i].force - sd);
      highest = std::max(highest, curve.points[i].force + sd);
    }
  if (content_.published)
    for (const analysis::PrintedForce& point : content_.published->points)
      highest = std::max(highest, point.mean + point.standardDeviation);
  if (lowest > -negligible_N) lowest = 0.0;
  x_ = figures::axisOver({}, nearest, farthest);
  y_ = figures::axisOver({}, lowest, highest);
  cursor_ = std::clamp(cursor_, x_.low, x_.high);
}

QRectF ComparisonPlot::place() const
{
  return QRectF(rect()).adjusted(left_px, top_px, -right_px, -bottom_px);
}

QPointF ComparisonPlot::at(double shown, double force_N) const
{
  const QRectF inside = place();
  return {inside.left() + (shown - x_.low) / (x_.high - x_.low) * inside.width(),
          inside.bottom() - (force_N - y_.low) / (y_.high - y_.low) * inside.height()};
}

QPointF ComparisonPlot::at(const analysis::AxisPoint& point, double offset_N) const
{
  return at(analysis::shownPlace(content_.axis, point.place), point.force + offset_N);
}

void ComparisonPlot::setCursorPlace(double place)
{
  const double inside = std::clamp(place, x_.low, x_.high);
  if (inside == cursor_) return;
  cursor_ = inside;
  update();
  Q_EMIT cursorMoved(cursor_);
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
  paintBands(painter);
  paintCurves(painter);
  paintNotes(painter);
  painter.restore();
  paintValues(painter);
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
  const QString titles[] = {tr("travel, mm"), tr("insertion depth, mm"), tr("tip angle, °")};
  painter.drawText(QRectF(inside.left(), inside.bottom() + 22, inside.width(), 18), Qt::AlignCenter,
                   titles[int(content_.axis)]);
  painter.drawText(QRectF(8, 8, 260, 20), Qt::AlignLeft | Qt::AlignVCenter,
                   tr("insertion force, mN"));
}

void ComparisonPlot::paintPublished(QPainter& painter) const
{
  const auto& published = content_.published;
  if (!published || content_.axis != analysis::CurveAxis::travel) return;
  constexpr double cap_px = 4.0, ring_px = 4.0;
  for (const analysis::PrintedForce& point : published->points) {
    const double travel = inMillimeters(meters(point.travel));
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

void ComparisonPlot::paintBands(QPainter& painter) const
{
  painter.setPen(Qt::NoPen);
  for (const PlottedCurve& curve : content_.curves) {
    if (curve.sd.empty()) continue;
    QPolygonF band;
    for (std::size_t i = 0; i < curve.points.size(); ++i) band << at(curve.points[i], curve.sd[i]);
    for (std::size_t i = curve.points.size(); i-- > 0;) band << at(curve.points[i], -curve.sd[i]);
    QColor tint = curve.pen.color();
    tint.setAlphaF(0.18f);
    painter.setBrush(tint);
    painter.drawPolygon(band);
  }
}

void ComparisonPlot::paintCurves(QPainter& painter) const
{
  painter.setBrush(Qt::NoBrush);
  for (const PlottedCurve& curve : content_.curves) {
    QPolygonF line;
    for (const analysis::AxisPoint& point : curve.points) line << at(point);
    painter.setPen(curve.pen);
    painter.drawPolyline(line);
  }
}

void ComparisonPlot::paintNotes(QPainter& painter) const
{
  constexpr double half_px = 4.0, width_px = 220.0, height_px = 16.0;
  painter.setFont(typeface(11));
  for (const PlottedNote& note : content_.notes) {
    const QPointF here = at(analysis::shownPlace(content_.axis, note.place), note.force);
    painter.setPen(QPen(note.color, 1.5));
    painter.setBrush(shownTheme().ground);
    painter.drawPolygon(QPolygonF({here + QPointF(0, -half_px), here + QPointF(half_px, 0),
                                   here + QPointF(0, half_px), here + QPointF(-half_px, 0)}));
    painter.setPen(shownTheme().text);
    painter.drawText(QRectF(here.x() - width_px - 2.0 * half_px, here.y() - 0.5 * height_px,
                            width_px, height_px),
                     Qt::AlignRight | Qt::AlignVCenter, note.text);
  }
}

void ComparisonPlot::paintCursor(QPainter& painter) const
{
  if (content_.curves.empty()) return;
  const QRectF inside = place();
  const double x = at(cursor_, 0.0).x();
  painter.setPen(QPen(shownTheme().quietText, 1.0));
  painter.drawLine(QPointF(x, inside.top()), QPointF(x, inside.bottom()));
  const double here = placeAt(content_.axis, cursor_);
  for (const PlottedCurve& curve : content_.curves) {
    const auto force = analysis::forceAt(curve.points, here);
    if (!force) continue;
    painter.setPen(QPen(shownTheme().ground, 1.5));
    painter.setBrush(curve.pen.color());
    painter.drawEllipse(at(cursor_, *force), 4.5, 4.5);
  }
  const bool isRight = x > inside.right() - 70.0;
  painter.setPen(shownTheme().text);
  painter.drawText(QRectF(isRight ? x - 76 : x + 6, inside.top() - 22, 70, 20),
                   int(isRight ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter,
                   placeText(content_.axis, cursor_));
}

QStringList ComparisonPlot::valuesAtCursor() const
{
  const double here = placeAt(content_.axis, cursor_);
  const auto milli = [](double force_N) {
    return numberText(inMillinewtons(newtons(force_N)), valueDecimals);
  };
  QStringList values;
  for (const PlottedCurve& curve : content_.curves) {
    const auto force = analysis::forceAt(curve.points, here);
    if (!force) {
      values << QStringLiteral("–");
      continue;
    }
    std::vector<analysis::AxisPoint> spread;
    for (std::size_t i = 0; i < curve.sd.size(); ++i)
      spread.push_back({curve.points[i].place, curve.sd[i]});
    const auto sd = analysis::forceAt(spread, here);
    values << (sd ? tr("%1 ± %2 mN").arg(milli(*force), milli(*sd))
                  : tr("%1 mN").arg(milli(*force)));
  }
  return values;
}

void ComparisonPlot::paintValues(QPainter& painter) const
{
  constexpr double row_px = 15.0, line_px = 24.0, gap_px = 6.0, fromCursor_px = 10.0;
  if (content_.curves.empty()) return;
  const QStringList values = valuesAtCursor();
  painter.setFont(typeface(11));
  const QFontMetricsF metrics(painter.font());
  double text_px = 0.0;
  for (const QString& value : values) text_px = std::max(text_px, metrics.horizontalAdvance(value));
  const QRectF inside = place();
  const int rows = std::min(int(values.size()), int((inside.height() - 2.0 * gap_px) / row_px));
  const double width_px = line_px + text_px + 3.0 * gap_px, x = at(cursor_, 0.0).x();
  // at the left, where forces are low; at the right while the cursor is there
  const bool isRight = x < inside.left() + width_px + 2.0 * fromCursor_px;
  const QRectF box(
      isRight ? inside.right() - fromCursor_px - width_px : inside.left() + fromCursor_px,
      inside.top() + 2.0, width_px, rows * row_px + gap_px);
  QColor ground = shownTheme().ground;
  ground.setAlphaF(0.88f);  // curves behind it remain visible
  painter.setPen(QPen(shownTheme().line, 1.0));
  painter.setBrush(ground);
  painter.drawRoundedRect(box, 3.0, 3.0);
  for (int i = 0; i < rows; ++i) {
    const QRectF row(box.left() + gap_px, box.top() + 0.5 * gap_px + i * row_px,
                     box.width() - 2.0 * gap_px, row_px);
    if (i == rows - 1 && rows < int(values.size())) {  // a low plot; the table has all
      painter.setPen(shownTheme().quietText);
      painter.drawText(row, Qt::AlignRight | Qt::AlignVCenter, QStringLiteral("…"));
      break;
    }
    painter.setPen(content_.curves[std::size_t(i)].pen);
    painter.drawLine(QPointF(row.left(), row.center().y()),
                     QPointF(row.left() + line_px, row.center().y()));
    painter.setPen(shownTheme().text);
    painter.drawText(row, Qt::AlignRight | Qt::AlignVCenter, values[i]);
  }
}

void ComparisonPlot::mousePressEvent(QMouseEvent* event) { mouseMoveEvent(event); }

void ComparisonPlot::mouseMoveEvent(QMouseEvent* event)
{
  const QRectF inside = place();
  const double fraction = (event->pos().x() - inside.left()) / inside.width();
  const double shown = x_.low + fraction * (x_.high - x_.low);
  setCursorPlace(std::round(shown / step()) * step());
}

void ComparisonPlot::keyPressEvent(QKeyEvent* event)
{
  const bool isShift = (event->modifiers() & Qt::ShiftModifier) != 0;
  const double by = (isShift ? bigSteps : 1) * step();
  if (event->key() == Qt::Key_Left) return setCursorPlace(cursor_ - by);
  if (event->key() == Qt::Key_Right) return setCursorPlace(cursor_ + by);
  QWidget::keyPressEvent(event);
}

}  // namespace perilymph::gui
