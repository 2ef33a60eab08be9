// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/charts/ForceTimeChart.h"

#include <gtest/gtest.h>
#include <vtkAxis.h>
#include <vtkChartXY.h>
#include <vtkPlot.h>
#include <vtkTable.h>

#include "perilymph/test/TestPicture.h"

namespace perilymph::charts {
namespace {

ForceComponents axialOnly(double axial_mN) { return {millinewtons(axial_mN), Force(), Force()}; }

vtkTable& axialTable(ForceTimeChart& chart) { return *chart.chart().GetPlot(0)->GetInput(); }

TEST(ForceTimeChart, ShowsTheLastFiveSecondsOnly)
{
  ForceTimeChart chart;
  for (int i = 0; i < 20000; ++i) chart.append(milliseconds(i), axialOnly(10));
  chart.update();
  vtkTable& table = axialTable(chart);
  EXPECT_GE(table.GetValue(0, 0).ToDouble(), -5.02);
  EXPECT_LE(table.GetValue(0, 0).ToDouble(), -4.9);
  EXPECT_NEAR(table.GetValue(table.GetNumberOfRows() - 1, 0).ToDouble(), 0.0, 0.02);
}

TEST(ForceTimeChart, KeepsASpikeOfOneTick)
{
  ForceTimeChart chart;
  for (int i = 0; i < 3000; ++i) chart.append(milliseconds(i), axialOnly(i == 2000 ? 55 : 10));
  chart.update();
  double highest = 0.0;
  for (vtkIdType row = 0; row < axialTable(chart).GetNumberOfRows(); ++row)
    highest = std::max(highest, axialTable(chart).GetValue(row, 1).ToDouble());
  EXPECT_NEAR(highest, 55.0, 1e-4);
}

TEST(ForceTimeChart, RestartsWhenTimeRunsBackward)
{
  ForceTimeChart chart;
  for (int i = 0; i < 3000; ++i) chart.append(milliseconds(i), axialOnly(10));
  chart.append(milliseconds(0), axialOnly(20));
  chart.append(milliseconds(50), axialOnly(20));
  chart.update();
  EXPECT_LE(axialTable(chart).GetNumberOfRows(), 4);
}

TEST(ForceTimeChart, GrowsWithTheForceAndShrinksWhenItIsGone)
{
  ForceTimeChart chart;
  chart.append(milliseconds(0), axialOnly(150));
  chart.append(milliseconds(20), axialOnly(150));
  chart.update();
  vtkAxis& axis = *chart.chart().GetAxis(vtkAxis::LEFT);
  EXPECT_GE(axis.GetMaximum(), 150.0);
  for (int i = 100; i < 9000; ++i) chart.append(milliseconds(i), axialOnly(10));
  chart.update();
  EXPECT_DOUBLE_EQ(axis.GetMaximum(), 60.0);
}

/// A chart with the size of a pane in the window.
test::DrawnPicture drawn(ForceTimeChart& chart, int pixelRatio = 1)
{
  vtkNew<vtkRenderWindow> window;
  window->SetOffScreenRendering(true);
  window->SetSize(400 * pixelRatio, 170 * pixelRatio);
  chart.attachTo(*window);
  return test::draw(*window);
}

TEST(ForceTimeChart, HasItsNumbersBeforeTheFirstForce)
{
  ForceTimeChart chart;
  const test::DrawnPicture picture = drawn(chart);
  const int left = static_cast<int>(chart.chart().GetAxis(vtkAxis::LEFT)->GetPoint2()[0]);
  const auto isText = [](const test::Pixel& p) { return p[0] > 0x60 && p[1] > 0x60; };
  EXPECT_GT(test::countPixels(picture, [&](const test::Pixel& p, int x,
                                           int) { return x < left - 20 && isText(p); }),
            20);
}

TEST(ForceTimeChart, ItsLegendLiesAboveThePlotNotOnTheCurves)
{
  ForceTimeChart chart;
  const test::DrawnPicture picture = drawn(chart);
  const int top = static_cast<int>(chart.chart().GetAxis(vtkAxis::LEFT)->GetPoint2()[1]);
  const int bottom = static_cast<int>(chart.chart().GetAxis(vtkAxis::LEFT)->GetPoint1()[1]);
  const int left = static_cast<int>(chart.chart().GetAxis(vtkAxis::LEFT)->GetPoint2()[0]);
  const auto isBright = [&](const test::Pixel& p) { return p[0] > 0xA0 || p[1] > 0xA0; };
  EXPECT_EQ(test::countPixels(picture,
                              [&](const test::Pixel& p, int x, int y) {
                                return x > left && y > bottom && y < top && isBright(p);
                              }),
            0);
  EXPECT_GT(test::countPixels(picture, [&](const test::Pixel& p, int x,
                                           int y) { return x > left && y > top && isBright(p); }),
            100);
}

TEST(ForceTimeChart, ItsLegendIsWholeOnAScreenOfTwiceThePixels)
{
  ForceTimeChart chart;
  chart.setScale(2.0);
  const test::DrawnPicture picture = drawn(chart, 2);
  const auto isBright = [&](const test::Pixel& p) { return p[0] > 0xA0 || p[1] > 0xA0; };
  const int top = static_cast<int>(chart.chart().GetAxis(vtkAxis::LEFT)->GetPoint2()[1]);
  EXPECT_GT(test::countPixels(
                picture, [&](const test::Pixel& p, int, int y) { return y > top && isBright(p); }),
            400);
  EXPECT_EQ(
      test::countPixels(picture, [&](const test::Pixel& p, int,
                                     int y) { return y >= picture.height - 1 && isBright(p); }),
      0);
}

}  // namespace
}  // namespace perilymph::charts
