// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/charts/TipSection.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "PlotSheet.h"
#include "perilymph/figures/Strings.h"
#include "perilymph/foundation/Units.h"

namespace perilymph::charts {

using figures::Anchor;
using figures::Area;
using figures::PagePoint;
using figures::Stroke;

namespace {

constexpr int directions = 120;
constexpr double side_px = 14.0;
constexpr double top_px = 38.0;     ///< For the scale, and the membrane's name below it.
constexpr double bottom_px = 58.0;  ///< For names and force.
constexpr double lowView_px = 200.0, lowBottom_px = 28.0;  ///< A view as low is too low for names.
constexpr double namesGap_px = 8.0;
constexpr double cutStep_mm = 0.02;  ///< Between the balls that the array is cut as.
constexpr double cutReach_mm = 4.0;  ///< From the tip; balls farther behind are of other turns.

/// An ellipse with its axes across and up [mm].
struct Ellipse {
  Eigen::Vector2d center, halfAxes;
};

/// Distance from `from` along a unit direction to the far side of an ellipse; 0 if it misses it.
double farSide(const Ellipse& ellipse, const Eigen::Vector2d& from, const Eigen::Vector2d& way)
{
  const Eigen::Vector2d start = (from - ellipse.center).cwiseQuotient(ellipse.halfAxes);
  const Eigen::Vector2d slope = way.cwiseQuotient(ellipse.halfAxes);
  const double a = slope.squaredNorm(), b = start.dot(slope), c = start.squaredNorm() - 1.0;
  const double discriminant = b * b - a * c;
  return discriminant < 0.0 ? 0.0 : std::max(0.0, (-b + std::sqrt(discriminant)) / a);
}

Length cutBehindTip(const ArrayInScala& now) { return now.array().tipRadius(); }

/// The array's ball at a distance from the tip, cut by the half-plane at the angle; none if it does
/// not reach it.
std::optional<Ellipse> cutOf(const ArrayInScala& now, double fromTip_mm, double angle)
{
  const electrode::Section section = now.array().sectionAt(millimeters(fromTip_mm));
  const Eigen::Vector2d half_mm(0.5 * inMillimeters(section.within),
                                0.5 * inMillimeters(section.across));
  const std::vector<Eigen::Vector3d>& nodes_W = now.nodes_W();
  const double last = static_cast<double>(nodes_W.size() - 1);
  const double index =
      std::clamp(last * (1.0 - fromTip_mm / inMillimeters(now.array().length)), 0.0, last);
  const std::size_t i = std::min(nodes_W.size() - 2, static_cast<std::size_t>(index));
  const Eigen::Vector3d at_W =
      nodes_W[i] + (index - static_cast<double>(i)) * (nodes_W[i + 1] - nodes_W[i]);
  const Eigen::Vector3d center_W = now.scala().center_W(angle);
  const Eigen::Vector2d outward = center_W.head<2>().normalized();
  const double off_mm = 1e3 * (at_W.y() * outward.x() - at_W.x() * outward.y());
  const double ratio = off_mm / half_mm.maxCoeff();
  if (std::abs(ratio) >= 1.0 || at_W.head<2>().dot(outward) <= 0.0) return std::nullopt;
  return Ellipse{{1e3 * (at_W.head<2>().dot(outward) - center_W.head<2>().norm()),
                  1e3 * (at_W.z() - center_W.z())},
                 std::sqrt(1.0 - ratio * ratio) * half_mm};
}

/// The wall in the half-plane at an angle, from the section's center [mm], across and up.
std::vector<Eigen::Vector2d> wall_mm(const anatomy::ScalaTympani& scala, double angle)
{
  const Eigen::Vector3d center_W = scala.center_W(angle);
  std::vector<Eigen::Vector2d> outline;
  for (int k = 0; k < directions; ++k) {
    const Eigen::Vector3d wall_W = scala.wall_W(angle, 2.0 * pi * k / directions);
    outline.push_back({1e3 * (wall_W.head<2>().norm() - center_W.head<2>().norm()),
                       1e3 * (wall_W.z() - center_W.z())});
  }
  return outline;
}

/// The array's outline in the half-plane at the cut, likewise: the cut through the body that the
/// mechanics holds against the wall, balls of the array's thickness along its center line.
std::vector<Eigen::Vector2d> cut_mm(const ArrayInScala& now)
{
  if (now.nodes().empty()) return {};
  const NodePlace cut = now.at(inMillimeters(cutBehindTip(now)));
  std::vector<Ellipse> balls;
  if (cut.angle_deg < 0.0) {  // in the lead-in, whose sections are those at the round window
    const electrode::Section section = now.array().sectionAt(cutBehindTip(now));
    balls.push_back({{cut.across_mm, cut.up_mm},
                     {0.5 * inMillimeters(section.within), 0.5 * inMillimeters(section.across)}});
  } else {
    for (double place_mm = 0.0; place_mm <= cutReach_mm; place_mm += cutStep_mm)
      if (const auto ball = cutOf(now, place_mm, degrees(cut.angle_deg).si()))
        balls.push_back(*ball);
  }
  if (balls.empty()) return {};
  const auto largest = std::max_element(
      balls.begin(), balls.end(),
      [](const auto& a, const auto& b) { return a.halfAxes.maxCoeff() < b.halfAxes.maxCoeff(); });
  const Eigen::Vector2d middle = largest->center;
  std::vector<Eigen::Vector2d> ring;
  for (int k = 0; k < directions; ++k) {
    const double turn = 2.0 * pi * k / directions;
    const Eigen::Vector2d way(std::cos(turn), std::sin(turn));
    double reach = 0.0;
    for (const Ellipse& ball : balls) reach = std::max(reach, farSide(ball, middle, way));
    ring.push_back(middle + reach * way);
  }
  return ring;
}

/// Maps positions of the section to the page, to scale.
struct Frame {
  double x, y, px_mm;  // of the section's center
  PagePoint at(const Eigen::Vector2d& place_mm) const
  {
    return {x + px_mm * place_mm.x(), y - px_mm * place_mm.y()};
  }
};

void drawArray(PlotSheet& sheet, const Frame& frame, const ArrayInScala& now,
               const figures::Palette& ink)
{
  std::vector<PagePoint> ring;
  for (const Eigen::Vector2d& place_mm : cut_mm(now)) ring.push_back(frame.at(place_mm));
  if (ring.empty()) return;
  ring.push_back(ring.front());
  sheet.add(Area{ring, ink.silicone});
  sheet.add(Stroke{ring, ink.platinum, 1.5, 0.0});
}

/// @return Magnitude of the force [mN].
double drawForce(PlotSheet& sheet, const Frame& frame, const ArrayInScala& now,
                 const figures::Palette& ink)
{
  Eigen::Vector2d force_mN = Eigen::Vector2d::Zero();
  for (const NodePlace& node : now.nodes())
    if (node.fromTip_mm <= TipSection::forceReach_mm)
      force_mN += Eigen::Vector2d(node.pushAcross_mN, node.pushUp_mN);
  const double size_mN = force_mN.norm();
  const double length = std::min(TipSection::longestArrow_px, TipSection::arrow_px_mN * size_mN);
  if (length < 3.0) return size_mN;

  // from the array's edge at the wall, through the array, in the direction of the wall's force
  const NodePlace cut = now.at(inMillimeters(cutBehindTip(now)));
  const double radius_mm = 0.5 * inMillimeters(now.array().sectionAt(cutBehindTip(now)).within);
  const Eigen::Vector2d way = force_mN / size_mN;
  const PagePoint from = frame.at(Eigen::Vector2d(cut.across_mm, cut.up_mm) - radius_mm * way);
  const double head = std::min(9.0, 0.6 * length);
  const auto along = [&](double px, double aside) {
    return PagePoint{from.x + px * way.x() + aside * way.y(),
                     from.y - px * way.y() + aside * way.x()};
  };
  sheet.add(Stroke{{along(0.0, 0.0), along(length - head, 0.0)}, ink.ground, 5.0, 0.0});
  sheet.add(Stroke{{along(0.0, 0.0), along(length - head, 0.0)}, ink.orange, 2.5, 0.0});
  sheet.add(Area{
      {along(length, 0.0), along(length - head, 0.5 * head), along(length - head, -0.5 * head)},
      ink.orange});
  return size_mN;
}

void drawScaleBar(PlotSheet& sheet, const Frame& frame, const ChartStyle& style)
{
  const figures::Palette& ink = figures::paletteOf(style.scheme);
  constexpr double bar_mm = 0.5;
  const double right = sheet.right() - 10.0, y = sheet.top() + 13.0;
  const double left = right - bar_mm * frame.px_mm;
  for (const double end : {left, right})
    sheet.add(Stroke{{{end, y - 4.0}, {end, y + 4.0}}, ink.text, 1.4, 0.0});
  sheet.add(Stroke{{{left, y}, {right, y}}, ink.text, 1.4, 0.0});
  sheet.write({left - 8.0, y + 4.0}, figures::withDecimalSign("0.5 mm", style.strings.decimalSign),
              ink.quiet, Anchor::end);
}

}  // namespace

TipSection::TipSection(const anatomy::ScalaTympani& scala, ChartStyle style)
    : scala_(scala), style_(std::move(style))
{
  const double last = scala.lastAngle().si();
  for (double angle = 0.0; angle <= last; angle += degrees(10).si())
    for (const Eigen::Vector2d& place_mm : wall_mm(scala, angle)) {
      halfWidth_mm_ = std::max(halfWidth_mm_, std::abs(place_mm.x()));
      halfHeight_mm_ = std::max(halfHeight_mm_, std::abs(place_mm.y()));
    }
}

double TipSection::angle_deg(const ArrayInScala& now)
{
  if (now.nodes().empty()) return 0.0;
  return std::max(0.0, now.at(inMillimeters(cutBehindTip(now))).angle_deg);
}

figures::Drawing TipSection::draw(const ArrayInScala& now, double width, double height) const
{
  const figures::Palette& ink = figures::paletteOf(style_.scheme);
  const ChartStrings& strings = style_.strings;
  PlotSheet sheet(width, height, {0.0, 0.0, 0.0, 0.0}, {0.0, 1.0, 1.0}, {0.0, 1.0, 1.0}, style_);
  const double angle = degrees(angle_deg(now)).si();
  const double space_x = std::max(20.0, width - 2.0 * side_px);
  const bool isLow = height < lowView_px;
  const double space_y = std::max(20.0, height - top_px - (isLow ? lowBottom_px : bottom_px));
  const Frame frame{0.5 * width, top_px + 0.5 * space_y,
                    std::min(0.5 * space_x / halfWidth_mm_, 0.5 * space_y / halfHeight_mm_)};

  std::vector<PagePoint> wall;
  double inner_mm = 0.0, outer_mm = 0.0;
  for (const Eigen::Vector2d& place_mm : wall_mm(scala_, angle)) {
    wall.push_back(frame.at(place_mm));
    inner_mm = std::min(inner_mm, place_mm.x());
    outer_mm = std::max(outer_mm, place_mm.x());
  }
  sheet.add(Area{wall, ink.lumen});
  wall.push_back(wall.front());
  sheet.add(Stroke{wall, ink.bone, 2.0, 0.0});

  const Eigen::Vector3d center_W = scala_.center_W(angle);
  const auto membraneAt = [&](double across) {
    const Eigen::Vector3d place_W = scala_.membrane_W(angle, across);
    return Eigen::Vector2d(1e3 * (place_W.head<2>().norm() - center_W.head<2>().norm()),
                           1e3 * (place_W.z() - center_W.z()));
  };
  const PagePoint membrane[] = {frame.at(membraneAt(0.0)), frame.at(membraneAt(1.0))};
  sheet.add(Stroke{{membrane[0], membrane[1]}, ink.membrane, 4.0, 0.0});
  const double above = std::min({membrane[0].y, membrane[1].y, frame.at({0.0, 0.0}).y}) - 8.0;
  sheet.write({0.5 * (membrane[0].x + membrane[1].x), above}, strings.basilarMembrane, ink.membrane,
              Anchor::middle);
  const double names = frame.at({0.0, -halfHeight_mm_}).y + 16.0;
  const std::string inward = "← " + strings.modiolus, outward = strings.outerWall + " →";
  const double left = std::max(8.0, frame.at({inner_mm, 0.0}).x);
  const double right = std::min(width - 8.0, frame.at({outer_mm, 0.0}).x);
  const bool areBeside = widthOfLabel(inward) + widthOfLabel(outward) + namesGap_px <= right - left;
  if (!isLow) {
    sheet.write({left, names}, inward, ink.quiet);
    sheet.write({right, areBeside ? names : names + 14.0}, outward, ink.quiet, Anchor::end);
  }

  double force_mN = 0.0;
  if (now.isInside()) {
    drawArray(sheet, frame, now, ink);
    force_mN = drawForce(sheet, frame, now, ink);
  }
  sheet.write({10.0, height - 10.0},
              now.isInside()
                  ? figures::filled(strings.wallForce, {written(force_mN, 0, strings.decimalSign)})
                  : strings.tipIsOutside,
              now.isInside() && force_mN >= 1.0 ? ink.orange : ink.quiet);
  drawScaleBar(sheet, frame, style_);
  return sheet.take();
}

}  // namespace perilymph::charts
