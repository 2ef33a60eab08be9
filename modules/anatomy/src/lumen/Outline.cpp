// SPDX-License-Identifier: BSD-3-Clause
#include "lumen/Outline.h"

#include <algorithm>

namespace perilymph::anatomy {

HalfPlanePoint centroid(const Outline& outline)
{
  // relative to the first corner, so that small outlines far away lose no precision
  const HalfPlanePoint& first = outline.front();
  double area = 0.0, r = 0.0, z = 0.0;
  for (std::size_t k = 0; k < outline.size(); ++k) {
    const HalfPlanePoint& a = outline[k];
    const HalfPlanePoint& b = outline[(k + 1) % outline.size()];
    const double twice = (a.r - first.r) * (b.z - first.z) - (b.r - first.r) * (a.z - first.z);
    area += twice;
    r += twice * (a.r + b.r - 2.0 * first.r);
    z += twice * (a.z + b.z - 2.0 * first.z);
  }
  return {first.r + r / (3.0 * area), first.z + z / (3.0 * area)};
}

double radiusIn(const Outline& outline, const HalfPlanePoint& center, const SineCosine& direction,
                std::size_t& near)
{
  const std::size_t begin = near;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const std::size_t k = (begin + i) % outline.size();
    const HalfPlanePoint& a = outline[k];
    const HalfPlanePoint& b = outline[(k + 1) % outline.size()];
    // across the ray the two ends lie on different sides; along it the crossing lies ahead
    const double sideA = (a.z - center.z) * direction.cosine - (a.r - center.r) * direction.sine;
    const double sideB = (b.z - center.z) * direction.cosine - (b.r - center.r) * direction.sine;
    if (sideA > 0.0 || sideB <= 0.0) continue;
    const HalfPlanePoint crossing = mix(a, b, sideA / (sideA - sideB));
    const double ahead =
        (crossing.r - center.r) * direction.cosine + (crossing.z - center.z) * direction.sine;
    if (ahead <= 0.0) continue;
    near = k;
    return ahead;
  }
  return 0.0;
}

double roofAt(const Outline& outline, double r)
{
  double highest = outline.front().z, roof = -1e9;
  for (std::size_t k = 0; k < outline.size(); ++k) {
    const HalfPlanePoint& a = outline[k];
    const HalfPlanePoint& b = outline[(k + 1) % outline.size()];
    highest = std::max(highest, a.z);
    if ((a.r - r) * (b.r - r) > 0.0 || a.r == b.r) continue;
    roof = std::max(roof, mix(a, b, (r - a.r) / (b.r - a.r)).z);
  }
  return roof > -1e9 ? roof : highest;
}

}  // namespace perilymph::anatomy
