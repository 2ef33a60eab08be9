// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/charts/ForceDepthChart.h"

#include <gtest/gtest.h>

#include <vtkAxis.h>
#include <vtkChartXY.h>
#include <vtkPlot.h>
#include <vtkTable.h>
#include <vtkVersionMacros.h>
#include <algorithm>

#include <cmath>
#include <limits>

#include "perilymph/test/TestPicture.h"

namespace perilymph::charts {
namespace {

constexpr test::Pixel accent{0x45, 0xC4, 0xB0};
constexpr test::Pixel blue{0x56, 0xB4, 0xE9};

/// A chart and its render window.
struct ChartOnScreen {
  ChartOnScreen()
  {
    window->SetOffScreenRendering(true);
    window->SetSize(415, 360);
    chart.attachTo(*window);
  }

  test::DrawnPicture picture()
  {
    chart.update();
    return test::draw(*window);
  }

  vtkAxis& axis(int position) { return *chart.chart().GetAxis(position); }
  /// The pixel of a value, from the drawn axes.
  int x(double travel_mm)
  {
    vtkAxis& a = axis(vtkAxis::BOTTOM);
    return pixel(travel_mm, a, a.GetPoint1()[0], a.GetPoint2()[0]);
  }
  int y(double force_N)
  {
    vtkAxis& a = axis(vtkAxis::LEFT);
    return pixel(1e3 * force_N, a, a.GetPoint1()[1], a.GetPoint2()[1]);
  }
  static int pixel(double value, vtkAxis& a, float from, float to)
  {
    return static_cast<int>(std::lround(
        from + (value - a.GetMinimum()) / (a.GetMaximum() - a.GetMinimum()) * (to - from)));
  }
  vtkIdType points()
  {
    vtkIdType sum = 0;
    for (vtkIdType i = 0; i < chart.chart().GetNumberOfPlots(); ++i)
      sum += chart.chart().GetPlot(i)->GetInput()->GetNumberOfRows();
    return sum;
  }

