// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/mechanics/PointSet.h"

#include "perilymph/foundation/Hash.h"

namespace perilymph::mechanics {
namespace {

void addVector(Hash& hash, const Eigen::Vector3d& vector) noexcept
{
  for (int k = 0; k < 3; ++k) hash.add(vector[k]);
}

}  // namespace

void PointSetState::addTo(Hash& hash) const noexcept
{
  for (const auto& place : place_W) addVector(hash, place);
  for (const auto& proxy : proxy_W) addVector(hash, proxy);
  for (const Eigen::Vector3d* vector :
       {&hand_W, &handAxis_W, &turn_W, &turnRate_W, &friction_W, &pull_W, &moment_W})
    addVector(hash, *vector);
  hash.add(turnedAt);
  hash.add(atBounds);
}

}  // namespace perilymph::mechanics
