// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Automatic search for cochleae in a volume.

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "perilymph/anatomy/Patient.h"
#include "perilymph/ct/CtVolume.h"

namespace perilymph::ct {

/// The x coordinate of the head's midline, if the volume is wide enough to contain both sides: its
/// center.
std::optional<double> midline_P(const CtVolume& volume);

/// Points 4 mm apart where the densest bone surrounds lower intensities, as the otic capsule
/// surrounds the labyrinth; best first.
///
/// @param side  If known and the volume contains both sides, points of the other are omitted.
std::vector<Eigen::Vector3d> findSeeds(const CtVolume& volume, std::optional<anatomy::Side> side,
                                       std::size_t count);

}  // namespace perilymph::ct
