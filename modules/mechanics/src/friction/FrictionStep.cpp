// SPDX-License-Identifier: BSD-3-Clause
#include "friction/FrictionStep.h"

#include "friction/FrictionKernel.h"

namespace perilymph::mechanics {
namespace {

Triple<double> asTriple(const Eigen::Vector3d& v) noexcept { return {v[0], v[1], v[2]}; }

FrictionStep asStep(const FrictionStepOf<double>& step) noexcept
{
  const auto vector = [](const Triple<double>& v) { return Eigen::Vector3d(v.x, v.y, v.z); };
  return {vector(step.force_W),     vector(step.spring_W), step.isSliding == yes,
          vector(step.direction_W), step.across,           step.along};
}

SlipBeforeOf<double> asNumbers(const SlipBefore& before) noexcept
{
  return {before.isSliding ? yes : no, before.speed};
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
  return asStep(
      frictionStepAt(asTriple(stretch_W), normal, stiffness, asNumbers(before), law, timeStep));
}

Friction frictionWithFilm(const Eigen::Vector3d& stretch_W, const Eigen::Vector3d& film_W,
                          double normal, double stiffness, const SlipBefore& before,
                          const FrictionLaw& law, const InsertionModel& model) noexcept
{
  const FrictionOf<double> friction = frictionWithFilmAt(
      asTriple(stretch_W), asTriple(film_W), normal, stiffness, asNumbers(before), law, model);
  return {asStep(friction.plain), asStep(friction.film), model.film.fraction > 0.0};
}

}  // namespace perilymph::mechanics
