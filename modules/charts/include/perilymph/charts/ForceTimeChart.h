// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The force components at the hand over the last seconds.

#include <memory>

#include "perilymph/charts/ChartStyle.h"
#include "perilymph/foundation/Units.h"

class vtkChartXY;
class vtkRenderWindow;

namespace perilymph::charts {

/// The force at the hand in the entry's frame E.
struct ForceComponents {
  Force axial;     ///< Along E.z, against the insertion.
  Force lateral;   ///< Along E.x, toward the outer wall.
  Force vertical;  ///< Along E.y.
};

/// A chart of the force components [mN] over the last 5 s. The range adapts in steps to the visible
/// values.
class ForceTimeChart {
public:
  static constexpr Duration span = seconds(5);

  explicit ForceTimeChart(const ChartStyle& style = {});
  ~ForceTimeChart();
  ForceTimeChart(const ForceTimeChart&) = delete;
  ForceTimeChart& operator=(const ForceTimeChart&) = delete;

  /// Adds the chart's renderer to a window and disables multisampling.
  void attachTo(vtkRenderWindow& window);

  /// Adds one value. A time earlier than the last one clears the chart. Non-finite values are
  /// ignored.
  void append(Duration time, const ForceComponents& force);
  void clear();

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
