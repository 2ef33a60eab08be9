// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// A tilted gantry's volume at right angles.

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

#include "perilymph/foundation/Result.h"

namespace perilymph::imaging {

struct Grid {
  std::array<int, 3> size{};
  Eigen::Matrix4d lps_PI = Eigen::Matrix4d::Identity();  ///< Index to LPS [mm].
  std::vector<std::int16_t> voxels;
};

/// Resamples a sheared grid so that its axes are at right angles, with a windowed sinc. What lies beyond the measured
/// slices is `ct::unmeasured`.
Result<Grid> rectified(const Grid& sheared);

}  // namespace perilymph::imaging
