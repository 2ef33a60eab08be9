// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Heights of all nodes above a plane.

#include <Eigen/Core>
#include <vector>

#include "lanes/Lanes.h"

namespace perilymph::mechanics {

inline void setHeights(const std::vector<Eigen::Vector3d>& position_W,
                       const Eigen::Vector3d& origin_W, const Eigen::Vector3d& normal_W,
                       std::vector<double>& height) noexcept
{
  inLanes(0, position_W.size(), [&](auto lane, std::size_t i) PERILYMPH_KERNEL {
    using T = decltype(lane);
    const Triple<T> at = load<T>(position_W, i);
    const Triple<T> from{at.x - origin_W[0], at.y - origin_W[1], at.z - origin_W[2]};
    store(T(from.x * normal_W[0] + from.y * normal_W[1] + from.z * normal_W[2]), height, i);
  });
}

}  // namespace perilymph::mechanics
