// SPDX-License-Identifier: BSD-3-Clause
#include "gui/report/InsertionPicture.h"

#include <QPainterPath>
#include <algorithm>
#include <cmath>
#include <vector>

#include "gui/widgets/Theme.h"
#include "perilymph/figures/FixedInks.h"
#include "perilymph/foundation/Units.h"

namespace perilymph::gui {

namespace {

constexpr double step = pi / 45.0;  // between sections of the outline [rad]

struct Outline {
  QPolygonF outer, inner;
};

Outline outlineOf(const anatomy::ScalaTympani& scala, const ScalaProjection& plane)
{
  Outline outline;
  // the straight lead-in, then the turns
  const Eigen::Vector3d leadIn_W = scala.leadIn().si() * scala.entry().out_W;
  outline.outer << plane.at(scala.wall_W(0.0, 0.0) + leadIn_W);
  outline.inner << plane.at(scala.wall_W(0.0, pi) + leadIn_W);
  for (double angle = 0.0; angle < scala.lastAngle().si(); angle += step) {
    const anatomy::Section section = scala.section(angle);
    const double x = std::cos(angle), y = std::sin(angle);
    outline.outer << plane.at(section.outerRadius * x, section.outerRadius * y);
    outline.inner << plane.at(section.innerRadius * x, section.innerRadius * y);
  }
  return outline;
}

QPolygonF arrayOf(const haptics::Snapshot& now, const ScalaProjection& plane)
{
  QPolygonF line;
  for (std::uint32_t i = 0; i < now.nodes; ++i)
    line << plane.at(now.node_W[i][0], now.node_W[i][1]);
  return line;
}

/// The point of a line at a distance from its end [mm].
QPointF fromTip(const QPolygonF& line, double length_mm)
{
  for (auto i = line.size() - 1; i > 0; --i) {
    const QLineF piece(line[i], line[i - 1]);
    if (length_mm <= piece.length() && piece.length() > 0.0)
      return piece.pointAt(length_mm / piece.length());
    length_mm -= piece.length();
  }
  return line.isEmpty() ? QPointF() : line.front();
}

void paintArray(QPainter& painter, const PicturedInsertion& pictured, const ScalaProjection& plane,
                const PictureInks& inks)
{
  const QPolygonF line = arrayOf(*pictured.now, plane);
  if (line.size() < 2) return;
  const double length_mm = inMillimeters(pictured.array.length);
  const auto diameterAt = [&](double fromTip_mm) {
    return inMillimeters(pictured.array.sectionAt(millimeters(fromTip_mm)).within);
  };
  // thick at the base, thin at the tip: segments of constant width
  double before_mm = 0.0;
  for (auto i = line.size() - 1; i > 0; --i) {
    const double there_mm = std::min(before_mm, length_mm);
    painter.setPen(QPen(inks.array, diameterAt(there_mm), Qt::SolidLine, Qt::RoundCap));
    painter.drawLine(line[i], line[i - 1]);
    before_mm += QLineF(line[i], line[i - 1]).length();
  }
  painter.setPen(Qt::NoPen);
  painter.setBrush(inks.contact);
  for (const Length contact : pictured.array.contactsFromTip) {
    const double place_mm = inMillimeters(contact);
    const double radius = 0.3 * diameterAt(place_mm);
    painter.drawEllipse(fromTip(line, place_mm), radius, radius);
  }
}

}  // namespace

PictureInks screenInks()
{
  if (shownColorScheme() == ColorScheme::light) return printInks();
  const Theme& theme = themeOf(ColorScheme::dark);
  return {theme.bone, theme.lumen, theme.silicone, theme.platinum};
}

PictureInks printInks()
{
  using namespace figures;
  return {colorOf(ink::bone), colorOf(ink::lumen), colorOf(ink::silicone), colorOf(ink::platinum)};
}

void paintInsertion(QPainter& painter, const QRectF& place, const PicturedInsertion& pictured,
                    const PictureInks& inks)
{
  const ScalaProjection plane(pictured.scala, pictured.side);
  const Outline outline = outlineOf(pictured.scala, plane);
  constexpr double margin_mm = 0.6;
  const QRectF whole = outline.outer.boundingRect()
                           .united(outline.inner.boundingRect())
                           .adjusted(-margin_mm, -margin_mm, margin_mm, margin_mm);
  painter.save();
  painter.setClipRect(place);
  const double scale = std::min(place.width() / whole.width(), place.height() / whole.height());
  painter.translate(place.center());
  painter.scale(scale, scale);
  painter.translate(-whole.center());
  paintProjected(painter, plane, pictured, inks);
  painter.restore();
}

void paintProjected(QPainter& painter, const ScalaProjection& plane,
                    const PicturedInsertion& pictured, const PictureInks& inks)
{
  const Outline outline = outlineOf(pictured.scala, plane);
  painter.save();
  // quadrilaterals: a self-overlapping spiral would be filled incorrectly as one polygon
  painter.setPen(Qt::NoPen);
  painter.setBrush(inks.lumen);
  painter.setRenderHint(QPainter::Antialiasing, false);
  for (int i = 0; i + 1 < outline.outer.size(); ++i)
    painter.drawPolygon(QPolygonF{
        {outline.outer[i], outline.outer[i + 1], outline.inner[i + 1], outline.inner[i]}});
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(inks.wall, std::max(0.08, 1.0 / painter.transform().m11())));
  painter.drawPolyline(outline.outer);
  painter.drawPolyline(outline.inner);
  if (pictured.now != nullptr) paintArray(painter, pictured, plane, inks);
  painter.restore();
}

}  // namespace perilymph::gui
