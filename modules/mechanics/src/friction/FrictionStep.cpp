// SPDX-License-Identifier: BSD-3-Clause
#include "friction/FrictionStep.h"

#include <algorithm>
#include <cmath>

namespace perilymph::mechanics {
namespace {

/// Largest friction of a node, and its derivative by the stretch of the spring.
struct FrictionLimit {
  double force;     ///< [N]
  double rise = 0;  ///< [N/m]
};

/// With the coefficient mu(v) + mu'(v) (u - v) at the speed u of the spring's end, u = (s - L / k) /
/// dt for the stretch s and the friction L.
FrictionLimit limitAt(double stretch, double normal, double stiffness, const SlipBefore& before,
                      const FrictionLaw& law, double timeStep) noexcept
{
  if (!before.isSliding) return {law.staticCoefficient * normal};
  const double force = law.sliding(before.speed) * normal;
  const double slope = law.rise(before.speed) * normal / timeStep;
  if (!(slope > 0.0)) return {force};
  const double weight = 1.0 / (1.0 + slope / stiffness);
  const double rising = weight * (force + slope * (stretch - timeStep * before.speed));
  const double low = law.bySpeed.minimum() * normal, high = law.bySpeed.maximum() * normal;
  if (rising < low) return {low};
  if (rising > high) return {high};
  return {rising, weight * slope};
}

}  // namespace

Eigen::Matrix3d FrictionStep::stiffness(const Eigen::Vector3d& normal_W) const noexcept
{
  const Eigen::Matrix3d tangential = Eigen::Matrix3d::Identity() - normal_W * normal_W.transpose();
  const Eigen::Matrix3d ways = direction_W * direction_W.transpose();
  Eigen::Matrix3d stiffness = across * (tangential - ways);
  if (along > 0.0) stiffness += along * ways;
  return stiffness;
}

FrictionStep frictionStep(const Eigen::Vector3d& stretch_W, double normal, double stiffness,
                          const SlipBefore& before, const FrictionLaw& law,
                          double timeStep) noexcept
{
  const double length = stretch_W.norm();
  const double trial = stiffness * length;
  const FrictionLimit limit = limitAt(length, normal, stiffness, before, law, timeStep);

  FrictionStep step;
  if (trial <= limit.force) {
    step.force_W = -stiffness * stretch_W;
    step.across = stiffness;
    step.spring_W = stretch_W;
    step.isSliding = before.isSliding && trial > law.stoppingCoefficient * normal;
    return step;
  }
  // slides: the spring keeps what the friction cone allows, the rest is dissipated
  step.direction_W = stretch_W / length;
  step.force_W = -limit.force * step.direction_W;
  step.across = limit.force / length;
  step.along = limit.rise;
  step.spring_W = (limit.force / stiffness) * step.direction_W;
  step.isSliding = true;
  return step;
}

Friction frictionWithFilm(const Eigen::Vector3d& stretch_W, const Eigen::Vector3d& film_W,
                          double normal, double stiffness, const SlipBefore& before,
                          const FrictionLaw& law, const InsertionModel& model) noexcept
{
  const auto& [fraction, ratio] = model.film;
  Friction friction;
  friction.hasFilm = fraction > 0.0;
  if (!friction.hasFilm) {
    friction.plain = frictionStep(stretch_W, normal, stiffness, before, law, model.timeStep);
    return friction;
  }
  const double plain = 1.0 - fraction, kept = 1.0 / (1.0 + ratio);
  friction.film = frictionStep(film_W, fraction * normal, kept * fraction * stiffness, before, law,
                               model.timeStep);
  friction.film.spring_W *= kept;
  if (plain > 0.0)
    friction.plain =
        frictionStep(stretch_W, plain * normal, plain * stiffness, before, law, model.timeStep);
  else
    friction.plain.isSliding = friction.film.isSliding;
  return friction;
}

}  // namespace perilymph::mechanics
