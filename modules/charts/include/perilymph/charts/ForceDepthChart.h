#pragma once

// Axial force over travel: this insertion, another one as its ghost, and the published experiment.

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "perilymph/charts/ChartStyle.h"
#include "perilymph/charts/ReferenceCurve.h"
#include "perilymph/foundation/Units.h"

class vtkChartXY;
class vtkRenderWindow;

namespace perilymph::charts {

/// What of the chart can be switched off.
enum class ChartLayer { ghost, reference, threshold };

/// A chart of axial force [N] over travel [mm]. Its ranges stand still (0 to 17 mm,
/// -0.01 to 0.20 N) and grow in steps when a curve leaves them, also downward: a withdrawn array
/// pulls.
class ForceDepthChart {
public:
  explicit ForceDepthChart(const ChartStyle& style = {});
  ~ForceDepthChart();
  ForceDepthChart(const ForceDepthChart&) = delete;
  ForceDepthChart& operator=(const ForceDepthChart&) = delete;

  /// Adds the chart's renderer to a window and turns its multisampling off, which would cost ten
  /// times the chart. Needs no interactor.
  void attachTo(vtkRenderWindow& window);

  /// Adds one value of this insertion. Its cost does not grow with the length of the curve: of each
  /// column of pixels the least and the greatest force are kept. Not finite values are left out.
  void append(Length travel, Force axial);
  /// Forgets this insertion; ghost and reference stay.
  void clear();

  /// Another run to compare with; an empty curve removes it.
  void setGhost(const std::vector<std::pair<Length, Force>>& curve, std::string label);
  /// Printed values, drawn as points with one standard deviation up and down; no points remove
  /// them.
  void setReference(std::vector<ReferencePoint> points, std::string label);
  void setVisible(ChartLayer layer, bool visible);

  /// Sizes of type and lines for a screen's pixel ratio; 1 by default.
  void setScale(double pixelRatio);

  /// Brings what was appended and set into the picture.
  /// @return Whether the picture changed, so that the window needs a Render().
  bool update();

  /// The chart itself, for tests and for pictures.
  vtkChartXY& chart();

private:
  struct Content;
  std::unique_ptr<Content> content_;
};

}  // namespace perilymph::charts