  ForceDepthChart chart;
  vtkNew<vtkRenderWindow> window;
};

bool nearColor(const test::DrawnPicture& picture, int x, int y, const test::Pixel& color)
{
  for (int dx = -2; dx <= 2; ++dx)
    for (int dy = -2; dy <= 2; ++dy)
      if (test::difference(picture.at(x + dx, y + dy), color) < 40) return true;
  return false;
}

TEST(ForceDepthChart, ShowsSeventeenMillimetersAndFiftyMillinewtonsWhenEmpty)
{
  ChartOnScreen screen;
  screen.picture();
  EXPECT_DOUBLE_EQ(screen.axis(vtkAxis::BOTTOM).GetMinimum(), 0.0);
  EXPECT_DOUBLE_EQ(screen.axis(vtkAxis::BOTTOM).GetMaximum(), 17.0);
  EXPECT_DOUBLE_EQ(screen.axis(vtkAxis::LEFT).GetMinimum(), -5.0);
  EXPECT_DOUBLE_EQ(screen.axis(vtkAxis::LEFT).GetMaximum(), 50.0);
}

TEST(ForceDepthChart, HasNoGapWhereAFreeArrayPullsALittle)
{
  ChartOnScreen screen;
  for (int i = 0; i <= 1600; ++i)
    screen.chart.append(millimeters(0.01 * i), millinewtons(i > 300 && i < 900 ? -0.4 : 0.0));
  const test::DrawnPicture picture = screen.picture();
  for (const double travel_mm : {2.0, 4.0, 6.0, 8.0, 10.0})
    EXPECT_TRUE(nearColor(picture, screen.x(travel_mm), screen.y(0.0), accent)) << travel_mm;
}

TEST(ForceDepthChart, KeepsItsRangesWhileTheCurveFits)
{
  ChartOnScreen screen;
  for (int i = 0; i <= 1650; ++i) screen.chart.append(millimeters(0.01 * i), newtons(1e-4 * i));
  screen.picture();
  EXPECT_DOUBLE_EQ(screen.axis(vtkAxis::BOTTOM).GetMaximum(), 17.0);
  EXPECT_DOUBLE_EQ(screen.axis(vtkAxis::LEFT).GetMaximum(), 200.0);
}

TEST(ForceDepthChart, FitsASmallForceAndOnlyGrowsByAFewSteps)
{
  ChartOnScreen screen;
  std::vector<double> tops;
  for (int i = 0; i <= 1500; ++i) {
    // 10 mN for two thirds of the way, then up to 180 mN and down again
    const double force_mN = i < 1000 ? 0.01 * i : i < 1250 ? 10.0 + 0.68 * (i - 1000) : 20.0;
    screen.chart.append(millimeters(0.01 * i), millinewtons(force_mN));
    if (i % 50 != 0) continue;
    screen.chart.update();
    const double top = screen.axis(vtkAxis::LEFT).GetMaximum();
    if (i < 1000) {
      EXPECT_LE(top, 5.0 * 10.0) << i;  // a fifth of the chart or more
    }
    if (tops.empty() || top != tops.back()) tops.push_back(top);
  }
  EXPECT_LE(tops.size(), 3u);
  EXPECT_TRUE(std::is_sorted(tops.begin(), tops.end()));  // it never shrinks
}

TEST(ForceDepthChart, GrowsByWholeTicksWhenForceOrTravelLeavesIt)
{
  ChartOnScreen screen;
  screen.chart.append(millimeters(0), newtons(0));
  screen.chart.append(millimeters(21), newtons(0.23));
  screen.picture();
  EXPECT_DOUBLE_EQ(screen.axis(vtkAxis::LEFT).GetMaximum(), 250.0);
  EXPECT_DOUBLE_EQ(screen.axis(vtkAxis::BOTTOM).GetMaximum(), 24.0);
}

TEST(ForceDepthChart, ShowsThePullOfAWithdrawnArrayBelowZero)
{
  ChartOnScreen screen;
  for (int i = 0; i < 500; ++i) screen.chart.append(millimeters(0.02 * i), newtons(0.05));
  for (int i = 500; i > 0; --i) screen.chart.append(millimeters(0.02 * i), newtons(-0.03));
  const test::DrawnPicture picture = screen.picture();
  EXPECT_DOUBLE_EQ(screen.axis(vtkAxis::LEFT).GetMinimum(), -40.0);
  // half-transparent over the ground
  const test::Pixel faded{0x30, 0x7D, 0x72};
  EXPECT_TRUE(nearColor(picture, screen.x(5.0), screen.y(-0.03), faded));
}

TEST(ForceDepthChart, DrawsTheCurveWhereItsValuesAre)
{
  ChartOnScreen screen;
  for (int i = 0; i <= 1500; ++i) screen.chart.append(millimeters(0.01 * i), newtons(0.1));
  const test::DrawnPicture picture = screen.picture();
  for (const double travel_mm : {1.0, 5.0, 9.0, 14.0})
    EXPECT_TRUE(nearColor(picture, screen.x(travel_mm), screen.y(0.1), accent)) << travel_mm;
  EXPECT_FALSE(nearColor(picture, screen.x(16.0), screen.y(0.1), accent));
}

TEST(ForceDepthChart, KeepsASpikeOfOneSample)
{
  ChartOnScreen screen;
  for (int i = 0; i <= 15000; ++i)
    screen.chart.append(millimeters(0.001 * i), newtons(i == 7003 ? 0.18 : 0.02));
  const test::DrawnPicture picture = screen.picture();
  EXPECT_TRUE(nearColor(picture, screen.x(7.003), screen.y(0.15), accent));
}

TEST(ForceDepthChart, DoesNotGrowSlowerWithTimeSpentAtOnePlace)
{
  ChartOnScreen screen;
  for (int i = 0; i < 1600; ++i) screen.chart.append(millimeters(0.01 * i), newtons(0.05));
  screen.picture();
  const vtkIdType before = screen.points();
  // three minutes of tremor
  for (int i = 0; i < 180000; ++i)
    screen.chart.append(millimeters(15.9 + 0.3 * std::sin(0.05 * i)),
                        newtons(0.05 + 1e-4 * (i % 7)));
  screen.picture();
  EXPECT_LT(screen.points(), before + 200);
}

TEST(ForceDepthChart, DrawsNoMoreAfterAnHourOfTicksThanAfterTheFirstInsertion)
{
  ChartOnScreen screen;
  const auto insertAndWithdraw = [&] {
    constexpr int ticks = 8000;
    for (int i = 0; i < 2 * ticks; ++i) {
      const double travel_mm = 16.0 * (i < ticks ? i : 2 * ticks - i) / ticks;
      screen.chart.append(millimeters(travel_mm), newtons(0.006 * travel_mm + 1e-3 * (i % 3)));
    }
  };
  insertAndWithdraw();
  screen.picture();
  const vtkIdType before = screen.points();
  for (int i = 1; i < 225; ++i) insertAndWithdraw();  // 3.6 million ticks
  screen.picture();
  EXPECT_LE(screen.points(), before + 4);  // where the direction changes
}

TEST(ForceDepthChart, SkipsNonFiniteValues)
{
  ChartOnScreen screen;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  screen.chart.append(millimeters(1), newtons(nan));
  screen.chart.append(millimeters(nan), newtons(0.1));
  screen.chart.append(millimeters(1e9), newtons(0.1));
  screen.picture();
  EXPECT_EQ(screen.points(), 0);
}

TEST(ForceDepthChart, SaysWhetherThePictureChanged)
{
  ChartOnScreen screen;
  screen.chart.update();
  EXPECT_FALSE(screen.chart.update());
  screen.chart.append(millimeters(1), newtons(0.01));
  EXPECT_TRUE(screen.chart.update());
  EXPECT_FALSE(screen.chart.update());
}

TEST(ForceDepthChart, ClearsTheInsertionButNotTheGhost)
{
  ChartOnScreen screen;
  std::vector<std::pair<Length, Force>> ghost;
  for (int i = 0; i <= 100; ++i) ghost.push_back({millimeters(0.1 * i), newtons(0.06)});
  screen.chart.setGhost(ghost, "ghost");
  screen.chart.append(millimeters(0), newtons(0.1));
  screen.chart.append(millimeters(8), newtons(0.1));
  screen.chart.clear();
  const test::DrawnPicture picture = screen.picture();
  const auto isBlue = [&](const test::Pixel& p, int, int) {
    return test::difference(p, blue) < 40;
  };
  EXPECT_GT(test::countPixels(picture, isBlue), 40);
  EXPECT_FALSE(nearColor(picture, screen.x(5.0), screen.y(0.1), accent));
}

TEST(ForceDepthChart, DrawsTheGhostInDashesSoThatItDiffersWithoutColor)
{
  ChartOnScreen screen;
  screen.chart.setVisible(ChartLayer::threshold, false);
  std::vector<std::pair<Length, Force>> ghost;
  for (int i = 0; i <= 160; ++i) {
    ghost.push_back({millimeters(0.1 * i), newtons(0.06)});
    screen.chart.append(millimeters(0.1 * i), newtons(0.12));
  }
  screen.chart.setGhost(ghost, "ghost");
  const test::DrawnPicture picture = screen.picture();
  const auto changesAlong = [&](double force_N, const test::Pixel& color) {
    int changes = 0;
    bool wasOn = false;
    for (int x = screen.x(1.0); x < screen.x(15.0); ++x) {
      bool isOn = false;
      for (int dy = -2; dy <= 2; ++dy)
        isOn = isOn || test::difference(picture.at(x, screen.y(force_N) + dy), color) < 60;
      changes += isOn != wasOn ? 1 : 0;
      wasOn = isOn;
    }
    return changes;
  };
  EXPECT_LE(changesAlong(0.12, accent), 2);
  EXPECT_GT(changesAlong(0.06, blue), 20);
}

TEST(ForceDepthChart, DrawsThePrintedValuesAndNothingBetweenThem)
{
  ChartOnScreen screen;
  screen.chart.setVisible(ChartLayer::threshold, false);
  screen.chart.setReference({{4.0, 50.0, 20.0}, {12.0, 90.0, 20.0}}, "experiment");
  const test::DrawnPicture picture = screen.picture();
  const test::Pixel bar{0xBA, 0xBE, 0xC1};  // the text color, a little transparent
  // the ends of the error bars, one standard deviation up and down, and nothing beyond
  for (const double force_N : {0.07, 0.03}) {
    EXPECT_TRUE(nearColor(picture, screen.x(4.0), screen.y(force_N), bar)) << force_N;
    const double beyond_N = force_N > 0.05 ? force_N + 0.004 : force_N - 0.004;
    EXPECT_FALSE(nearColor(picture, screen.x(4.0), screen.y(beyond_N), bar)) << beyond_N;
  }
  const int between = test::countPixels(picture, [&](const test::Pixel& p, int x, int y) {
    return x > screen.x(4.0) + 8 && x < screen.x(12.0) - 8 && y > screen.y(0.02) &&
           y < screen.y(0.12) && p[0] > 0x60;
  });
  EXPECT_EQ(between, 0);
}

TEST(ForceDepthChart, MarksRibsAtTheirTravelsWithLabelsThatDoNotOverlap)
{
  ChartOnScreen screen;
  const test::DrawnPicture empty = screen.picture();
  const test::Pixel line{0x55, 0x61, 0x6B};
  const auto pixelsOfLabels = [&](const std::vector<std::pair<double, std::string>>& marks) {
    screen.chart.setTravelMarks(marks);
    const test::DrawnPicture drawn = screen.picture();
    for (const auto& [place, label] : marks) {
      int dots = 0;
      for (int y = screen.y(0.005); y < screen.y(0.045); ++y)
        for (int dx = -1; dx <= 1; ++dx)
          dots += test::difference(drawn.at(screen.x(place) + dx, y), line) < 12 ? 1 : 0;
      EXPECT_GT(dots, 20) << label;
    }
    return test::countPixels(drawn, [&](const test::Pixel& p, int x, int y) {
      return p[0] > 0x80 && test::difference(p, empty.at(x, y)) > 40;
    });
  };
  // two labels at one place have as much ink as two apart, because neither is drawn over the other
  const int apart = pixelsOfLabels({{3.0, "rib 1"}, {9.0, "rib 1"}});
  const int together = pixelsOfLabels({{9.0, "rib 1"}, {9.6, "rib 1"}});
  EXPECT_GT(apart, 40);
  EXPECT_NEAR(together, apart, 0.1 * apart);
  EXPECT_EQ(pixelsOfLabels({}), 0);
  EXPECT_DOUBLE_EQ(screen.axis(vtkAxis::BOTTOM).GetMaximum(), 17.0);
}

TEST(ForceDepthChart, LooksAsAccepted)
{
  ChartOnScreen screen;
  screen.chart.setReference(
      {{10.6, 88.0, 18.6}, {11.8, 80.7, 21.9}, {15.4, 150.9, 18.9}, {16.5, 125.4, 38.5}},
      "published measurements, mean ± SD");
  std::vector<std::pair<Length, Force>> ghost;
  for (int i = 0; i <= 160; ++i) ghost.push_back({millimeters(0.1 * i), newtons(5.5e-4 * i)});
  screen.chart.setGhost(ghost, "ghost: best run");
  for (int i = 0; i <= 1120; ++i) screen.chart.append(millimeters(0.01 * i), newtons(7e-8 * i * i));
  constexpr bool isNewer =
      VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 2, 0);  // fills another ground
  const char* accepted = isNewer ? "force-depth-chart-vtk-9.3" : "force-depth-chart";
  EXPECT_EQ(test::comparedWithAccepted(screen.picture(), accepted), "");
}

TEST(ForceDepthChart, ShowsThePlansMedianInItsBandAndOmitsItWhenItIsRemoved)
{
  ChartOnScreen screen;
  const test::DrawnPicture empty = screen.picture();
  screen.chart.setExpected({{2.0, 10.0, 15.0, 30.0}, {12.0, 10.0, 15.0, 30.0}}, "plan");
  const test::DrawnPicture drawn = screen.picture();
  for (const double travel_mm : {3.0, 7.0, 11.0}) {
    const int x = screen.x(travel_mm);
    EXPECT_TRUE(nearColor(drawn, x, screen.y(0.015), blue)) << travel_mm;
    EXPECT_GT(test::difference(drawn.at(x, screen.y(0.026)), empty.at(x, screen.y(0.026))), 10);
    EXPECT_EQ(test::difference(drawn.at(x, screen.y(0.034)), empty.at(x, screen.y(0.034))), 0);
  }
  screen.chart.setExpected({{2.0, 40.0, 60.0, 320.0}}, "plan");
  screen.picture();
  EXPECT_GE(screen.axis(vtkAxis::LEFT).GetMaximum(), 320.0);
  screen.chart.setExpected({}, {});
  const test::DrawnPicture removed = screen.picture();
  const int x = screen.x(7.0), y = screen.y(0.015);
  EXPECT_EQ(test::difference(removed.at(x, y), empty.at(x, y)), 0);
}

}  // namespace
}  // namespace perilymph::charts
