// SPDX-License-Identifier: BSD-3-Clause
#include "codec/LinkageKinematics.h"

#include <algorithm>
#include <cmath>

#include "perilymph/foundation/Math.h"
#include "perilymph/foundation/Units.h"

namespace perilymph::device {

namespace {

struct Directions {
  SineCosine a;
  SineCosine b;
  SineCosine c;
  double reach;  ///< Distance of the handle from the base's axis [m].
};

Directions directions(const Linkage& linkage, const std::array<double, 3>& angles) noexcept
{
  Directions result{sineCosine(angles[0]), sineCosine(angles[1]), sineCosine(angles[2]), 0.0};
  result.reach = linkage.lengthB * result.b.sine + linkage.lengthC * result.c.sine;
  return result;
}

}  // namespace

std::array<double, 3> bodyAngles(const Linkage& linkage,
                                 const std::array<double, 3>& counts) noexcept
{
  std::array<double, 3> angles{};
  for (std::size_t i = 0; i < angles.size(); ++i)
    angles[i] = 2.0 * pi * counts[i] / linkage.countsPerTurn[i] * linkage.bodyTurnsPerTurn[i];
  return angles;
}

std::array<double, 3> handlePosition_B(const Linkage& linkage,
                                       const std::array<double, 3>& angles) noexcept
{
  const Directions at = directions(linkage, angles);
  return {at.a.cosine * at.reach - linkage.origin_B[0], at.a.sine * at.reach - linkage.origin_B[1],
          linkage.height + linkage.lengthB * at.b.cosine - linkage.lengthC * at.c.cosine -
              linkage.origin_B[2]};
}

std::array<double, 3> bodyTorques(const Linkage& linkage, const std::array<double, 3>& angles,
                                  const std::array<double, 3>& force_B) noexcept
{
  const Directions at = directions(linkage, angles);
  const double outward = at.a.cosine * force_B[0] + at.a.sine * force_B[1];
  const double around = at.a.cosine * force_B[1] - at.a.sine * force_B[0];
  return {at.reach * around, linkage.lengthB * (at.b.cosine * outward - at.b.sine * force_B[2]),
          linkage.lengthC * (at.c.cosine * outward + at.c.sine * force_B[2])};
}

std::array<double, 3> motorCurrents(const Linkage& linkage,
                                    const std::array<double, 3>& torques) noexcept
{
  std::array<double, 3> currents{};
  double limit = 0.0;
  for (std::size_t i = 0; i < currents.size(); ++i) {
    currents[i] = torques[i] * linkage.bodyTurnsPerTurn[i] / linkage.torqueConstant[i];
    if (!std::isfinite(currents[i])) return {};
    limit = std::max(limit, std::fabs(currents[i]));
  }
  if (limit > linkage.maxCurrent)
    for (double& current : currents) current *= linkage.maxCurrent / limit;
  return currents;
}

}  // namespace perilymph::device
