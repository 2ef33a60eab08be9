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
constexpr double title_mm = 3.6;
const QColor textInk = themeOf(ColorScheme::light).text;

/// The path of one array in the scala, at the distances of its contacts from the inner wall.
class Path {
public:
  Path(const CochlearView& view, const anatomy::ScalaTympani& scala,
       const planning::ArrayPlan& array)
      : view_(view), scala_(scala)
  {
    for (const planning::ContactBand& each : array.contacts)
      if (each.draws > 0 && each.toModiolus_mm.median >= 0.0)
        places_.emplace_back(each.angle_deg.median, each.toModiolus_mm.median);
    std::ranges::sort(places_);
  }

  QPointF at(double angle_deg) const
  {
    const double angle = degrees(std::clamp(angle_deg, 0.0, inDegrees(scala_.lastAngle()))).si();
    const anatomy::Section section = scala_.section(angle);
    const double inner_mm = 1e3 * section.innerRadius, outer_mm = 1e3 * section.outerRadius;
    // within the walls, which the median of many draws need not be
    const double radius_mm = std::clamp(inner_mm + distance_mm(angle_deg), inner_mm, outer_mm);
    return view_(view_.plane().polar(angle, radius_mm));
  }

  QPolygonF between(double from_deg, double to_deg) const
  {
    QPolygonF line;
    for (double angle = from_deg; angle < to_deg; angle += step_deg) line << at(angle);
    return line << at(to_deg);
  }

private:
  /// From the inner wall, linear between the contacts.
  double distance_mm(double angle_deg) const
  {
    if (places_.empty()) return 0.0;
    const auto next = std::ranges::lower_bound(places_, std::pair(angle_deg, 0.0));
    if (next == places_.begin()) return places_.front().second;
    if (next == places_.end()) return places_.back().second;
    const auto& [before_deg, before_mm] = *std::prev(next);
    const double part = (angle_deg - before_deg) / std::max(1e-9, next->first - before_deg);
    return before_mm + part * (next->second - before_mm);
  }

  const CochlearView& view_;
  const anatomy::ScalaTympani& scala_;
  std::vector<std::pair<double, double>> places_;  ///< Angle [degrees] and distance [mm].
};

void paintPath(QPainter& painter, const CochlearView& view, const Path& path,
               const planning::ArrayPlan& array, const QColor& ink)
{
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(ink, 0.09 * view.scale(), Qt::SolidLine, Qt::FlatCap));
  painter.drawPolyline(path.between(0.0, array.angle_deg.median));
  QColor pale = ink;
  pale.setAlphaF(0.45f);
  painter.setPen(QPen(pale, 0.30 * view.scale(), Qt::SolidLine, Qt::FlatCap));
  painter.drawPolyline(path.between(array.angle_deg.low, array.angle_deg.high));
  painter.setPen(Qt::NoPen);
  painter.setBrush(ink);
  for (const planning::ContactBand& contact : array.contacts) {
    if (contact.draws == 0) continue;
    const double radius = 0.09 * view.scale();
    painter.drawEllipse(path.at(contact.angle_deg.median), radius, radius);
  }
  const double radius = 0.18 * view.scale();
  painter.drawEllipse(path.at(array.angle_deg.median), radius, radius);
}

/// One array in its place, with a ring of angles if there is room for it.
void paintArray(ReportSheet& sheet, const QRectF& place_mm, const PlanReportContent& content,
                std::size_t i, bool hasRing)
{
  QPainter& painter = sheet.painter();
  const planning::ArrayPlan& array = content.plan().arrays[i];
  const anatomy::Side side = content.plan().request.patient.side;
  sheet.line({place_mm.left(), place_mm.top(), place_mm.width() - 1.5, title_mm},
             numberedName(array, i), ReportFace::label);
  const QRectF place = sheet.dots(place_mm.adjusted(0.0, title_mm, 0.0, 0.0));
  const CochlearView view(place, *content.anatomy, side, hasRing);
  painter.save();
  painter.setClipRect(place);
  painter.setRenderHint(QPainter::Antialiasing);
  const electrode::ArrayDesign none;
  view.paintScala(painter, {*content.anatomy, none, side, nullptr});
  paintPath(painter, view, Path(view, *content.anatomy, array), array, inkOfArray(i));
  if (hasRing) view.paintFrame(sheet);
  painter.restore();
}

/// Columns of equal squares that are largest in a place.
std::size_t bestColumns(const QRectF& place_mm, std::size_t count)
{
  std::size_t best = 1;
  double largest_mm = 0.0;
  for (std::size_t columns = 1; columns <= count; ++columns) {
    const std::size_t rows = (count + columns - 1) / columns;
    const double side_mm =
        std::min(place_mm.width() / double(columns), place_mm.height() / double(rows) - title_mm);
    if (side_mm <= largest_mm) continue;
    largest_mm = side_mm;
    best = columns;
  }
  return best;
}

}  // namespace

void paintPlanPicture(ReportSheet& sheet, const QRectF& place_mm, const PlanReportContent& content)
{
  const std::size_t count = std::min(content.plan().arrays.size(), maxDrawnArrays);
  const std::size_t columns = bestColumns(place_mm, count);
  const std::size_t rows = (count + columns - 1) / columns;
  const double width_mm = place_mm.width() / double(columns),
               height_mm = place_mm.height() / double(rows);
  constexpr double ring_mm = 48.0;  // narrower, its numbers would touch
  for (std::size_t i = 0; i < count; ++i)
    paintArray(sheet,
               {place_mm.left() + double(i % columns) * width_mm,
                place_mm.top() + double(i / columns) * height_mm, width_mm, height_mm},
               content, i, std::min(width_mm, height_mm - title_mm) >= ring_mm);
}

}  // namespace perilymph::gui
