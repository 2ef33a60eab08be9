// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The elastic energy of an array, by the formulas and not by the solver.

#include <Eigen/Core>
#include <vector>

#include "perilymph/mechanics/InsertionModel.h"

namespace perilymph::test {

/// What an array's energy depends on.
struct ArrayPose {
  std::vector<Eigen::Vector3d> nodes_W;  ///< [m]
  std::vector<Eigen::Vector3d>
      curl_W;                     ///< Unit direction of each edge in which the material curls.
  double styletWithdrawal = 0.0;  ///< [m]
  double released = 1.0;          ///< Share of its rest curvature it has taken on.
};

/// Energy of bending and twist [J]: the sum over the inner nodes of
///
///     EI |s|^2 / (2 h) + EI' (s . a)^2 / (2 h) + GJ m^2 / (2 h),   s = w - h kappa d,
///
/// with EI the lesser stiffness and EI' what the other, along a, has more; m is the angle by which
/// the curl of the one edge, turned along with the edge by the least rotation, misses that of the
/// next. A straight round array has no twist.
double elasticEnergy(const mechanics::InsertionModel& model, const ArrayPose& pose);

}  // namespace perilymph::test
