// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Where a cochlea lies, from the metal of an array in it.

#include <Eigen/Core>
#include <optional>
#include <stop_token>
#include <vector>

#include "perilymph/ct/Measures.h"

namespace perilymph::outcome {

/// Places of the mean cochlea at which its scala tympani holds the metal, the best first: circles through the
/// metal give center and axis, all turns about it are tried, and the metal is moved into the duct. The lead
/// continues straight from the opening. Empty if no metal curves as an array in a cochlea does.
///
/// @param metal_P  Points of metal [mm], of an array and of whatever else is in the volume.
/// @param side     Only this ear, if it is known.
/// @param stop     Ends it early, with what was found.
std::vector<ct::CochleaStart> cochleaeAroundMetal(const std::vector<Eigen::Vector3d>& metal_P,
                                                  std::optional<anatomy::Side> side,
                                                  const std::stop_token& stop);

}  // namespace perilymph::outcome
