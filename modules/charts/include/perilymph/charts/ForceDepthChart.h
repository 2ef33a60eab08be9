// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Axial force over travel: the current insertion, a previous one, a plan, and the published
// experiment.

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "perilymph/charts/ChartStyle.h"
#include "perilymph/charts/ExpectedForce.h"
#include "perilymph/charts/ReferenceCurve.h"
#include "perilymph/foundation/Units.h"

class vtkChartXY;
class vtkRenderWindow;

namespace perilymph::charts {

/// Optional parts of the chart.
enum class ChartLayer { ghost, reference, threshold };

/// A chart of axial force [mN] over travel [mm]. Its ranges are fixed (0 to 17 mm, -10 to 200 mN)
/// and extended in steps if a curve exceeds them, also downward: a withdrawn array pulls.
class ForceDepthChart {
public:
  explicit ForceDepthChart(const ChartStyle& style = {});
  ~ForceDepthChart();
  ForceDepthChart(const ForceDepthChart&) = delete;
  ForceDepthChart& operator=(const ForceDepthChart&) = delete;

  /// Adds the chart's renderer to a window and disables multisampling, which would cost ten times
  /// as much as the chart. Needs no interactor.
  void attachTo(vtkRenderWindow& window);

  /// Adds one value of the current insertion. The cost is independent of the curve's length: for
  /// each pixel column the minimum and maximum force are kept. Non-finite values are ignored.
  void append(Length travel, Force axial);
  /// Removes the current insertion; ghost and reference remain.
  void clear();

  /// Sets another insertion for comparison; an empty curve removes it.
  void setGhost(const std::vector<std::pair<Length, Force>>& curve, std::string label);
  /// Printed values, drawn as points with error bars of one standard deviation; an empty list
  /// removes them.
  void setReference(std::vector<ReferencePoint> points, std::string label);
  /// Force expected by a plan, in order of travel: an area with a dotted median; an empty list
  /// removes it.
  void setExpected(std::vector<ExpectedForce> points, std::string label);
  /// Travels [mm] at which something reaches the opening, with a short label each ("rib 1"), in ascending order:
  /// dotted lines. They do not extend the range.
  void setTravelMarks(std::vector<std::pair<double, std::string>> marks);
  void setVisible(ChartLayer layer, bool visible);

  /// Scales fonts and lines for a screen's pixel ratio; 1 by default.
  void setScale(double pixelRatio);

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
