// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The center line of the array as a smooth curve through the nodes of a snapshot.

#include <Eigen/Core>
#include <span>
#include <vector>

#include "PictureSpace.h"
#include "perilymph/foundation/Units.h"
#include "perilymph/haptics/Snapshot.h"

namespace perilymph::visualization {

/// A point on the center line with its frame; unit vectors in picture space.
struct PathPoint {
  Eigen::Vector3d place;
  Eigen::Vector3d along;  ///< Toward the tip.
  Eigen::Vector3d inner;  ///< Perpendicular, toward the modiolus: facing direction of the contacts.
  Eigen::Vector3d side;   ///< along cross inner.
};

/// A Catmull-Rom curve through the nodes, extended by straight lines.
class ArrayPath {
public:
  explicit ArrayPath(Length length);

  void follow(const haptics::Snapshot& now, const PictureSpace& space);
  void follow(std::span<const Eigen::Vector3d> nodes_W, const PictureSpace& space);
  bool isEmpty() const { return nodes_.size() < 2; }

  /// The point at a distance from the tip; negative beyond the tip, above the length behind the
  /// base.
  PathPoint at(double fromTip_mm) const;
  double length_mm() const { return length_mm_; }

private:
  PathPoint withFrame(const Eigen::Vector3d& place, const Eigen::Vector3d& along) const;

  double length_mm_;
  std::vector<Eigen::Vector3d> nodes_;  ///< [mm], base first.
};

}  // namespace perilymph::visualization
