// SPDX-License-Identifier: BSD-3-Clause
#include "gui/widgets/DrawingPainter.h"

#include <QLocale>
#include <QRegularExpression>
#include <algorithm>
#include <cmath>

#include "gui/widgets/Theme.h"

namespace perilymph::gui {

namespace {

QColor printedColor(const figures::Ink& ink)
{
  QColor color(ink.rgb[0], ink.rgb[1], ink.rgb[2]);
  color.setAlphaF(float(ink.opacity));
  return color;
}

/// The same hue with the opposite lightness, between that of the ground and that of text.
QColor onDark(const QColor& color)
{
  const double ground = shownTheme().ground.lightnessF(), text = shownTheme().text.lightnessF();
  const double lightness = ground + (1.0 - color.lightnessF()) * (text - ground);
  return QColor::fromHslF(std::max(0.0f, float(color.hslHueF())), float(color.hslSaturationF()),
                          float(lightness), float(color.alphaF()));
}

QPolygonF polygonOf(const std::vector<figures::PagePoint>& points)
{
  QPolygonF polygon;
  for (const figures::PagePoint& point : points) polygon << QPointF(point.x, point.y);
  return polygon;
}

/// Draws one mark in page points.
/// A number at an axis with the window's decimal sign; any other text unchanged.
QString withDecimalSign(QString text)
{
  static const QRegularExpression number(QStringLiteral("^[-−]?\\d+\\.\\d+$"));
  if (number.match(text).hasMatch()) text.replace(QLatin1Char('.'), QLocale().decimalPoint());
  return text;
}

struct MarkPainter {
  QPainter& painter;
  Lettering lettering;
  Sheet sheet;
  double pageWidth = 0.0;
  double textFactor = 1.0;

  QColor colorOf(const figures::Ink& ink) const
  {
    const QColor printed = printedColor(ink);
    return sheet == Sheet::dark ? onDark(printed) : printed;
  }

  void operator()(const figures::Area& area) const
  {
    painter.setPen(Qt::NoPen);
    painter.setBrush(colorOf(area.ink));
    painter.drawPolygon(polygonOf(area.points));
  }

  void operator()(const figures::Stroke& stroke) const
  {
    QPen pen(colorOf(stroke.ink), stroke.width, Qt::SolidLine, Qt::FlatCap, Qt::RoundJoin);
    if (stroke.dash > 0.0)
      pen.setDashPattern({stroke.dash / stroke.width, stroke.dash / stroke.width});
    painter.setPen(pen);
    painter.setBrush(Qt::NoBrush);
    painter.drawPolyline(polygonOf(stroke.points));
  }

  void operator()(const figures::Disk& disk) const
  {
    painter.setPen(QPen(colorOf(disk.outline), 1.0));
    painter.setBrush(colorOf(disk.fill));
    painter.drawEllipse(QPointF(disk.center.x, disk.center.y), disk.radius, disk.radius);
  }

  void operator()(const figures::Label& label) const
  {
    const double fine = lettering == Lettering::scaled ? 16.0 : 1.0;
    QFont font =
        typeface(int(std::lround(label.size)), label.isBold ? QFont::DemiBold : QFont::Normal);
    // the user's text size is for the screen, not for print
    if (lettering == Lettering::scaled)
      font.setPixelSize(int(std::lround(textFactor * label.size * fine)));
    const QString text = withDecimalSign(QString::fromStdString(label.text));
    painter.save();
    painter.translate(label.at.x, label.at.y);
    if (label.direction == figures::Direction::upward) painter.rotate(-90.0);
    if (fine != 1.0) painter.scale(1.0 / fine, 1.0 / fine);
    painter.setFont(font);
    painter.setPen(colorOf(label.ink));
    double width = QFontMetricsF(font).horizontalAdvance(text);
    // a line that larger text would take beyond the sheet is as large as there is room
    const double room = fine * (pageWidth - label.at.x);
    if (textFactor > 1.0 && width > room && label.anchor == figures::Anchor::start &&
        label.direction == figures::Direction::across) {
      font.setPixelSize(int(fine * label.size * std::max(1.0, textFactor * room / width)));
      painter.setFont(font);
      width = QFontMetricsF(font).horizontalAdvance(text);
    }
    const double left = label.anchor == figures::Anchor::start    ? 0.0
                        : label.anchor == figures::Anchor::middle ? -0.5 * width
                                                                  : -width;
    painter.drawText(QPointF(left, 0.0), text);
    painter.restore();
  }
};

}  // namespace

void paintMarks(QPainter& painter, const figures::Drawing& drawing, Lettering lettering,
                Sheet sheet, double textFactor)
{
  for (const figures::Mark& mark : drawing.marks)
    std::visit(MarkPainter{painter, lettering, sheet, drawing.width, textFactor}, mark);
}

}  // namespace perilymph::gui
