// SPDX-License-Identifier: BSD-3-Clause
#include "points/PointFriction.h"

namespace perilymph::mechanics {

PointFriction pointFriction(const Eigen::Vector3d& stretch_W, double normal, double stiffness,
                            bool wasSliding, const FrictionLaw& law) noexcept
{
  const double length = stretch_W.norm();
  const double pull = stiffness * length;
  const bool isSliding =
      wasSliding ? pull >= law.stoppingCoefficient * normal : pull > law.staticCoefficient * normal;
  Eigen::Vector3d spring_W = stretch_W;
  const double limit = law.kineticCoefficient * normal;
  if (isSliding && pull > limit) spring_W = (limit / pull) * stretch_W;
  return {-stiffness * spring_W, spring_W, isSliding};
}

}  // namespace perilymph::mechanics
