// SPDX-License-Identifier: BSD-3-Clause

// The flat views draw an array as far in the wall as it is, and no farther.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "perilymph/charts/TipSection.h"
#include "perilymph/charts/UnrolledScala.h"
#include "perilymph/device/ScriptedDevice.h"
#include "perilymph/session/Insertion.h"

namespace perilymph::test {
namespace {

using figures::Drawing;
using figures::PagePoint;

constexpr double precision_mm = 0.02;  ///< Difference between drawing and cochlea.
constexpr double tip_mm = 2.0;         ///< The end of the array that the section may cut.
constexpr double page_px = 2000.0;

/// An array on its way in.
struct Inserted {
  std::unique_ptr<charts::ArrayInScala> array;
  double maxInWall_mm = 0.0;  ///< How far it is in the wall, maximum over the nodes.
  double tipInWall_mm = 0.0;  ///< The same within tip_mm of the tip.
};

Inserted located(const session::Insertion& insertion, const electrode::ArrayDesign& design)
{
  haptics::Snapshot now;
  insertion.loop().engine().fill(now);
  const anatomy::ScalaTympani& scala = insertion.anatomy();
  Inserted inserted;
  inserted.array = std::make_unique<charts::ArrayInScala>(scala, design);
  inserted.array->follow(now);
  anatomy::LumenTrack track = scala.startTrack();
  for (std::size_t i = 0; i < inserted.array->nodes().size(); ++i) {
    const charts::NodePlace& node = inserted.array->nodes()[i];
    const electrode::Section section = design.sectionAt(millimeters(node.fromTip_mm));
    const double half = 0.5 * std::max(section.within, section.across).si();
    anatomy::WallPoint wall;
    scala.nearestWall({&inserted.array->nodes_W()[i], 1}, {&half, 1}, {&track, 1}, {&wall, 1});
    const double inWall_mm = wall.isNear ? std::max(0.0, 1e3 * (half - wall.distance)) : 0.0;
    inserted.maxInWall_mm = std::max(inserted.maxInWall_mm, inWall_mm);
    if (node.fromTip_mm <= tip_mm)
      inserted.tipInWall_mm = std::max(inserted.tipInWall_mm, inWall_mm);
  }
  return inserted;
}

/// Inserts a scenario's array to full depth; `see` gets it every millimeter and at the end.
void insert(const std::string& name, const std::function<void(const Inserted&)>& see)
{
  const auto scenario = session::loadScenario(name);
  ASSERT_TRUE(scenario);
  const session::InsertionParameters& parameters = scenario->parameters();
  auto prepared = session::Insertion::prepare(
      parameters,
      std::make_unique<device::ScriptedDevice>(parameters.speed.si(), parameters.timeStep.si()));
  ASSERT_TRUE(prepared);
  const session::Insertion& insertion = **prepared;
  double next = 1e-3;  // [m]
  const auto ran = (*prepared)->runToEnd([&](const haptics::TickRecord& record) {
    if (record.output.travel < next) return true;
    next += 1e-3;
    see(located(insertion, parameters.array));
    return true;
  });
  ASSERT_TRUE(ran);
  see(located(insertion, parameters.array));
}

template <class Kind>
std::vector<Kind> all(const Drawing& drawing, const figures::Ink& ink)
{
  std::vector<Kind> found;
  for (const figures::Mark& mark : drawing.marks)
    if (const auto* one = std::get_if<Kind>(&mark); one != nullptr && one->ink == ink)
      found.push_back(*one);
  return found;
}

const figures::Palette& inks() { return figures::paletteOf(figures::ColorScheme::dark); }

std::vector<PagePoint> arrayIn(const Drawing& drawing)
{
  const auto areas = all<figures::Area>(drawing, inks().silicone);
  return areas.empty() ? std::vector<PagePoint>() : areas.front().points;
}

/// Distance of a point outside a closed polygon; 0 inside.
double outside(const PagePoint& point, const std::vector<PagePoint>& polygon)
{
  bool isInside = false;
  double nearest = 1e9;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const PagePoint& a = polygon[i];
    const PagePoint& b = polygon[(i + 1) % polygon.size()];
    if ((a.y > point.y) != (b.y > point.y) &&
        point.x < a.x + (b.x - a.x) * (point.y - a.y) / (b.y - a.y))
      isInside = !isInside;
    const double x = b.x - a.x, y = b.y - a.y, square = x * x + y * y;
    const double fraction =
        square > 0.0 ? std::clamp(((point.x - a.x) * x + (point.y - a.y) * y) / square, 0.0, 1.0)
                     : 0.0;
    nearest =
        std::min(nearest, std::hypot(point.x - a.x - fraction * x, point.y - a.y - fraction * y));
  }
  return isInside ? 0.0 : nearest;
}

/// Height of a line at a place; the line runs from left to right.
double heightAt(const std::vector<PagePoint>& line, double x)
{
  for (std::size_t i = 1; i < line.size(); ++i)
    if (x <= line[i].x)
      return line[i - 1].y +
             (x - line[i - 1].x) / (line[i].x - line[i - 1].x) * (line[i].y - line[i - 1].y);
  return line.back().y;
}

/// How far the section's array is drawn beyond the wall [mm].
double drawnInSection(const charts::ArrayInScala& array)
{
  const Drawing drawing = charts::TipSection(array.scala()).draw(array, page_px, page_px);
  const auto walls = all<figures::Stroke>(drawing, inks().bone);
  EXPECT_EQ(walls.size(), 1u);
  double bar_px = 0.0;  // 0.5 mm, the longest line in the color of text
  for (const figures::Stroke& stroke : all<figures::Stroke>(drawing, inks().text))
    bar_px = std::max(bar_px, std::abs(stroke.points.back().x - stroke.points.front().x));
  double drawn_px = 0.0;
  const auto outline = arrayIn(drawing);
  EXPECT_FALSE(outline.empty());
  for (const PagePoint& point : outline)
    drawn_px = std::max(drawn_px, outside(point, walls.front().points));
  return 0.5 * drawn_px / bar_px;
}

/// The same in the unrolled view, behind the round window [mm].
double drawnUnrolled(const charts::ArrayInScala& array)
{
  const Drawing drawing = charts::UnrolledScala(array.scala()).draw(array, page_px, page_px);
  const auto walls = all<figures::Stroke>(drawing, inks().bone);
  EXPECT_EQ(walls.size(), 2u);
  double zero_px = 0.0, one_px = 0.0;
  for (const figures::Mark& mark : drawing.marks)
    if (const auto* label = std::get_if<figures::Label>(&mark)) {
      if (label->text == "0") zero_px = label->at.y;
      if (label->text == "1") one_px = label->at.y;
    }
  const double mm_px = 1.0 / (zero_px - one_px);
  EXPECT_GT(mm_px, 0.0);
  double drawn_mm = 0.0;
  const double roundWindow_px = walls[0].points[1].x;
  for (const PagePoint& point : arrayIn(drawing))
    if (point.x >= roundWindow_px)
      drawn_mm = std::max({drawn_mm, mm_px * (heightAt(walls[0].points, point.x) - point.y),
                           mm_px * (point.y - heightAt(walls[1].points, point.x))});
  return drawn_mm;
}

class FlatViews : public testing::TestWithParam<const char*> {};

TEST_P(FlatViews, DrawTheArrayAsFarInTheWallAsItIs)
{
  int seen = 0;
  insert(GetParam(), [&seen](const Inserted& inserted) {
    ++seen;
    const double depth = inserted.array->nodes().back().angle_deg;
    EXPECT_LE(drawnInSection(*inserted.array), inserted.tipInWall_mm + precision_mm) << depth;
    EXPECT_LE(drawnUnrolled(*inserted.array), inserted.maxInWall_mm + precision_mm) << depth;
  });
  EXPECT_GT(seen, 10);
}

INSTANTIATE_TEST_SUITE_P(UpToFullDepth, FlatViews,
                         testing::Values("contour-published", "mean-contour", "mean-flex28"));

}  // namespace
}  // namespace perilymph::test
