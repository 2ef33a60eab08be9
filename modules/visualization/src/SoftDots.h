// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Round dots that face the viewer and fade toward their edge.

#include <Eigen/Core>
#include <vector>

#include "Mesh.h"
#include "PictureSpace.h"

namespace perilymph::visualization {

/// Clear, add dots, then build for the view; repeat when dots or view change.
class SoftDots {
public:
  SoftDots();

  void clear() { dots_.clear(); }
  void add(const Eigen::Vector3d& place, const Rgba& color, double radius_mm);
  /// Builds the dots, offset toward the viewer by `toward_mm`.
  void build(const ViewFrame& view, double toward_mm);

  vtkActor& actor() { return mesh_.actor(); }

private:
  struct Dot {
    Eigen::Vector3d place;
    Rgba color;
    double radius_mm;
  };
  void reserveDots();

  std::vector<Dot> dots_;
  std::size_t capacity_ = 0;  ///< Number of dots that the mesh has points for; unused ones are
                              ///< degenerate.
  Mesh mesh_{Mesh::Coloring::perPoint};
};

}  // namespace perilymph::visualization
