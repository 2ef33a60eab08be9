#pragma once

// The center line of the array as a smooth curve through the nodes of a snapshot.

#include <Eigen/Core>
#include <vector>

#include "PictureSpace.h"
#include "perilymph/foundation/Units.h"
#include "perilymph/haptics/Snapshot.h"

namespace perilymph::visualization {

/// A place on the center line with its frame; unit vectors in the picture's space.
struct PathPoint {
  Eigen::Vector3d place;
  Eigen::Vector3d along;  ///< Toward the tip.
  Eigen::Vector3d inner;  ///< Across, toward the modiolus: where the contacts look.
  Eigen::Vector3d side;   ///< along cross inner.
};

/// A Catmull-Rom curve through the nodes; beyond its ends it goes on straight.
class ArrayPath {
public:
  explicit ArrayPath(Length length);

  void follow(const haptics::Snapshot& now, const PictureSpace& space);
  bool isEmpty() const { return nodes_.size() < 2; }

  /// The path at a distance from the tip; negative before the tip, above the length behind the
  /// base.
  PathPoint at(double fromTip_mm) const;
  double length_mm() const { return length_mm_; }

private:
  PathPoint withFrame(const Eigen::Vector3d& place, const Eigen::Vector3d& along) const;

  double length_mm_;
  std::vector<Eigen::Vector3d> nodes_;  ///< [mm], base first.
};

}  // namespace perilymph::visualization
