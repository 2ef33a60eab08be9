// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/charts/UnrolledScala.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "PlotSheet.h"
#include "perilymph/foundation/Units.h"

namespace perilymph::charts {

using figures::Anchor;
using figures::Area;
using figures::Disk;
using figures::PagePoint;
using figures::Stroke;

namespace {

constexpr double step_deg = 5.0;
constexpr int wallDirections = 72;
constexpr double outside_deg = 20.0;  ///< Shown before the round window.
constexpr double usualEnd_deg = 540.0, tick_deg = 90.0;
constexpr double ahead_deg = 30.0;                              ///< Space kept free before the tip.
constexpr double outerMargin_mm = 0.95, innerMargin_mm = 0.65;  ///< Beyond the walls, for the bars.
constexpr double minShown_mN = 1.0;
constexpr double fewestForNames_px = 56.0;  ///< Height in which the walls' names do not meet.

/// Forces on one millimeter of the array.
struct Stretch {
  int fromTip_mm = 0;  ///< Distance of its distal end from the tip.
  double normal_mN = 0.0, across_mN = 0.0, up_mN = 0.0;
  double from_deg = 0.0, to_deg = 0.0;
};

std::vector<Stretch> stretches(const ArrayInScala& now)
{
  std::vector<Stretch> all;
  int before = -1;
  for (const NodePlace& node : now.nodes()) {
    const int number = static_cast<int>(node.fromTip_mm);
    if (number != before) all.push_back({number, 0.0, 0.0, 0.0, node.angle_deg, node.angle_deg});
    before = number;
    Stretch& here = all.back();
    here.normal_mN += node.normal_mN;
    here.across_mN += node.pushAcross_mN;
    here.up_mN += node.pushUp_mN;
    here.to_deg = node.angle_deg;
  }
  return all;
}

std::vector<PagePoint> diamondAt(PagePoint at, double radius_px)
{
  return {{at.x, at.y - radius_px},
          {at.x + radius_px, at.y},
          {at.x, at.y + radius_px},
          {at.x - radius_px, at.y},
          {at.x, at.y - radius_px}};
}

void drawContacts(PlotSheet& sheet, const ArrayInScala& now, const figures::Palette& ink)
{
  const electrode::ArrayDesign& array = now.array();
  const double half_mm = 0.5 * inMillimeters(array.contactLength);
  for (const Length contact : array.contactsFromTip) {
    const double place_mm = inMillimeters(contact);
    const NodePlace back = now.at(place_mm + half_mm);
    const NodePlace front = now.at(place_mm - half_mm);
    if (back.angle_deg < -outside_deg) continue;
    const double radius_mm = 0.5 * inMillimeters(array.sectionAt(contact).within);
    // on the side facing the modiolus
    sheet.add(
        Area{{sheet.at(back.angle_deg, back.across_mm - radius_mm),
              sheet.at(front.angle_deg, front.across_mm - radius_mm),
              sheet.at(front.angle_deg, front.across_mm), sheet.at(back.angle_deg, back.across_mm)},
             ink.platinum});
  }
}

/// The sides of a stretch of the array.
struct Sides {
  void add(const PlotSheet& sheet, const ArrayInScala& now, const NodePlace& node)
  {
    const Length place = millimeters(node.fromTip_mm);
    const double radius_mm = 0.5 * inMillimeters(now.array().sectionAt(place).within);
    upper.push_back(sheet.at(node.angle_deg, node.across_mm + radius_mm));
    lower.push_back(sheet.at(node.angle_deg, node.across_mm - radius_mm));
  }
  std::vector<PagePoint> upper, lower;
};

/// Outlines the parts of the array above the partition.
void outlineAbove(PlotSheet& sheet, const ArrayInScala& now, const figures::Palette& ink)
{
  Sides sides;
  const auto finish = [&] {
    for (std::vector<PagePoint>* side : {&sides.upper, &sides.lower}) {
      if (side->size() > 1) sheet.add(Stroke{*side, ink.rupture, 2.0, 0.0});
      side->clear();
    }
  };
  for (const NodePlace& node : now.nodes())
    if (node.isAbove)
      sides.add(sheet, now, node);
    else
      finish();
  finish();
}

void drawArray(PlotSheet& sheet, const ArrayInScala& now, const figures::Palette& ink)
{
  Sides sides;
  for (const NodePlace& node : now.nodes())
    if (node.angle_deg >= -outside_deg) sides.add(sheet, now, node);
  auto& [upper, lower] = sides;
  if (upper.size() < 2) return;
  upper.insert(upper.end(), lower.rbegin(), lower.rend());
  sheet.add(Area{upper, ink.silicone});
  drawContacts(sheet, now, ink);
  upper.push_back(upper.front());
  sheet.add(Stroke{upper, ink.ground, 1.0, 0.0});
  outlineAbove(sheet, now, ink);
}

}  // namespace

UnrolledScala::UnrolledScala(const anatomy::ScalaTympani& scala, ChartStyle style)
    : style_(std::move(style)),
      lastAngle_deg_(inDegrees(scala.lastAngle())),
      leadIn_deg_(inDegrees(radians(scala.leadIn().si() / scala.center_W(0.0).head<2>().norm())))
{
  for (double angle_deg = 0.0; angle_deg <= lastAngle_deg_; angle_deg += step_deg) {
    const double angle = degrees(angle_deg).si();
    const double center = scala.center_W(angle).head<2>().norm();
    Width width{angle_deg, 0.0, 0.0};
    for (int k = 0; k < wallDirections; ++k) {
      const Eigen::Vector3d wall_W = scala.wall_W(angle, 2.0 * pi * k / wallDirections);
      const double across_mm = 1e3 * (wall_W.head<2>().norm() - center);
      width.inner_mm = std::min(width.inner_mm, across_mm);
      width.outer_mm = std::max(width.outer_mm, across_mm);
    }
    widths_.push_back(width);
    inner_mm_ = std::min(inner_mm_, width.inner_mm);
    outer_mm_ = std::max(outer_mm_, width.outer_mm);
  }
}

UnrolledScala::Width UnrolledScala::widthAt(double angle_deg) const
{
  const double index = std::clamp(angle_deg / step_deg, 0.0, double(widths_.size() - 1));
  const std::size_t i = std::min(widths_.size() - 2, static_cast<std::size_t>(index));
  const double fraction = index - static_cast<double>(i);
  const Width& a = widths_[i];
  const Width& b = widths_[i + 1];
  return {angle_deg, a.inner_mm + fraction * (b.inner_mm - a.inner_mm),
          a.outer_mm + fraction * (b.outer_mm - a.outer_mm)};
}

void UnrolledScala::drawLumen(PlotSheet& sheet, double last_deg) const
{
  const figures::Palette& ink = figures::paletteOf(style_.scheme);
  // from the opening on
  std::vector<PagePoint> outer{sheet.at(-leadIn_deg_, widths_.front().outer_mm)};
  std::vector<PagePoint> inner{sheet.at(-leadIn_deg_, widths_.front().inner_mm)};
  for (const Width& here : widths_) {
    if (here.angle_deg > last_deg) break;
    outer.push_back(sheet.at(here.angle_deg, here.outer_mm));
    inner.push_back(sheet.at(here.angle_deg, here.inner_mm));
  }
  std::vector<PagePoint> lumen = outer;
  lumen.insert(lumen.end(), inner.rbegin(), inner.rend());
  sheet.add(Area{lumen, ink.lumen});
  sheet.add(Stroke{outer, ink.bone, 1.5, 0.0});
  sheet.add(Stroke{inner, ink.bone, 1.5, 0.0});
  sheet.add(Stroke{{outer.front(), inner.front()}, figures::faded(ink.bone, 0.5), 1.0, 4.0});
}

figures::Drawing UnrolledScala::draw(const ArrayInScala& now, double width, double height) const
{
  const figures::Palette& ink = figures::paletteOf(style_.scheme);
  const ChartStrings& strings = style_.strings;
  const double tip_deg = now.nodes().empty() ? 0.0 : now.nodes().back().angle_deg;
  AxisRange angle_deg = grown({-outside_deg, usualEnd_deg, tick_deg}, 0.0, tip_deg + ahead_deg, 99);
  angle_deg.high = std::min(angle_deg.high, lastAngle_deg_);
  const AxisRange across_mm{inner_mm_ - innerMargin_mm, outer_mm_ + outerMargin_mm, 1.0};
  PlotSheet sheet(width, height, {40.0, 8.0, 4.0, 22.0}, angle_deg, across_mm, style_);
  sheet.addXTicks(2, "°");
  sheet.addYTicks(0);

  drawLumen(sheet, angle_deg.high);
  for (const auto& [from_deg, to_deg] : now.torn_deg()) {
    std::vector<PagePoint> torn, modiolar;
    double foot = sheet.top();
    for (double at_deg = from_deg; at_deg < to_deg + step_deg; at_deg += step_deg) {
      const Width here = widthAt(std::min(at_deg, to_deg));
      torn.push_back(sheet.at(here.angle_deg, here.outer_mm));
      modiolar.push_back(sheet.at(here.angle_deg, here.inner_mm));
      foot = std::max(foot, modiolar.back().y);
    }
    torn.insert(torn.end(), modiolar.rbegin(), modiolar.rend());
    sheet.add(Area{torn, figures::faded(ink.rupture, 0.35)});
    sheet.write({sheet.x(0.5 * (from_deg + to_deg)), foot + 13.0}, strings.rupture, ink.rupture,
                Anchor::middle);
  }
  drawArray(sheet, now, ink);
  const double length_px = bar_px / bar_mN_mm;
  for (const Stretch& here : stretches(now)) {
    if (here.normal_mN < minShown_mN || here.from_deg < -leadIn_deg_) continue;
    const double middle_deg = 0.5 * (here.from_deg + here.to_deg);
    const double bar = std::min(length_px * here.normal_mN, 1.6 * bar_px);
    if (std::abs(here.up_mN) > std::abs(here.across_mN)) {
      const NodePlace node = now.at(here.fromTip_mm + 0.5);
      sheet.add(Disk{sheet.at(node.angle_deg, node.across_mm), 1.5 + 0.2 * bar,
                     figures::faded(ink.orange, 0.35), ink.orange});
      continue;
    }
    const Width at = widthAt(middle_deg);
    const bool isOuter = here.across_mN < 0.0;
    const double wall = sheet.y(isOuter ? at.outer_mm : at.inner_mm);
    const double end = isOuter ? wall - 1.5 - bar : wall + 1.5 + bar;
    const double left = sheet.x(here.from_deg), right = std::max(sheet.x(here.to_deg), left + 2.0);
    sheet.add(Area{{{left, wall}, {right, wall}, {right, end}, {left, end}}, ink.orange});
  }

  // scale of the bars, at the end of the scala, where it is narrow
  const double x = sheet.right() - 6.0;
  const double shared = widthOfLabel(strings.wallForceScale) + widthOfLabel(strings.modiolus);
  const bool areBeside = shared + 30.0 <= sheet.right() - sheet.left();
  if (sheet.bottom() - sheet.top() >= fewestForNames_px) {
    sheet.write({x, sheet.top() + 14.0}, strings.outerWall, ink.quiet, Anchor::end);
    sheet.write({x, sheet.bottom() - (areBeside ? 6.0 : 22.0)}, strings.modiolus, ink.quiet,
                Anchor::end);
  }
  const double legend = sheet.left() + 8.0;
  const double foot = sheet.bottom() - 4.0;
  sheet.add(Area{{{legend, foot},
                  {legend + 5.0, foot},
                  {legend + 5.0, foot - bar_px},
                  {legend, foot - bar_px}},
                 ink.orange});
  sheet.write({legend + 11.0, foot - 4.0}, strings.wallForceScale, ink.quiet);
  return sheet.take();
}

figures::Drawing UnrolledScala::drawFound(const std::vector<FoundPlace>& found,
                                          const std::vector<PlannedPlace>& planned, double width,
                                          double height) const
{
  const figures::Palette& ink = figures::paletteOf(style_.scheme);
  AxisRange angle_deg{-outside_deg, usualEnd_deg, tick_deg};
  for (const FoundPlace& each : found)
    angle_deg = grown(angle_deg, 0.0, each.high_deg + ahead_deg, 99);
  for (const PlannedPlace& each : planned)
    angle_deg = grown(angle_deg, 0.0, each.high_deg + ahead_deg, 99);
  angle_deg.high = std::min(angle_deg.high, lastAngle_deg_);
  PlotSheet sheet(width, height, {40.0, 8.0, 4.0, 22.0}, angle_deg,
                  {inner_mm_ - innerMargin_mm, outer_mm_ + outerMargin_mm, 1.0}, style_);
  sheet.addXTicks(2, "°");
  sheet.addYTicks(0);
  drawLumen(sheet, angle_deg.high);

  const auto inside = [&](double at_deg) {
    return std::clamp(at_deg, angle_deg.low, angle_deg.high);
  };
  if (!planned.empty()) {
    const PlannedPlace& tip = planned.front();
    sheet.add(Area{{{sheet.x(inside(tip.low_deg)), sheet.top()},
                    {sheet.x(inside(tip.high_deg)), sheet.top()},
                    {sheet.x(inside(tip.high_deg)), sheet.bottom()},
                    {sheet.x(inside(tip.low_deg)), sheet.bottom()}},
                   figures::faded(ink.ghost, 0.25)});
    sheet.add(Stroke{{{sheet.x(inside(tip.median_deg)), sheet.top()},
                      {sheet.x(inside(tip.median_deg)), sheet.bottom()}},
                     ink.ghost,
                     1.5,
                     4.0});
  }
  constexpr double bar_mm = 0.12;
  for (const PlannedPlace& each : planned) {
    const double wall_mm = widthAt(each.median_deg).inner_mm - 2.0 * bar_mm;
    sheet.add(
        Area{{sheet.at(inside(each.low_deg), wall_mm), sheet.at(inside(each.high_deg), wall_mm),
              sheet.at(inside(each.high_deg), wall_mm - bar_mm),
              sheet.at(inside(each.low_deg), wall_mm - bar_mm)},
             figures::faded(ink.ghost, 0.5)});
    sheet.add(Stroke{{sheet.at(inside(each.median_deg), wall_mm + bar_mm),
                      sheet.at(inside(each.median_deg), wall_mm - 2.0 * bar_mm)},
                     ink.ghost,
                     1.5,
                     0.0});
  }
  constexpr double contact_px = 3.5, diamond_px = 5.0;
  for (const FoundPlace& each : found) {
    const double across_mm = widthAt(each.angle_deg).inner_mm + each.modiolus_mm;
    const figures::PagePoint at = sheet.at(inside(each.angle_deg), across_mm);
    sheet.add(Stroke{
        {sheet.at(inside(each.low_deg), across_mm), sheet.at(inside(each.high_deg), across_mm)},
        ink.text,
        1.0,
        0.0});
    const figures::Ink fill = each.isPlaced ? ink.accent : ink.ground;
    if (each.isAbove) {
      const auto diamond = diamondAt(at, diamond_px);
      sheet.add(Area{diamond, fill});
      sheet.add(Stroke{diamond, ink.text, 1.0, 0.0});
    } else {
      sheet.add(Disk{at, contact_px, fill, ink.text});
    }
    sheet.write({at.x, at.y - contact_px - 3.0}, std::to_string(each.number), ink.text,
                Anchor::middle);
  }
  if (sheet.bottom() - sheet.top() >= fewestForNames_px) {
    const double x = sheet.left() + 6.0;
    sheet.write({x, sheet.top() + 14.0}, style_.strings.outerWall, ink.quiet);
    sheet.write({x, sheet.bottom() - 6.0}, style_.strings.modiolus, ink.quiet);
  }
  return sheet.take();
}

figures::Drawing UnrolledScala::drawPage(const ArrayInScala& now, double width, double height) const
{
  constexpr double line_px = 20.0;
  PlotSheet page(width, height, {}, {}, {}, style_);
  figures::Drawing whole = page.take();
  whole.marks.resize(1);  // the background only
  figures::Drawing view = draw(now, width, height - line_px);
  whole.marks.insert(whole.marks.end(), view.marks.begin(), view.marks.end());
  whole.marks.emplace_back(figures::Label{{0.5 * width, height - 8.0},
                                          style_.strings.unrolledAxes,
                                          figures::labelSize,
                                          figures::paletteOf(style_.scheme).quiet,
                                          Anchor::middle,
                                          figures::Direction::across,
                                          false});
  return whole;
}

}  // namespace perilymph::charts
