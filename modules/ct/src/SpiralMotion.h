#pragma once

// The axis of a surface that winds: that of the spiral motion which moves it most nearly along
// itself (kinematic surface fitting; Pottmann and Randrup 1998, Schraivogel et al. 2019).

#include <Eigen/Core>
#include <optional>
#include <vector>

namespace perilymph::ct {

struct SurfacePoint {
  Eigen::Vector3d point;
  Eigen::Vector3d normal;  ///< Unit; either way.
  double weight = 1.0;
};

struct SpiralAxis {
  Eigen::Vector3d direction;  ///< Unit; either way.
  Eigen::Vector3d center;     ///< On the axis, where the motion stands still.
};

/// Finds the motion v(p) = r x p + c + g p with n . v = 0 at every point: with m = (r, c, g),
///
///     minimize sum w (phi . m)^2 / |d phi . m|^2,  phi = (p x n, n, p . n),
///
/// by generalized eigenvectors, with Student-t weights against what is no cochlea. None where fewer
/// than 50 points or no turning motion is found.
std::optional<SpiralAxis> fitSpiralMotion(const std::vector<SurfacePoint>& points, int rounds = 15);

}  // namespace perilymph::ct
