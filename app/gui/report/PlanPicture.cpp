// SPDX-License-Identifier: BSD-3-Clause
#include "gui/report/PlanPicture.h"

#include <algorithm>
#include <cmath>

#include "gui/report/CochlearView.h"
#include "gui/widgets/Theme.h"
#include "perilymph/foundation/Units.h"

namespace perilymph::gui {

namespace {

constexpr double step_deg = 3.0;
const QColor textInk = themeOf(ColorScheme::light).text;

/// The path of one array in the scala, beside those of the others.
class Lane {
public:
  Lane(const CochlearView& view, const anatomy::ScalaTympani& scala, std::size_t place,
       std::size_t lanes)
      : view_(view),
        scala_(scala),
        // the first array outside; the wall itself stays free
        across_(1.0 - double(place + 1) / double(lanes + 1))
  {
  }

  QPointF at(double angle_deg) const
  {
    const double angle = degrees(std::clamp(angle_deg, 0.0, inDegrees(scala_.lastAngle()))).si();
    const anatomy::Section section = scala_.section(angle);
    const double radius =
        section.innerRadius + across_ * (section.outerRadius - section.innerRadius);
    return view_(view_.plane().polar(angle, inMillimeters(meters(radius))));
  }

  QPolygonF between(double from_deg, double to_deg) const
  {
    QPolygonF line;
    for (double angle = from_deg; angle < to_deg; angle += step_deg) line << at(angle);
    return line << at(to_deg);
  }

private:
  const CochlearView& view_;
  const anatomy::ScalaTympani& scala_;
  double across_;  ///< From the inner wall, 0, to the outer one, 1.
};

void paintLane(QPainter& painter, const CochlearView& view, const Lane& lane,
               const planning::ArrayPlan& array, const QColor& ink)
{
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(ink, 0.07 * view.scale(), Qt::SolidLine, Qt::FlatCap));
  painter.drawPolyline(lane.between(0.0, array.angle_deg.median));
  QColor pale = ink;
  pale.setAlphaF(0.45);
  painter.setPen(QPen(pale, 0.22 * view.scale(), Qt::SolidLine, Qt::FlatCap));
  painter.drawPolyline(lane.between(array.angle_deg.low, array.angle_deg.high));
  painter.setPen(Qt::NoPen);
  painter.setBrush(ink);
  for (const planning::ContactBand& contact : array.contacts) {
    if (contact.draws == 0) continue;
    const double radius = 0.065 * view.scale();
    painter.drawEllipse(lane.at(contact.angle_deg.median), radius, radius);
  }
  const double radius = 0.13 * view.scale();
  painter.drawEllipse(lane.at(array.angle_deg.median), radius, radius);
}

}  // namespace

void paintPlanPicture(ReportSheet& sheet, const QRectF& place_mm, const PlanReportContent& content)
{
  QPainter& painter = sheet.painter();
  const QRectF place = sheet.dots(place_mm);
  const anatomy::Side side = content.plan().request.patient.side;
  const CochlearView view(place, *content.anatomy, side);
  const auto& arrays = content.plan().arrays;
  const std::size_t lanes = std::min(arrays.size(), maxDrawnArrays);
  painter.save();
  painter.setClipRect(place);
  painter.setRenderHint(QPainter::Antialiasing);
  const electrode::ArrayDesign none;
  view.paintScala(painter, {*content.anatomy, none, side, nullptr});
  for (std::size_t i = 0; i < lanes; ++i)
    paintLane(painter, view, Lane(view, *content.anatomy, i, lanes), arrays[i], inkOfArray(i));
  // the numbers last, above all lanes
  painter.setFont(reportFont(0.8 * sheet.font(ReportFace::label).pixelSize(), QFont::DemiBold));
  painter.setPen(textInk);
  for (std::size_t i = 0; i < lanes; ++i) {
    const Lane lane(view, *content.anatomy, i, lanes);
    drawCentered(painter, lane.at(arrays[i].angle_deg.high + 14.0), QString::number(i + 1));
  }
  view.paintFrame(sheet);
  painter.restore();
}

}  // namespace perilymph::gui
