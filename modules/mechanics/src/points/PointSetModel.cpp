// SPDX-License-Identifier: BSD-3-Clause
#include "points/PointSetModel.h"

#include <algorithm>
#include <cmath>

#include "perilymph/foundation/Hash.h"

namespace perilymph::mechanics {
namespace {

/// The published loop ran at 1 kHz.
constexpr double publishedStep = 1e-3;  // [s]

}  // namespace

PointSetModel::PointSetModel(const anatomy::Surface& hapticSurface, int points, double timeStep,
                             const PointSetLaw& given)
    : law(given), surface(hapticSurface, given.radius)
{
  pointMass = law.mass / points;
  const Eigen::Vector3d& box = law.box;
  for (int axis = 0; axis < 3; ++axis) {
    const double one = box[(axis + 1) % 3];
    const double other = box[(axis + 2) % 3];
    inertia[axis] = law.mass / 12.0 * (one * one + other * other);
  }
  // tolerance for rounding errors
  substeps = std::max(1, static_cast<int>(std::ceil(timeStep / publishedStep - 1e-9)));
  substep = timeStep / substeps;

  Hash hash;
  hash.add(surface.fingerprint());
  for (const double value :
       {law.radius, law.stiffness, law.damping, law.turningStiffness, law.turningDamping, law.mass,
        law.box[0], law.box[1], law.box[2], law.surfaceDamping, substep})
    hash.add(value);
  hash.add(points);
  fingerprint = hash.value();
}

}  // namespace perilymph::mechanics
