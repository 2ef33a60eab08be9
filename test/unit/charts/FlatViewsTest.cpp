// SPDX-License-Identifier: BSD-3-Clause

// The flat views are drawings: their values are read from their axes and scale bars.

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <optional>

#include "RingScala.h"
#include "perilymph/charts/TipSection.h"
#include "perilymph/charts/UnrolledScala.h"

namespace perilymph::charts {
namespace {

using figures::Area;
using figures::Drawing;
using figures::Ink;
using figures::Label;
using figures::Stroke;

constexpr Ink silicone{{0xDC, 0xE4, 0xE9}, 1.0};
constexpr Ink rupture{{0xFF, 0x4D, 0x4D}, 1.0}, tornLumen{{0xFF, 0x4D, 0x4D}, 0.35};
constexpr Ink orange{{0xE6, 0x9F, 0x00}, 1.0};
constexpr double pixel = 1.0;

template <class Kind>
std::vector<Kind> all(const Drawing& drawing, const Ink& ink)
{
  std::vector<Kind> found;
  for (const figures::Mark& mark : drawing.marks)
    if (const auto* one = std::get_if<Kind>(&mark); one != nullptr && one->ink == ink)
      found.push_back(*one);
  return found;
}

std::optional<Label> label(const Drawing& drawing, const std::string& text)
{
  for (const figures::Mark& mark : drawing.marks)
    if (const auto* one = std::get_if<Label>(&mark); one != nullptr && one->text == text)
      return *one;
  return std::nullopt;
}

struct Box {
  double left = 1e9, right = -1e9, top = 1e9, bottom = -1e9;
  double width() const { return right - left; }
  double height() const { return bottom - top; }
};

Box boxOf(const std::vector<figures::PagePoint>& points)
{
  Box box;
  for (const figures::PagePoint& point : points) {
    box.left = std::min(box.left, point.x);
    box.right = std::max(box.right, point.x);
    box.top = std::min(box.top, point.y);
    box.bottom = std::max(box.bottom, point.y);
  }
  return box;
}

Drawing unrolled(const haptics::Snapshot& now, double width = 600.0, double height = 260.0)
{
  ArrayInScala array(*test::ringScala(), test::plainArray());
  array.follow(now);
  return UnrolledScala(*test::ringScala()).draw(array, width, height);
}

/// Reads a position from the drawn axes.
struct Axes {
  explicit Axes(const Drawing& drawing)
      : x0(label(drawing, "0°")->at.x),
        x180(label(drawing, "180°")->at.x),
        y0(label(drawing, "0")->at.y),
        y1(label(drawing, "1")->at.y)
  {
  }
  double angle_deg(double x) const { return 180.0 * (x - x0) / (x180 - x0); }
  double across_mm(double y) const { return (y + words_px - y0) / (y1 - y0); }
  double x0, x180, y0, y1;
  static constexpr double words_px = 4.0;  // of a number's baseline below its tick
};

TEST(UnrolledScala, ShowsTheArrayUpToItsTipBesideTheTrueNumbers)
{
  const Drawing drawing = unrolled(test::laidTo(300.0, 0.4));
  const Axes axes(drawing);
  const auto silicones = all<Area>(drawing, silicone);
  ASSERT_EQ(silicones.size(), 1u);
  const Box box = boxOf(silicones.front().points);
  EXPECT_NEAR(axes.angle_deg(box.right), 300.0, 1.0);
  EXPECT_NEAR(axes.across_mm(box.top), 0.4 + 0.5 * test::diameter_mm, 0.02);
  EXPECT_NEAR(axes.across_mm(box.bottom), 0.4 - 0.5 * test::diameter_mm, 0.02);
}

TEST(UnrolledScala, GrowsByQuarterTurnsWithTheTip)
{
  EXPECT_TRUE(label(unrolled(test::laidTo(500.0, 0.0)), "540°"));
  const Drawing deep = unrolled(test::laidTo(600.0, 0.0));
  EXPECT_TRUE(label(deep, "540°"));
  // 720 degrees: the next quarter turn; the tip has nearly reached 630
  const Drawing deeper = unrolled(test::laidTo(610.0, 0.0));
  EXPECT_TRUE(label(deeper, "720°"));
}

TEST(UnrolledScala, NamesItsWallsWhereTheNamesDoNotMeet)
{
  ArrayInScala array(*test::ringScala(), test::plainArray());
  array.follow(test::laidTo(300.0, 0.0));
  const UnrolledScala scala(*test::ringScala());
  const ChartStrings words;
  const Drawing high = scala.draw(array, 600.0, 150.0);
  ASSERT_TRUE(label(high, words.outerWall) && label(high, words.modiolus));
  EXPECT_LT(label(high, words.outerWall)->at.y + 14.0, label(high, words.modiolus)->at.y);
  const Drawing low = scala.draw(array, 600.0, 60.0);
  EXPECT_FALSE(label(low, words.outerWall) || label(low, words.modiolus));
}

TEST(UnrolledScala, AForceOfTheOuterWallStandsBeyondTheOuterWall)
{
  haptics::Snapshot now = test::laidTo(300.0, 0.7);
  test::push(now, 50, -25.0);
  const Drawing drawing = unrolled(now);
  const Axes axes(drawing);
  const auto bars = all<Area>(drawing, orange);
  ASSERT_EQ(bars.size(), 2u);  // the node's and the legend's
  const Box bar = boxOf(bars.front().points);
  EXPECT_NEAR(axes.angle_deg(0.5 * (bar.left + bar.right)), 150.0, 10.0);
  EXPECT_NEAR(axes.across_mm(bar.bottom), test::lumen_mm, 0.03);
}

TEST(UnrolledScala, AForceOfTheInnerWallStandsBeyondTheInnerWall)
{
  haptics::Snapshot now = test::laidTo(300.0, -0.7);
  test::push(now, 50, 25.0);
  const Drawing drawing = unrolled(now);
  const Axes axes(drawing);
  const Box bar = boxOf(all<Area>(drawing, orange).front().points);
  EXPECT_NEAR(axes.across_mm(bar.top), -test::lumen_mm, 0.03);
}

TEST(UnrolledScala, ABarIsAsLongAsItsLegendSays)
{
  haptics::Snapshot now = test::laidTo(300.0, 0.7);
  test::push(now, 50, -25.0);
  const auto bars = all<Area>(unrolled(now), orange);
  const double half =
      boxOf(bars.front().points).height() - 1.5;  // it starts at the edge of the wall's line
  EXPECT_NEAR(2.0 * half, boxOf(bars.back().points).height(), pixel);
}

TEST(UnrolledScala, ShowsWhereThePartitionIsTornAndWhatIsAboveIt)
{
  haptics::Snapshot now = test::laidTo(300.0, 0.4);
  EXPECT_FALSE(label(unrolled(now), "rupture"));
  now.ruptures = 1;
  now.ruptured[0] = {degrees(200.0).si(), degrees(240.0).si()};
  for (std::size_t i = 80; i <= 100; ++i) now.isAbove.set(i);  // from 240 degrees on
  const Drawing drawing = unrolled(now);
  const Axes axes(drawing);
  const auto torn = all<Area>(drawing, tornLumen);
  ASSERT_EQ(torn.size(), 1u);
  const Box range = boxOf(torn.front().points);
  EXPECT_NEAR(axes.angle_deg(range.left), 200.0, 0.5);
  EXPECT_NEAR(axes.angle_deg(range.right), 240.0, 0.5);
  EXPECT_NEAR(axes.angle_deg(label(drawing, "rupture")->at.x), 220.0, 0.5);
  const auto above = all<Stroke>(drawing, rupture);
  ASSERT_EQ(above.size(), 2u);  // both sides of the array
  for (const Stroke& side : above) {
    const Box outline = boxOf(side.points);
    EXPECT_NEAR(axes.angle_deg(outline.left), 240.0, 0.5);
    EXPECT_NEAR(axes.angle_deg(outline.right), 300.0, 0.5);
  }
}

TEST(UnrolledScala, DrawsTheScalaAloneWhenTheSnapshotIsNotFinite)
{
  haptics::Snapshot now = test::laidTo(300.0, 0.4);
  now.node_W[3][0] = std::numeric_limits<float>::infinity();
  const Drawing drawing = unrolled(now);
  EXPECT_TRUE(all<Area>(drawing, silicone).empty());
  EXPECT_TRUE(label(drawing, "360°"));
}

TEST(UnrolledScala, FitsIntoAnyPane)
{
  for (const double size : {1.0, 40.0, 3000.0}) {
    const Drawing drawing = unrolled(test::laidTo(300.0, 0.4), size, size);
    EXPECT_DOUBLE_EQ(drawing.width, size);
    EXPECT_FALSE(drawing.marks.empty());
  }
}

Drawing section(const haptics::Snapshot& now, double width = 240.0, double height = 240.0)
{
  ArrayInScala array(*test::ringScala(), test::plainArray());
  array.follow(now);
  return TipSection(*test::ringScala()).draw(array, width, height);
}

/// The scale bar is the longest horizontal line in the text color.
double pixelsPerMillimeter(const Drawing& drawing)
{
  double longest = 0.0;
  for (const Stroke& stroke : all<Stroke>(drawing, Ink{{0xE8, 0xEC, 0xEF}, 1.0}))
    longest = std::max(longest, boxOf(stroke.points).width());
  return longest / 0.5;
}

Box outline(const Drawing& drawing)
{
  return boxOf(all<Stroke>(drawing, Ink{{0xE9, 0xDC, 0xC0}, 1.0}).front().points);
}

TEST(TipSection, DrawsScalaAndArrayToOneScale)
{
  const Drawing drawing = section(test::laidTo(300.0, 0.4));
  const double px_mm = pixelsPerMillimeter(drawing);
  EXPECT_NEAR(outline(drawing).width() / px_mm, 2.0 * test::lumen_mm, 0.03);
  EXPECT_NEAR(outline(drawing).height() / px_mm, 2.0 * test::lumen_mm, 0.03);
  // The array rises by 3 mm per turn of 21 mm: cut obliquely, its section is 1 % higher.
  const Box array = boxOf(all<Area>(drawing, silicone).front().points);
  EXPECT_NEAR(array.width() / px_mm, test::diameter_mm, 0.02);
  EXPECT_NEAR(array.height() / px_mm, test::diameter_mm, 0.02);
}

/// The scale is in the first line of the view, the membrane's name below it, however high the view is.
TEST(TipSection, NamesTheMembraneBelowTheScale)
{
  for (const double height : {120.0, 160.0, 200.0, 224.0, 240.0, 400.0}) {
    const Drawing drawing = section(test::laidTo(300.0, 0.4), 0.9 * height, height);
    const auto name = label(drawing, "basilar membrane"), scale = label(drawing, "0.5 mm");
    ASSERT_TRUE(name && scale);
    double bar = scale->at.y;
    for (const Stroke& stroke : all<Stroke>(drawing, Ink{{0xE8, 0xEC, 0xEF}, 1.0}))
      bar = std::max(bar, boxOf(stroke.points).bottom);
    EXPECT_GE(name->at.y - name->size, bar) << height;
    EXPECT_LE(name->at.y, outline(drawing).bottom) << height;
  }
}

TEST(TipSection, PutsTheArrayWhereItIsWithTheModiolusAtTheLeft)
{
  const Drawing drawing = section(test::laidTo(300.0, 0.4, -0.3));
  const double px_mm = pixelsPerMillimeter(drawing);
  const Box lumen = outline(drawing);
  const Box array = boxOf(all<Area>(drawing, silicone).front().points);
  const double right_px = 0.5 * (array.left + array.right - lumen.left - lumen.right);
  const double down_px = 0.5 * (array.top + array.bottom - lumen.top - lumen.bottom);
  EXPECT_NEAR(right_px / px_mm, 0.4, 0.02);
  EXPECT_NEAR(down_px / px_mm, 0.3, 0.02);
}

TEST(TipSection, SaysHowHardTheWallPushesTheLastMillimeter)
{
  haptics::Snapshot now = test::laidTo(300.0, 0.7);
  test::push(now, 97, -20.0);  // 0.6 mm from the tip
  test::push(now, 99, -15.0);
  test::push(now, 60, -90.0);  // far behind
  const Drawing drawing = section(now);
  EXPECT_TRUE(label(drawing, "wall force 35 mN"));
}

TEST(TipSection, ItsArrowPointsAwayFromTheWallThatPushes)
{
  haptics::Snapshot now = test::laidTo(300.0, 0.7);
  test::push(now, 99, -40.0);
  const Drawing drawing = section(now);
  const Box array = boxOf(all<Area>(drawing, silicone).front().points);
  const Box arrow = boxOf(all<Stroke>(drawing, orange).front().points);
  EXPECT_NEAR(arrow.right, array.right, 2.0 * pixel);
  EXPECT_LT(arrow.left, 0.5 * (array.left + array.right));
}

TEST(TipSection, SaysThatTheTipIsOutside)
{
  const anatomy::Entry entry = test::ringScala()->entry();
  haptics::Snapshot now{};
  now.nodes = 2;
  for (std::size_t i = 0; i < 2; ++i) {
    const Eigen::Vector3d place_W = entry.origin_W + (i == 0 ? 21e-3 : 1e-3) * entry.out_W;
    for (int k = 0; k < 3; ++k) now.node_W[i][std::size_t(k)] = static_cast<float>(place_W[k]);
  }
  const Drawing drawing = section(now);
  EXPECT_TRUE(label(drawing, "tip is outside the cochlea"));
  EXPECT_TRUE(all<Area>(drawing, silicone).empty());
}

TEST(UnrolledScala, HasFoundContactsAndPlannedBandsAtTheirAngles)
{
  const UnrolledScala view(*test::ringScala());
  const std::vector<FoundPlace> found{{1, 200.0, 190.0, 215.0, 0.5, true, false},
                                      {2, 150.0, 140.0, 160.0, 0.25, false, false},
                                      {3, 120.0, 110.0, 130.0, 0.5, true, true}};
  const Drawing drawing =
      view.drawFound(found, {{180.0, 210.0, 240.0}, {130.0, 150.0, 170.0}}, 600.0, 260.0);
  const Axes axes(drawing);
  const double perDegree = (axes.x180 - axes.x0) / 180.0;
  const auto degreesAt = [&](double x) { return (x - axes.x0) / perDegree; };
  std::vector<figures::Disk> disks;
  for (const figures::Mark& mark : drawing.marks)
    if (const auto* disk = std::get_if<figures::Disk>(&mark)) disks.push_back(*disk);
  ASSERT_EQ(disks.size(), 2u);
  EXPECT_NEAR(degreesAt(disks[0].center.x), 200.0, 0.01);
  EXPECT_NEAR(degreesAt(disks[1].center.x), 150.0, 0.01);
  // half a millimeter from the inner wall against a quarter
  const double perMillimeter = axes.y0 - axes.y1;
  EXPECT_NEAR(disks[1].center.y - disks[0].center.y, 0.25 * perMillimeter, 0.01);
  EXPECT_NE(disks[0].fill, disks[1].fill);
  // the one above the membrane: a diamond of the same fill as one that was seen, on its angle
  const auto diamonds = all<Area>(drawing, disks[0].fill);
  ASSERT_EQ(diamonds.size(), 1u);
  const Box diamond = boxOf(diamonds.front().points);
  EXPECT_NEAR(degreesAt(0.5 * (diamond.left + diamond.right)), 120.0, 0.01);
  EXPECT_TRUE(label(drawing, "2"));
  // the band of the most apical contact from the top to the bottom of the plot
  const Ink band = figures::faded(figures::paletteOf(figures::ColorScheme::dark).ghost, 0.25);
  const auto bands = all<Area>(drawing, band);
  ASSERT_EQ(bands.size(), 1u);
  const Box box = boxOf(bands.front().points);
  EXPECT_NEAR(degreesAt(box.left), 180.0, 0.01);
  EXPECT_NEAR(degreesAt(box.right), 240.0, 0.01);
}

}  // namespace
}  // namespace perilymph::charts
