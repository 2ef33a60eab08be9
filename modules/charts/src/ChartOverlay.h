// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Overlay of a chart: printed values with error bars, thresholds, the current point, and the
// legend.

#include <vtkColor.h>
#include <vtkContextItem.h>

#include <functional>
#include <optional>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "perilymph/charts/ExpectedForce.h"
#include "perilymph/charts/ReferenceCurve.h"
#include "perilymph/charts/ScatterChart.h"
#include "perilymph/figures/Palette.h"

class vtkChartXY;

namespace perilymph::charts {

/// Symbol of a legend entry.
enum class Swatch { line, dashes, dots, level, bar, mark };

/// One line of the legend.
struct LegendEntry {
  Swatch swatch;
  vtkColor4ub color;
  std::string text;
  int shape = 0;  ///< A mark as vtkPlotPoints names it.
};

/// A dashed line across the chart; the legend names it.
struct Threshold {
  double y;
  vtkColor4ub color;
};

/// A dot at a point of the chart.
struct Dot {
  double x, y;
  vtkColor4ub color;
};

/// A line with its band.
struct Trend {
  std::vector<TrendPoint> points;
  vtkColor4ub color;
};

/// Drawn after the chart, in pixels; computes positions from the chart's axes.
class ChartOverlay : public vtkContextItem {
public:
  static ChartOverlay* New();
  vtkTypeMacro(ChartOverlay, vtkContextItem)

      void setChart(vtkChartXY* chart)
  {
    chart_ = chart;
  }
  /// Colors of the overlay; those of the dark scheme by default.
  void setInks(const figures::Palette& inks) { inks_ = &inks; }
  void setScale(double pixelRatio);

  std::vector<LegendEntry> legend;
  std::vector<ReferencePoint> bars;
  std::vector<ExpectedForce> expected;
  std::vector<std::pair<double, std::string>>
      marks;  ///< Places on the x axis, ascending, with labels.
  std::optional<Threshold> threshold;
  std::optional<Dot> now;
  std::vector<Trend> trends;
  std::optional<Dot> ringed;  ///< A point with a ring around it.

  bool Paint(vtkContext2D* painter) override;
  /// Rows of the legend above a plot of this width [px].
  int legendRows(vtkContext2D& painter, float width) const;
  static constexpr float legendRow_px = 15.0f;  ///< At pixel ratio 1.

protected:
  ChartOverlay() = default;
  ~ChartOverlay() override = default;

private:
  struct Area;
  void paintZero(vtkContext2D& painter, const Area& area) const;
  void paintThreshold(vtkContext2D& painter, const Area& area) const;
  void paintExpected(vtkContext2D& painter, const Area& area) const;
  void paintMarks(vtkContext2D& painter, const Area& area) const;
  void paintBars(vtkContext2D& painter, const Area& area) const;
  void paintNow(vtkContext2D& painter, const Area& area) const;
  void paintTrends(vtkContext2D& painter, const Area& area) const;
  void paintRing(vtkContext2D& painter, const Area& area) const;
  void paintLegend(vtkContext2D& painter, const Area& area) const;
  /// Width of a label [px]. It is measured once: shaping text costs more than drawing it.
  float widthOf(vtkContext2D& painter, const std::string& label) const;
  /// The label, with an ellipsis at its end if it is wider than that [px].
  std::string fitted(vtkContext2D& painter, const std::string& label, float width) const;
  /// A text in lines of at most this width; a longer word stands alone.
  std::vector<std::string> wrapped(vtkContext2D& painter, const std::string& label,
                                   float width) const;
  /// Calls `line(entry, text, x, row, isFirst)` for each line of the legend, from the top.
  void placeLegend(vtkContext2D& painter, float width,
                   const std::function<void(const LegendEntry&, const std::string&, float, int,
                                            bool)>& line) const;
  void paintSwatch(vtkContext2D& painter, const LegendEntry& entry, float x, float y) const;
  void setText(vtkContext2D& painter, const vtkColor4ub& color, int justification) const;

  const figures::Palette* inks_ = &figures::paletteOf(figures::ColorScheme::dark);
  vtkChartXY* chart_ = nullptr;  // owned by the frame
  float scale_ = 1.0f;
  mutable std::unordered_map<std::string, float> widths_;
};

}  // namespace perilymph::charts
