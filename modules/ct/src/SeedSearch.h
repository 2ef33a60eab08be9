// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Automatic search for cochleae in a volume.

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "perilymph/ct/CtVolume.h"

namespace perilymph::ct {

/// The x coordinate of the head's midline, if the volume is wide enough to contain both sides: its
/// center.
std::optional<double> midline_P(const CtVolume& volume);

/// Farther apart than two places in one cochlea, nearer than two ears [mm].
inline constexpr double anotherEar_mm = 30.0;

/// Points 4 mm apart where the densest bone surrounds lower intensities, as the otic capsule
/// surrounds the labyrinth; best first.
///
/// @param elsewhere_P  Points less than `anotherEar_mm` from this one are left out.
std::vector<Eigen::Vector3d> findSeeds(const CtVolume& volume,
                                       const std::optional<Eigen::Vector3d>& elsewhere_P,
                                       std::size_t count);

}  // namespace perilymph::ct
