// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Exhaustive search for a cochlea of mean shape near a point, with a few points inside and outside
// the wall.

#include <stop_token>
#include <vector>

#include "LumenShape.h"
#include "Pieces.h"
#include "Pose.h"
#include "Region.h"

namespace perilymph::ct {

/// A pose and its score: mean of the points inside minus that of the points outside, where 1 is the
/// lumen's level and 0 the bone's.
struct Candidate {
  Pose pose;
  double score = 0.0;
};

/// Points in W expected in the lumen or in bone.
struct Template {
  std::vector<Eigen::Vector3d> inside_W, outside_W;
};
Template meanTemplate(const LumenShape& family);

/// Finds distinct poses of both handednesses within `reach_mm` of a point, best first.
///
/// @param lumen      Intensity of the lumen's content.
/// @param stop       Ends the search early, with no pose.
std::vector<Candidate> searchPoses(const Region& region, double bone, double lumen,
                                   const Template& points, const Eigen::Vector3d& near_P,
                                   double reach_mm, std::size_t count, Threads threads,
                                   const std::stop_token& stop);

}  // namespace perilymph::ct
