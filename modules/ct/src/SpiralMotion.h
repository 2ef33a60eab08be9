// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The axis of a spiral surface: that of the spiral motion that best maps it onto itself (kinematic
// surface fitting; Pottmann and Randrup 1998, Schraivogel et al. 2019).

#include <Eigen/Core>
#include <optional>
#include <vector>

namespace perilymph::ct {

struct SurfacePoint {
  Eigen::Vector3d point;
  Eigen::Vector3d normal;  ///< Unit, of either sign.
  double weight = 1.0;
};

struct SpiralAxis {
  Eigen::Vector3d direction;  ///< Unit, of either sign.
  Eigen::Vector3d center;     ///< Fixed point of the motion, on the axis.
};

/// Finds the motion v(p) = r x p + c + g p with n . v = 0 at every point: with m = (r, c, g),
///
///     minimize sum w (phi . m)^2 / |d phi . m|^2,  phi = (p x n, n, p . n),
///
/// by generalized eigenvectors, with Student-t weights against outliers. Empty for fewer than 50
/// points or without a rotating motion.
std::optional<SpiralAxis> fitSpiralMotion(const std::vector<SurfacePoint>& points, int rounds = 15);

}  // namespace perilymph::ct
