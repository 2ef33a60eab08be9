// SPDX-License-Identifier: BSD-3-Clause
#include "gui/report/CochlearView.h"

#include <QCoreApplication>
#include <algorithm>
#include <cmath>

#include "gui/widgets/Theme.h"
#include "perilymph/foundation/Units.h"

namespace perilymph::gui {

namespace {

constexpr double ringMargin_mm = 0.9;    // outside of the outer wall
constexpr double labelMargin_mm = 1.05;  // outside of the ring
constexpr double scaleBar_mm = 5.0;
constexpr int tickStep_deg = 30;
constexpr int labelStep_deg = 90;

// lupdate assigns texts of free functions to their namespace.
QString tr(const char* text) { return QCoreApplication::translate("perilymph::gui", text); }

const QColor ringInk(0x7D, 0x8A, 0x94);
const QColor textInk = themeOf(ColorScheme::light).text;

/// Greatest distance of the wall from the modiolar axis [mm].
double outerRadius_mm(const anatomy::ScalaTympani& scala)
{
  double radius = 0.0;
  for (int angle_deg = 0; angle_deg < 360; angle_deg += 10)
    radius = std::max(radius, scala.section(degrees(angle_deg).si()).outerRadius);
  return inMillimeters(meters(radius));
}

QString earText(anatomy::Side side)
{
  return side == anatomy::Side::left ? tr("left ear") : tr("right ear");
}

QString barText() { return tr("%1 mm").arg(int(scaleBar_mm)); }

}  // namespace

void drawCentered(QPainter& painter, const QPointF& at, const QString& text)
{
  const QFontMetricsF metrics(painter.font(), painter.device());
  const double width = metrics.horizontalAdvance(text);
  painter.drawText(QPointF(at.x() - 0.5 * width, at.y() + 0.36 * metrics.ascent()), text);
}

CochlearView::CochlearView(const QRectF& place, const anatomy::ScalaTympani& scala,
                           anatomy::Side side, bool hasRing)
    : place_(place),
      center_(place.center()),
      side_(side),
      plane_(scala, side),
      radius_mm_(outerRadius_mm(scala) + ringMargin_mm),
      half_mm_(hasRing ? radius_mm_ + labelMargin_mm + 1.1 : radius_mm_),
      scale_(0.5 * std::min(place.width(), place.height()) / half_mm_)
{
}

void CochlearView::paintScala(QPainter& painter, const PicturedInsertion& pictured) const
{
  const double side = 2.0 * half_mm_ * scale_;
  const int pixels = std::clamp(int(2.0 * side), 400, 1600);
  QImage image(pixels, pixels, QImage::Format_RGB32);
  image.fill(Qt::white);
  QPainter inner(&image);
  inner.translate(0.5 * pixels, 0.5 * pixels);
  inner.scale(0.5 * pixels / half_mm_, 0.5 * pixels / half_mm_);
  inner.setRenderHint(QPainter::Antialiasing);
  paintProjected(inner, plane_, pictured, printInks());
  inner.end();
  QRectF square(0.0, 0.0, side, side);
  square.moveCenter(center_);
  painter.drawImage(square, image);
}

void CochlearView::paintFrame(ReportSheet& sheet) const
{
  paintRing(sheet);
  QPainter& painter = sheet.painter();
  const double length = scaleBar_mm * scale_;
  const QPointF left(place_.left() + 0.3 * scale_, place_.bottom() - 0.3 * scale_);
  painter.setPen(QPen(textInk, 0.08 * scale_, Qt::SolidLine, Qt::FlatCap));
  painter.drawLine(left, left + QPointF(length, 0.0));
  painter.setFont(sheet.font(ReportFace::label));
  painter.setPen(textInk);
  drawCentered(painter, left + QPointF(0.5 * length, -0.45 * scale_), barText());
  const bool isLeft = side_ == anatomy::Side::left;
  painter.setFont(sheet.font(ReportFace::label));
  painter.setPen(textInk);
  painter.drawText(place_, int((isLeft ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignTop),
                   earText(side_));
}

void CochlearView::paintRing(ReportSheet& sheet) const
{
  QPainter& painter = sheet.painter();
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(ringInk, 0.03 * scale_));
  const double radius = radius_mm_ * scale_;
  painter.drawEllipse((*this)({0.0, 0.0}), radius, radius);
  painter.setFont(sheet.font(ReportFace::label));
  for (int angle_deg = 0; angle_deg < 360; angle_deg += tickStep_deg) {
    const bool isLabeled = angle_deg % labelStep_deg == 0;
    const double angle = degrees(angle_deg).si();
    painter.setPen(QPen(ringInk, 0.03 * scale_));
    painter.drawLine((*this)(plane_.polar(angle, radius_mm_)),
                     (*this)(plane_.polar(angle, radius_mm_ + (isLabeled ? 0.4 : 0.2))));
    if (!isLabeled) continue;
    painter.setPen(textInk);
    drawCentered(painter, (*this)(plane_.polar(angle, radius_mm_ + labelMargin_mm)),
                 QStringLiteral("%1°").arg(angle_deg));
  }
}

}  // namespace perilymph::gui
