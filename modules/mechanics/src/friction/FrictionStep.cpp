// SPDX-License-Identifier: BSD-3-Clause
#include "friction/FrictionStep.h"

#include <cmath>

namespace perilymph::mechanics {

FrictionStep frictionStep(const Eigen::Vector3d& stretch_W, double normal, double stiffness,
                          bool isSliding, double slipSpeed, const Eigen::Vector3d& normal_W,
                          const FrictionLaw& law) noexcept
{
  const Eigen::Matrix3d tangential = Eigen::Matrix3d::Identity() - normal_W * normal_W.transpose();
  const double length = stretch_W.norm();
  const double trial = stiffness * length;

  const double coefficient = isSliding ? law.sliding(slipSpeed) : law.staticCoefficient;
  const double limit = coefficient * normal;

  FrictionStep step;
  if (trial <= limit) {
    step.force_W = -stiffness * stretch_W;
    step.stiffness = stiffness * tangential;
    step.spring_W = stretch_W;
    step.isSliding = isSliding && trial > law.stoppingCoefficient * normal;
    return step;
  }
  // slides: the spring keeps what the friction cone allows, the rest is dissipated
  const Eigen::Vector3d direction = stretch_W / length;
  step.force_W = -limit * direction;
  step.stiffness = (limit / length) * (tangential - direction * direction.transpose());
  step.spring_W = (limit / stiffness) * direction;
  step.isSliding = true;
  return step;
}

}  // namespace perilymph::mechanics
