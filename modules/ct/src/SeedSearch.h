#pragma once

// Where in a volume a cochlea may be, when nobody has clicked.

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "perilymph/anatomy/Patient.h"
#include "perilymph/ct/CtVolume.h"

namespace perilymph::ct {

/// The middle of the head, if the volume is wide enough to show both sides: its center along x.
std::optional<double> midline_P(const CtVolume& volume);

/// Places 4 mm apart where the densest bone of the volume surrounds something else, as the otic
/// capsule surrounds the labyrinth; best first.
///
/// @param side  If known and the volume shows both sides, places of the other are left out.
std::vector<Eigen::Vector3d> findSeeds(const CtVolume& volume, std::optional<anatomy::Side> side,
                                       std::size_t count);

}  // namespace perilymph::ct
