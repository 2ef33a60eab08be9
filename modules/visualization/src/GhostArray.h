// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Visual model of the array of another insertion, for comparison.

#include <Eigen/Core>
#include <span>
#include <vector>

#include "ArrayPath.h"
#include "SceneColors.h"
#include "SoftLines.h"
#include "perilymph/electrode/ArrayDesign.h"

class vtkRenderer;

namespace perilymph::visualization {

/// A translucent band with a dashed outline and a line across at each contact: different from the
/// inserted array without color, too.
class GhostArray {
public:
  explicit GhostArray(const SceneColors& palette);

  /// Adds it behind everything that is drawn already.
  void addTo(vtkRenderer& renderer);
  /// Places it; hidden with fewer than 2 nodes or with a non-finite one.
  void show(const electrode::ArrayDesign& array, std::span<const Eigen::Vector3d> nodes_W,
            const PictureSpace& space);
  /// Updates the lines, which depend on the view.
  void lookFrom(const ViewFrame& view);

private:
  /// A point of the center line.
  struct Point {
    PathPoint at;
    double radius_mm;
    bool isDash;  ///< In a dash of the outline.
  };
  void addOutline(const ViewFrame& view, double side);

  const SceneColors& palette_;
  std::vector<Point> line_, contacts_;
  SoftLines band_, outline_;
};

}  // namespace perilymph::visualization
