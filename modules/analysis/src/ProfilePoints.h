// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Force over depth at equally spaced depths.

#include <algorithm>
#include <cmath>
#include <vector>

#include "perilymph/analysis/FullInsertion.h"

namespace perilymph::analysis {

/// Adds the force at each multiple of the spacing that the tip passes for the first time, linear
/// between ticks.
class ProfilePoints {
public:
  /// @param spacing  0: no points.
  explicit ProfilePoints(Length spacing) : spacing_(spacing.si()) {}

  /// @param depth  [m]
  /// @param force  [N]
  void add(std::vector<DepthForce>& profile, double depth, double force)
  {
    if (!(spacing_ > 0.0)) return;
    if (hasBegun_ && depth > depth_) {
      for (; static_cast<double>(next_) * spacing_ <= depth; ++next_) {
        const double place = static_cast<double>(next_) * spacing_;
        const double fraction = (place - depth_) / (depth - depth_);
        profile.push_back({meters(place), newtons(force_ + fraction * (force - force_))});
      }
    }
    if (!hasBegun_) next_ = static_cast<long>(std::ceil(std::max(depth, 0.0) / spacing_));
    if (hasBegun_ && depth < depth_) return;  // the force at the first passage counts
    hasBegun_ = true;
    depth_ = depth;
    force_ = force;
  }

private:
  double spacing_;
  bool hasBegun_ = false;
  long next_ = 0;
  double depth_ = 0.0, force_ = 0.0;
};

}  // namespace perilymph::analysis
