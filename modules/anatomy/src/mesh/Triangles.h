// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Corners and normals of a surface's triangles.

#include <Eigen/Geometry>
#include <array>

#include "perilymph/anatomy/Surface.h"

namespace perilymph::anatomy {

/// A corner of a surface [m].
inline Eigen::Vector3d corner(const Surface& surface, int index)
{
  const auto& p = surface.points[static_cast<std::size_t>(index)];
  return {p[0], p[1], p[2]};
}

/// Normal of a triangle, scaled by twice the area [m^2].
inline Eigen::Vector3d scaledNormal(const Surface& surface, const std::array<int, 3>& t)
{
  return (corner(surface, t[1]) - corner(surface, t[0]))
      .cross(corner(surface, t[2]) - corner(surface, t[0]));
}

}  // namespace perilymph::anatomy
