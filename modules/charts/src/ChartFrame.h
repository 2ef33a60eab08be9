// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Common parts of all charts: a renderer and a chart with two titled axes and grid lines.

#include <vtkColor.h>
#include <vtkNew.h>

#include <string>

#include "AxisRange.h"
#include "ChartOverlay.h"
#include "perilymph/charts/ChartStyle.h"

class vtkChartXY;
class vtkContextActor;
class vtkFloatArray;
class vtkPlot;
class vtkRenderer;
class vtkRenderWindow;
class vtkTable;

namespace perilymph::charts {

/// One line of a chart with its table.
class ChartLine {
public:
  ChartLine(vtkChartXY& chart, const vtkColor4ub& color, float width);
  ~ChartLine();
  ChartLine(const ChartLine&) = delete;
  ChartLine& operator=(const ChartLine&) = delete;

  void set(const std::vector<float>& x, const std::vector<float>& y);
  void setVisible(bool visible);
  void setScale(double pixelRatio);

private:
  vtkNew<vtkTable> table_;
  vtkNew<vtkFloatArray> x_, y_;
  vtkPlot* plot_;  // owned by the chart
  float width_;
};

/// Renderer, chart, axes, grid and overlay.
class ChartFrame {
public:
  ChartFrame(const std::string& xTitle, const std::string& yTitle, const ChartStyle& style);
  ~ChartFrame();
  ChartFrame(const ChartFrame&) = delete;
  ChartFrame& operator=(const ChartFrame&) = delete;

  void attachTo(vtkRenderWindow& window);
  void setScale(double pixelRatio);

  void setXRange(const AxisRange& range);
  void setYRange(const AxisRange& range, int decimals);
  /// Replaces the numbers at the x ticks by texts.
  void setXLabels(const AxisRange& range, const std::vector<std::string>& labels);

  vtkChartXY& chart() { return *chart_; }
  ChartOverlay& overlay() { return *overlay_; }

private:
  void styleAxis(int position, const std::string& title);
  void setRange(int position, const AxisRange& range, const std::vector<std::string>& labels);

  const figures::SchemeInks& inks_;
  char decimalSign_;
  vtkNew<vtkRenderer> renderer_;
  vtkNew<vtkContextActor> actor_;
  vtkNew<vtkChartXY> chart_;
  vtkNew<ChartOverlay> overlay_;
};

}  // namespace perilymph::charts
