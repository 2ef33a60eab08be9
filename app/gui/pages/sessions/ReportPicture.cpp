// SPDX-License-Identifier: BSD-3-Clause
#include "gui/pages/sessions/ReportPicture.h"

#include <QCoreApplication>
#include <algorithm>
#include <cmath>

#include "gui/pages/sessions/SessionPicture.h"
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
const QColor textInk(0x14, 0x1B, 0x21);

/// Greatest distance of the wall from the modiolar axis [mm].
double outerRadius_mm(const anatomy::ScalaTympani& scala)
{
  double radius = 0.0;
  for (int angle_deg = 0; angle_deg < 360; angle_deg += 10)
    radius = std::max(radius, scala.section(degrees(angle_deg).si()).outerRadius);
  return inMillimeters(meters(radius));
}

/// Maps the projection's millimeters to the page.
class PictureMap {
public:
  PictureMap(const QRectF& place, double half_mm)
      : center_(place.center()), scale_(0.5 * std::min(place.width(), place.height()) / half_mm)
  {
  }
  QPointF operator()(const QPointF& point_mm) const { return center_ + scale_ * point_mm; }
  double scale() const { return scale_; }
  void apply(QPainter& painter) const
  {
    painter.translate(center_);
    painter.scale(scale_, scale_);
  }

private:
  QPointF center_;
  double scale_;  ///< Dots per millimeter of the cochlea.
};

void drawCentered(QPainter& painter, const QPointF& at, const QString& text)
{
  const QFontMetricsF metrics(painter.font(), painter.device());
  const double width = metrics.horizontalAdvance(text);
  painter.drawText(QPointF(at.x() - 0.5 * width, at.y() + 0.36 * metrics.ascent()), text);
}

void paintRing(ReportSheet& sheet, const PictureMap& map, const ScalaProjection& plane,
               double radius_mm)
{
  QPainter& painter = sheet.painter();
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(ringInk, 0.03 * map.scale()));
  const double radius = radius_mm * map.scale();
  painter.drawEllipse(map({0.0, 0.0}), radius, radius);
  painter.setFont(sheet.font(ReportFace::label));
  for (int angle_deg = 0; angle_deg < 360; angle_deg += tickStep_deg) {
    const bool isLabeled = angle_deg % labelStep_deg == 0;
    const double angle = degrees(angle_deg).si();
    painter.setPen(QPen(ringInk, 0.03 * map.scale()));
    painter.drawLine(map(plane.polar(angle, radius_mm)),
                     map(plane.polar(angle, radius_mm + (isLabeled ? 0.4 : 0.2))));
    if (!isLabeled) continue;
    painter.setPen(textInk);
    drawCentered(painter, map(plane.polar(angle, radius_mm + labelMargin_mm)),
                 QStringLiteral("%1°").arg(angle_deg));
  }
}

/// The numbers of the contacts beside the array, on its side away from the modiolar axis.
void paintNumbers(ReportSheet& sheet, const PictureMap& map, const ScalaProjection& plane,
                  const ReportContent& content)
{
  QPainter& painter = sheet.painter();
  painter.setFont(reportFont(0.8 * sheet.font(ReportFace::label).pixelSize(), QFont::DemiBold));
  painter.setPen(textInk);
  const haptics::Snapshot& now = content.deepest;
  const electrode::ArrayDesign& array = content.scenario.array();
  const auto node = [&](std::size_t i) {
    return plane.at(double(now.node_W[i][0]), double(now.node_W[i][1]));
  };
  for (const analysis::ContactPosition& contact : content.contacts) {
    if (!contact.isInserted) continue;
    const Length fromTip = meters(now.output.depth) - contact.depth;
    const double place = (now.nodes - 1) * (1.0 - fromTip / array.length);
    const auto i = std::size_t(std::clamp(std::lround(place), 1L, long(now.nodes) - 2));
    const QPointF at = node(i), along = node(i + 1) - node(i - 1);
    QPointF aside(-along.y(), along.x());
    aside /= std::max(1e-9, std::hypot(aside.x(), aside.y()));
    if (QPointF::dotProduct(aside, at) < 0.0) aside = -aside;
    const double off_mm = 0.5 * inMillimeters(array.sectionAt(fromTip).within) + 0.4;
    drawCentered(painter, map(at + off_mm * aside), QString::number(contact.number));
  }
}

void paintScaleBar(ReportSheet& sheet, const PictureMap& map, const QRectF& place)
{
  QPainter& painter = sheet.painter();
  const double length = scaleBar_mm * map.scale();
  const QPointF left(place.left() + 0.3 * map.scale(), place.bottom() - 0.3 * map.scale());
  painter.setPen(QPen(textInk, 0.08 * map.scale(), Qt::SolidLine, Qt::FlatCap));
  painter.drawLine(left, left + QPointF(length, 0.0));
  painter.setFont(sheet.font(ReportFace::label));
  painter.setPen(textInk);
  drawCentered(painter, left + QPointF(0.5 * length, -0.45 * map.scale()),
               tr("%1 mm").arg(int(scaleBar_mm)));
}

/// The cochlea and the array as an image: abutting areas show seams if they are smoothed one by
/// one.
QImage imageOf(const ReportContent& content, const ScalaProjection& plane, double half_mm)
{
  constexpr int side = 1600;
  QImage image(side, side, QImage::Format_RGB32);
  image.fill(Qt::white);
  QPainter painter(&image);
  PictureMap(QRectF(0, 0, side, side), half_mm).apply(painter);
  painter.setRenderHint(QPainter::Antialiasing);
  paintProjected(painter, plane,
                 {*content.anatomy, content.scenario.array(), content.scenario.patient().side,
                  &content.deepest},
                 printInks());
  return image;
}

}  // namespace

void paintReportPicture(ReportSheet& sheet, const QRectF& place_mm, const ReportContent& content)
{
  QPainter& painter = sheet.painter();
  const QRectF place = sheet.dots(place_mm);
  const ScalaProjection plane(*content.anatomy, content.scenario.patient().side);
  const double radius_mm = outerRadius_mm(*content.anatomy) + ringMargin_mm;
  const double half_mm = radius_mm + labelMargin_mm + 0.6;
  const PictureMap map(place, half_mm);
  painter.save();
  painter.setClipRect(place);
  painter.setRenderHint(QPainter::Antialiasing);
  const double side = 2.0 * half_mm * map.scale();
  QRectF square(0.0, 0.0, side, side);
  square.moveCenter(place.center());
  painter.drawImage(square, imageOf(content, plane, half_mm));
  paintRing(sheet, map, plane, radius_mm);
  paintNumbers(sheet, map, plane, content);
  paintScaleBar(sheet, map, place);
  const bool isLeft = content.scenario.patient().side == anatomy::Side::left;
  painter.setFont(sheet.font(ReportFace::heading));
  painter.setPen(textInk);
  painter.drawText(place, int((isLeft ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignTop),
                   isLeft ? tr("left ear") : tr("right ear"));
  painter.restore();
}

}  // namespace perilymph::gui
