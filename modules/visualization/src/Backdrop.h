// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The background of the 3D view: dark, slightly brighter in the center.

#include "Mesh.h"
#include "PictureSpace.h"

namespace perilymph::visualization {

/// A plane far behind the scene that fills the picture, with vertex colors.
class Backdrop {
public:
  explicit Backdrop(const SceneColors& palette);

  /// Fills a picture of this size [mm] whose center is at `center`.
  void place(const ViewFrame& view, const Eigen::Vector3d& center, double width_mm,
             double height_mm);
  vtkActor& actor() { return mesh_.actor(); }

private:
  Mesh mesh_{Mesh::Coloring::perPoint};
};

}  // namespace perilymph::visualization
