// SPDX-License-Identifier: BSD-3-Clause
#include "lumen/LeadIn.h"

#include <array>
#include <cmath>

#include "lumen/Outline.h"
#include "numerics/CubicTable.h"
#include "perilymph/foundation/Math.h"
#include "perilymph/foundation/Units.h"

namespace perilymph::anatomy {
namespace {

constexpr double joint_deg = 12.0;

/// Intersection of the line from a point of the first section along `tangent` with the half-plane
/// at an angle.
HalfPlanePoint carried(const HalfPlanePoint& from, const Eigen::Vector3d& tangent,
                       const SineCosine& turn)
{
  const double along = from.r * turn.sine / (tangent.y() * turn.cosine - tangent.x() * turn.sine);
  const double x = from.r + along * tangent.x();
  const double y = along * tangent.y();
  return {x * turn.cosine + y * turn.sine, from.z + along * tangent.z()};
}

}  // namespace

void easeIntoLeadIn(SectionTables& tables)
{
  const auto directions = static_cast<std::size_t>(tables.directions);
  const CubicWeights start(0.0);
  const auto slopeAtStart = [&](const std::vector<double>& samples) {
    return weighted(interpolatingCoefficients(samples).data(), start.slope) / tables.step;
  };
  const HalfPlanePoint firstCenter{tables.centerRadius[0], tables.centerHeight[0]};
  const Eigen::Vector3d tangent(slopeAtStart(tables.centerRadius), firstCenter.r,
                                slopeAtStart(tables.centerHeight));
  std::vector<SineCosine> rays;
  for (std::size_t k = 0; k < directions; ++k)
    rays.push_back(sineCosine(2.0 * pi * static_cast<double>(k) / static_cast<double>(directions)));
  const auto wallPoint = [&](std::size_t section, std::size_t k) {
    const double radius = tables.wallRadius[section * directions + k];
    return HalfPlanePoint{tables.centerRadius[section] + radius * rays[k].cosine,
                          tables.centerHeight[section] + radius * rays[k].sine};
  };
  const std::array<HalfPlanePoint, 2> firstMembrane{
      HalfPlanePoint{firstCenter.r + tables.membraneInner[0],
                     firstCenter.z + tables.membraneHeight[0]},
      HalfPlanePoint{firstCenter.r + tables.membraneOuter[0],
                     firstCenter.z + tables.membraneHeight[0]}};
  std::vector<HalfPlanePoint> first;
  for (std::size_t k = 0; k < directions; ++k) first.push_back(wallPoint(0, k));

  const double joint = joint_deg * pi / 180.0;
  for (std::size_t i = 1; tables.step * static_cast<double>(i) < joint; ++i) {
    const double x = tables.step * static_cast<double>(i) / joint;
    const double weight = x * x * x * (10.0 + x * (-15.0 + 6.0 * x));
    const SineCosine turn = sineCosine(tables.step * static_cast<double>(i));
    const auto eased = [&](const HalfPlanePoint& atStart, const HalfPlanePoint& here) {
      return mix(carried(atStart, tangent, turn), here, weight);
    };
    const HalfPlanePoint oldCenter{tables.centerRadius[i], tables.centerHeight[i]};
    const HalfPlanePoint center = eased(firstCenter, oldCenter);
    std::vector<HalfPlanePoint> outline;
    for (std::size_t k = 0; k < directions; ++k)
      outline.push_back(eased(first[k], wallPoint(i, k)));
    const double roof = oldCenter.z + tables.membraneHeight[i];
    const HalfPlanePoint inner =
        eased(firstMembrane[0], {oldCenter.r + tables.membraneInner[i], roof});
    const HalfPlanePoint outer =
        eased(firstMembrane[1], {oldCenter.r + tables.membraneOuter[i], roof});

    tables.centerRadius[i] = center.r;
    tables.centerHeight[i] = center.z;
    tables.membraneInner[i] = inner.r - center.r;
    tables.membraneOuter[i] = outer.r - center.r;
    tables.membraneHeight[i] = 0.5 * (inner.z + outer.z) - center.z;
    std::size_t near = 0;
    for (std::size_t k = 0; k < directions; ++k)
      tables.wallRadius[i * directions + k] = radiusIn(outline, center, rays[k], near);
  }
}

}  // namespace perilymph::anatomy
