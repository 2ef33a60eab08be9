// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/haptics/Passivity.h"

#include <algorithm>

namespace perilymph::haptics {

void Passivity::observe(const Eigen::Vector3d& shown_D, const Eigen::Vector3d& moved_D) noexcept
{
  energy_ -= shown_D.dot(moved_D);
}

Eigen::Vector3d Passivity::control(const Eigen::Vector3d& wanted_D,
                                   const Eigen::Vector3d& moved_D) const noexcept
{
  const double ahead = energy_ - wanted_D.dot(moved_D);
  const double movedSquared = moved_D.squaredNorm();
  if (ahead >= 0.0 || movedSquared == 0.0) return wanted_D;
  // b v = (b / dt) moved, and v . v dt = moved . moved / dt
  const double perMove = std::min(-ahead / movedSquared, maxDamping / timeStep_);
  return wanted_D - perMove * moved_D;
}

}  // namespace perilymph::haptics
