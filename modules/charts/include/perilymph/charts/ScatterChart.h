// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Many insertions as points: one quantity over another, in groups.

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "perilymph/charts/ChartStyle.h"

class vtkChartXY;
class vtkRenderWindow;

namespace perilymph::charts {

/// A line with a band at one place.
struct TrendPoint {
  double x, value, low, high;
};

/// Points of one color and shape.
struct ScatterGroup {
  std::string label;               ///< In the legend; empty: not listed.
  std::vector<float> x, y;         ///< As many of each.
  std::vector<std::uint32_t> ids;  ///< What the caller calls the points; as many.
  std::vector<bool> isCrossed;     ///< Points that are crossed out; as many, or none.
  std::vector<TrendPoint> trend;   ///< From left to right; none if empty.
};

/// A scatter plot. Its ranges contain all points and are extended by whole ticks.
class ScatterChart {
public:
  /// Groups that differ in color and shape; further ones repeat them.
  static constexpr std::size_t distinctGroups = 5;

  explicit ScatterChart(const ChartStyle& style = {});
  ~ScatterChart();
  ScatterChart(const ScatterChart&) = delete;
  ScatterChart& operator=(const ScatterChart&) = delete;

  /// Adds the chart's renderer to a window and disables multisampling. Needs no interactor.
  void attachTo(vtkRenderWindow& window);
  /// Scales fonts and marks for a screen's pixel ratio; 1 by default.
  void setScale(double pixelRatio);

  /// Titles with units.
  void setTitles(const std::string& x, const std::string& y);
  /// Ranges of all points that may be shown, so that a filter does not move the axes. Equal limits
  /// are widened.
  void setRanges(double lowX, double highX, double lowY, double highY);
  /// Name of points that are crossed out, in the legend.
  void setCrossedLabel(const std::string& label);
  /// Replaces all points. Those that are not finite are left out.
  void setGroups(std::vector<ScatterGroup> groups);
  /// Rings a point; none if it has no such id.
  void setSelected(std::optional<std::uint32_t> id);

  /// The nearest point within `reach` of a place in the render window [px from its lower left
  /// corner]; the chart must have been rendered.
  std::optional<std::uint32_t> pick(double x, double y, double reach) const;

  /// Updates the drawing after changes.
  ///
  /// @return Whether it changed, so that the window needs a Render().
  bool update();

  /// The chart itself, for tests and pictures.
  vtkChartXY& chart();

private:
  struct Content;
  std::unique_ptr<Content> content_;
};

}  // namespace perilymph::charts
