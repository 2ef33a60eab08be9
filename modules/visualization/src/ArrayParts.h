// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Visual model of the array: a tapered silicone tube with platinum half-bands, marker ribs and a
// stylet.

#include <memory>
#include <vector>

#include "ArrayPath.h"
#include "Mesh.h"
#include "SoftLines.h"
#include "Tweezers.h"
#include "perilymph/electrode/ArrayDesign.h"

class vtkRenderer;

namespace perilymph::visualization {

/// The parts that move with the array. Meshes are created once; show() moves their points.
class ArrayParts {
public:
  ArrayParts(const electrode::ArrayDesign& array, const SceneColors& palette);

  /// Adds the solid parts, in drawing order.
  void addSolid(vtkRenderer& renderer);
  /// Adds the shadow below and the outline over the array.
  void addShadow(vtkRenderer& renderer);
  void addOutline(vtkRenderer& renderer);

  void show(const ArrayPath& path, double styletWithdrawal_mm);
  /// Updates shadow and outline, which depend on the view.
  void lookFrom(const ViewFrame& view);
  void setVisible(bool array, bool styletAndTweezers);

  /// Radius of the silicone; rounded at the tip.
  double radius_mm(double fromTip_mm) const;
  const electrode::ArrayDesign& design() const { return array_; }

private:
  struct Ring {
    double fromTip_mm;
    double radius_mm;
    double lean;  ///< Component of the normal toward the tip.
  };
  void planTube();
  void planContacts();
  void planRibs();
  void planStylet();
  void writeRings(Mesh& mesh, const std::vector<Ring>& rings, const ArrayPath& path);
  void showContacts(const ArrayPath& path);

  electrode::ArrayDesign array_;
  const SceneColors& palette_;
  double tipRadius_mm_ = 0.0;
  std::vector<Ring> tubeRings_, ribRings_, styletRings_;
  Mesh tube_{Mesh::Coloring::uniform};
  Mesh contacts_{Mesh::Coloring::perPoint};
  Mesh ribs_{Mesh::Coloring::uniform};
  Mesh stylet_{Mesh::Coloring::uniform};
  Tweezers tweezers_;
  SoftLines shadow_, outline_;
  std::vector<PathPoint> outlinePath_;
  std::vector<double> outlineRadius_mm_;
};

}  // namespace perilymph::visualization
