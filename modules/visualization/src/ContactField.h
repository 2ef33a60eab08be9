// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Contact forces of the array on the wall, distributed along the array so that the picture does not
// depend on the number of nodes.

#include <vector>

#include "ArrayParts.h"
#include "ArrayPath.h"
#include "PictureSpace.h"
#include "perilymph/haptics/Snapshot.h"

namespace perilymph::visualization {

/// Force of the wall on a short segment of the array.
struct ContactStation {
  double fromTip_mm = 0.0;
  double force_mN_mm = 0.0;     ///< Normal force per length of array.
  double friction_mN_mm = 0.0;  ///< Along the array per length of it, positive toward the tip.
  Eigen::Vector3d wall = Eigen::Vector3d::Zero();    ///< Contact point.
  Eigen::Vector3d inward = Eigen::Vector3d::Zero();  ///< Unit, from the wall into the lumen.
};

/// Normal forces of nodes as force per length at fixed stations along the array.
class ContactField {
public:
  static constexpr double spacing_mm = 0.1;
  /// A node's force is distributed over this distance to either side; larger than any node spacing.
  static constexpr double reach_mm = 0.5;

  explicit ContactField(Length arrayLength);

  void follow(const haptics::Snapshot& now, const PictureSpace& space, const ArrayPath& path,
              const ArrayParts& array);
  void clear();

  const std::vector<ContactStation>& stations() const { return stations_; }
  /// Whether there is any contact.
  bool isTouching() const { return isTouching_; }

private:
  void spread(double fromTip_mm, double force_mN, double friction_mN,
              const Eigen::Vector3d& inward);

  std::vector<ContactStation> stations_;
  bool isTouching_ = false;
};

/// A bell function of finite support with maximum 1 at 0: (1 - (d/r)^2)^2.
inline double bell(double distance, double reach)
{
  const double x = distance / reach;
  return x * x < 1.0 ? (1.0 - x * x) * (1.0 - x * x) : 0.0;
}

}  // namespace perilymph::visualization
