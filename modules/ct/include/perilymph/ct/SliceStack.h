// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Whether the slices of a series make a regular stack: from positions and orientations alone.

#include <Eigen/Geometry>
#include <cstddef>
#include <optional>
#include <vector>

#include "perilymph/foundation/Result.h"

namespace perilymph::ct {

/// Where one slice lies in the patient, as its header states.
struct SlicePose {
  std::optional<Eigen::Vector3d> position_P;  ///< Center of the first voxel, LPS [mm].
  /// Direction in which the column index grows along a row, then the one in which the row index
  /// grows; unit vectors at right angles.
  std::optional<Eigen::Matrix<double, 3, 2>> axes_P;
};

/// Slices of one orientation at equal steps.
struct SliceStack {
  /// Indices of the slices at each place, in the direction of the normal; more than one where
  /// several slices lie at the same position.
  std::vector<std::vector<std::size_t>> places;
  Eigen::Matrix<double, 3, 2> axes_P;  ///< In-plane directions, unit, at right angles.
  Eigen::Vector3d origin_P;            ///< First voxel of the first place, on the fitted line [mm].
  Eigen::Vector3d step_P;              ///< From one place to the next [mm].
  double maxDeviation_mm = 0.0;        ///< Maximum distance of a slice from equal steps.
  double tilt_deg = 0.0;  ///< Angle between step and normal: the gantry's, or rounding.

  /// Distance between planes [mm].
  double planeDistance_mm() const { return step_P.dot(axes_P.col(0).cross(axes_P.col(1))); }
};

/// Deviation of a slice from equal steps that is allowed: this fraction of the step, and at most
/// this length [mm].
inline constexpr double allowedDeviationFraction = 0.01, allowedDeviation_mm = 0.02;

/// Deviation that is allowed in any case if all positions are written with two decimals: half a
/// hundredth of a millimeter in each coordinate [mm].
inline constexpr double roundedDeviation_mm = 0.0087;

/// Orders slices along their normal and checks that they lie at equal steps. Thickness and tilt
/// that a header may also state are not looked at.
///
/// Refuses with a sentence that names the slice: slices without position or orientation, several
/// orientations, missing slices, unequal steps, and fewer than two places.
Result<SliceStack> stackSlices(const std::vector<SlicePose>& slices);

}  // namespace perilymph::ct
