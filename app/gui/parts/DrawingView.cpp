#include "DrawingView.h"

#include <QPainter>
#include <QPainterPath>
#include <algorithm>

#include "Theme.h"

namespace perilymph::gui {

namespace {

constexpr int dotsPerInch = 72;  // of a page point

QColor colorOf(const analysis::Ink& ink)
{
  QColor color(ink.rgb[0], ink.rgb[1], ink.rgb[2]);
  color.setAlphaF(ink.opacity);
  return color;
}

QPolygonF polygonOf(const std::vector<analysis::PagePoint>& points)
{
  QPolygonF polygon;
  for (const analysis::PagePoint& point : points) polygon << QPointF(point.x, point.y);
  return polygon;
}

/// Draws one mark in page points.
struct MarkPainter {
  QPainter& painter;

  void operator()(const analysis::Area& area) const
  {
    painter.setPen(Qt::NoPen);
    painter.setBrush(colorOf(area.ink));
    painter.drawPolygon(polygonOf(area.points));
  }

  void operator()(const analysis::Stroke& stroke) const
  {
    QPen pen(colorOf(stroke.ink), stroke.width, Qt::SolidLine, Qt::FlatCap, Qt::RoundJoin);
    if (stroke.dash > 0.0)
      pen.setDashPattern({stroke.dash / stroke.width, stroke.dash / stroke.width});
    painter.setPen(pen);
    painter.setBrush(Qt::NoBrush);
    painter.drawPolyline(polygonOf(stroke.points));
  }

  void operator()(const analysis::Disk& disk) const
  {
    painter.setPen(QPen(colorOf(disk.outline), 1.0));
    painter.setBrush(colorOf(disk.fill));
    painter.drawEllipse(QPointF(disk.center.x, disk.center.y), disk.radius, disk.radius);
  }

  void operator()(const analysis::Words& words) const
  {
    // A font is scaled with the page: set large and drawn small, its letters keep their places.
    constexpr double fine = 16.0;
    QFont font = typeface(int(words.size * fine), words.isBold ? QFont::DemiBold : QFont::Normal);
    const QString text = QString::fromStdString(words.text);
    painter.save();
    painter.translate(words.at.x, words.at.y);
    if (words.direction == analysis::Direction::upward) painter.rotate(-90.0);
    painter.scale(1.0 / fine, 1.0 / fine);
    painter.setFont(font);
    painter.setPen(colorOf(words.ink));
    const double width = QFontMetricsF(font).horizontalAdvance(text);
    const double left = words.anchor == analysis::Anchor::start    ? 0.0
                        : words.anchor == analysis::Anchor::middle ? -0.5 * width
                                                                   : -width;
    painter.drawText(QPointF(left, 0.0), text);
    painter.restore();
  }
};

}  // namespace

void paintDrawing(QPainter& painter, const analysis::Drawing& drawing)
{
  for (const analysis::Mark& mark : drawing.marks) std::visit(MarkPainter{painter}, mark);
}

DrawingView::DrawingView(QWidget* parent) : QWidget(parent)
{
  setObjectName(QStringLiteral("drawingView"));
  setMinimumSize(5 * dotsPerInch, 4 * dotsPerInch);
}

void DrawingView::show(analysis::Drawing drawing)
{
  drawing_ = std::move(drawing);
  update();
}

void DrawingView::paintEvent(QPaintEvent*)
{
  if (drawing_.marks.empty()) return;
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const double scale = std::min(width() / drawing_.width, height() / drawing_.height);
  painter.translate(0.5 * (width() - scale * drawing_.width),
                    0.5 * (height() - scale * drawing_.height));
  painter.scale(scale, scale);
  QPainterPath sheet;
  sheet.addRoundedRect(QRectF(0.0, 0.0, drawing_.width, drawing_.height), 4.0 / scale, 4.0 / scale);
  painter.fillPath(sheet, Qt::white);
  paintDrawing(painter, drawing_);
}

}  // namespace perilymph::gui
