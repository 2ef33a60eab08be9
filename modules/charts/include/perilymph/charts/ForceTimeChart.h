#pragma once

// The three components of the force at the hand over the last seconds.

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

/// A chart of the force components [mN] over the last 5 s. The range grows and shrinks in steps
/// with what is in view.
class ForceTimeChart {
public:
  static constexpr Duration span = seconds(5);

  explicit ForceTimeChart(const ChartStyle& style = {});
  ~ForceTimeChart();
  ForceTimeChart(const ForceTimeChart&) = delete;
  ForceTimeChart& operator=(const ForceTimeChart&) = delete;

  /// Adds the chart's renderer to a window and turns its multisampling off.
  void attachTo(vtkRenderWindow& window);

  /// Adds one value. Time may not run backward: an earlier time than the last starts the chart
  /// anew. Not finite values are left out.
  void append(Duration time, const ForceComponents& force);
  void clear();

  /// Sizes of type and lines for a screen's pixel ratio; 1 by default.
  void setScale(double pixelRatio);

  /// Brings what was appended into the picture.
  /// @return Whether the picture changed, so that the window needs a Render().
  bool update();

  /// The chart itself, for tests and for pictures.
  vtkChartXY& chart();

private:
  struct Content;
  std::unique_ptr<Content> content_;
};

}  // namespace perilymph::charts
