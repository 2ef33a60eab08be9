// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Common parts of all charts: a renderer and a chart with two titled axes and grid lines.

#include <vtkColor.h>
#include <vtkNew.h>

#include <array>
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

  /// @param phase  Added to x for the positions of dashes, so that they move with a moving curve.
  void set(const std::vector<float>& x, const std::vector<float>& y, double phase = 0.0);
  /// Draws the line in dashes, so that it differs from others without its color.
  /// @param on, off  Lengths of dashes and gaps along x.
  void setDash(double on, double off);
  void setVisible(bool visible);
  void setScale(double pixelRatio);

private:
  template <class Add>
  void addDashes(const std::array<double, 2>& from, const std::array<double, 2>& to, double phase,
                 Add add) const;

  vtkNew<vtkTable> table_;
  vtkNew<vtkFloatArray> x_, y_;
  vtkPlot* plot_;  // owned by the chart
  float width_;
  double dashOn_ = 0.0, dashOff_ = 0.0;  ///< 0: solid.
};

/// Painted before the chart: reserves the space that the legend above it needs at the current width.
class LegendSpace : public vtkContextItem {
public:
  static LegendSpace* New();
  vtkTypeMacro(LegendSpace, vtkContextItem)

      bool Paint(vtkContext2D* painter) override;

  vtkChartXY* chart = nullptr;      // owned by the frame
  ChartOverlay* overlay = nullptr;  // owned by the frame
  double pixelRatio = 1.0;

protected:
  LegendSpace() = default;
  ~LegendSpace() override = default;
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

  void setTitles(const std::string& x, const std::string& y);
  void setXRange(const AxisRange& range, int decimals = 0);
  void setYRange(const AxisRange& range, int decimals);
  /// Replaces the numbers at the x ticks by texts.
  void setXLabels(const AxisRange& range, const std::vector<std::string>& labels);

  vtkChartXY& chart() { return *chart_; }
  ChartOverlay& overlay() { return *overlay_; }

private:
  void styleAxis(int position, const std::string& title);
  void setRange(int position, const AxisRange& range, const std::vector<std::string>& labels);

  const figures::Palette& inks_;
  char decimalSign_;
  vtkNew<vtkRenderer> renderer_;
  vtkNew<vtkContextActor> actor_;
  vtkNew<vtkChartXY> chart_;
  vtkNew<ChartOverlay> overlay_;
  vtkNew<LegendSpace> legendSpace_;
};

}  // namespace perilymph::charts
