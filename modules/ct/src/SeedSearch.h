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

/// Points 4 mm apart where the densest bone surrounds lower intensities, as the otic capsule
/// surrounds the labyrinth; best first.
///
/// @param elsewhere_P  Points within 30 mm of this one are left out: less than between two ears.
std::vector<Eigen::Vector3d> findSeeds(const CtVolume& volume,
                                       const std::optional<Eigen::Vector3d>& elsewhere_P,
                                       std::size_t count);

}  // namespace perilymph::ct
