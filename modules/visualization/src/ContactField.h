#pragma once

// Where and how hard the array presses on the wall, spread along the array so that the number of
// nodes does not change the picture.

#include <vector>

#include "ArrayParts.h"
#include "ArrayPath.h"
#include "PictureSpace.h"
#include "perilymph/haptics/Snapshot.h"

namespace perilymph::visualization {

/// The wall's force on a short stretch of array.
struct ContactStation {
  double fromTip_mm = 0.0;
  double force_mN_mm = 0.0;     ///< Normal force per length of array.
  double friction_mN_mm = 0.0;  ///< Along the array per length of it, positive toward the tip.
  Eigen::Vector3d wall = Eigen::Vector3d::Zero();    ///< Where the array touches.
  Eigen::Vector3d inward = Eigen::Vector3d::Zero();  ///< Unit, from the wall into the lumen.
};

/// Normal forces of nodes as force per length on fixed stations along the array.
class ContactField {
public:
  static constexpr double spacing_mm = 0.1;
  /// A node's force is spread over this distance to either side; wider than any node spacing used.
  static constexpr double reach_mm = 0.5;

  explicit ContactField(Length arrayLength);

  void follow(const haptics::Snapshot& now, const PictureSpace& space, const ArrayPath& path,
              const ArrayParts& array);
  void clear();

  const std::vector<ContactStation>& stations() const { return stations_; }
  /// Whether anything touches.
  bool isTouching() const { return isTouching_; }

private:
  void spread(double fromTip_mm, double force_mN, double friction_mN,
              const Eigen::Vector3d& inward);

  std::vector<ContactStation> stations_;
  bool isTouching_ = false;
};

/// A bell of finite reach with its greatest value 1 at 0: (1 - (d/r)^2)^2.
inline double bell(double distance, double reach)
{
  const double x = distance / reach;
  return x * x < 1.0 ? (1.0 - x * x) * (1.0 - x * x) : 0.0;
}

}  // namespace perilymph::visualization
