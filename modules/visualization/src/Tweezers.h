// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The tweezers that hold the array at its base.

#include <array>

#include "ArrayPath.h"
#include "Mesh.h"

namespace perilymph::visualization {

/// Two slender steel jaws that close on the array and open backward.
class Tweezers {
public:
  /// @param heldAt_mm  Place on the array, from the tip, where the jaws close.
  Tweezers(double heldAt_mm, const SceneColors& palette);

  void show(const ArrayPath& path);
  std::array<vtkActor*, 2> actors() { return {&jaws_[0].actor(), &jaws_[1].actor()}; }

private:
  double heldAt_mm_;
  std::array<Mesh, 2> jaws_{Mesh{Mesh::Coloring::uniform}, Mesh{Mesh::Coloring::uniform}};
};

}  // namespace perilymph::visualization
