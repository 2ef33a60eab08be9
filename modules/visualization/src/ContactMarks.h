// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Visual representation of contacts: a glow along the wall and arrows of the wall's force.

#include "ContactField.h"
#include "SoftDots.h"
#include "SoftLines.h"

class vtkRenderer;

namespace perilymph::visualization {

/// Glow and arrows. The glow faces the viewer, so that forces on an edge-on wall are visible, too.
class ContactMarks {
public:
  explicit ContactMarks(const SceneColors& palette) : palette_(palette) {}

  /// Length of an arrow per millinewton.
  static constexpr double arrow_mm_mN = 0.025;
  /// The same for friction, which is about 20 times smaller.
  static constexpr double frictionArrow_mm_mN = 0.25;
  /// One arrow represents the force on this length of the array.
  static constexpr double arrowEvery_mm = 1.0;

  void addGlow(vtkRenderer& renderer);
  void addArrows(vtkRenderer& renderer);
  void setVisible(bool glow, bool arrows);

  void build(const ContactField& field, const ArrayParts& array, const ArrayPath& path,
             const ViewFrame& view);
  /// Number of arrows of normal force in the last picture.
  int arrows() const { return arrowCount_; }

private:
  void buildGlow(const ContactField& field, const ViewFrame& view);
  void addArrow(const Eigen::Vector3d& from, const Eigen::Vector3d& arrow_mm, const Rgba& color,
                const ViewFrame& view);

  const SceneColors& palette_;
  SoftDots glow_;
  SoftLines arrows_;
  int arrowCount_ = 0;
};

}  // namespace perilymph::visualization
