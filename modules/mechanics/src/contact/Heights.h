// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Heights of all nodes above a plane.

#include <Eigen/Core>
#include <algorithm>
#include <span>
#include <vector>

#include "lanes/Lanes.h"
#include "perilymph/anatomy/Lumen.h"

namespace perilymph::mechanics {

inline void setHeights(const std::vector<Eigen::Vector3d>& position_W,
                       const Eigen::Vector3d& origin_W, const Eigen::Vector3d& normal_W,
                       std::vector<double>& height) noexcept
{
  const Triple<double> origin{origin_W[0], origin_W[1], origin_W[2]};
  const Triple<double> normal{normal_W[0], normal_W[1], normal_W[2]};
  double* above = height.data();
  inLanes(0, position_W.size(), [=, &position_W](auto lane, std::size_t i) PERILYMPH_KERNEL {
    using T = decltype(lane);
    const Triple<T> at = load<T>(position_W, i);
    const Triple<T> from{at.x - origin.x, at.y - origin.y, at.z - origin.z};
    store(T(from.x * normal.x + from.y * normal.y + from.z * normal.z), above, i);
  });
}

/// Puts the nodes past the first quarter turn behind the plane of the opening, which may cut their turn:
/// its rim, its passage and the forceps in front of it do not act on them.
inline void placeLaterTurnsBehind(std::span<const anatomy::LumenTrack> track,
                                  std::vector<double>& height) noexcept
{
  for (std::size_t i = height.size(); i-- > 0 && !track[i].isNearOpening();)
    height[i] = std::min(height[i], -10e-3);
}

}  // namespace perilymph::mechanics
