#pragma once

// The quiet ground of the operation view: dark, a little lighter in the middle.

#include "Mesh.h"
#include "PictureSpace.h"

namespace perilymph::visualization {

/// A plane far behind the scene that fills the picture, colored at its points.
class Backdrop {
public:
  explicit Backdrop(const Palette& palette);

  /// Fills a picture of this size [mm] whose middle lies at `center`.
  void place(const ViewFrame& view, const Eigen::Vector3d& center, double width_mm,
             double height_mm);
  vtkActor& actor() { return mesh_.actor(); }

private:
  Mesh mesh_{Mesh::Coloring::perPoint};
};

}  // namespace perilymph::visualization
