// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Rows of contacts along a course: where an array's contacts may lie on the ridge of the metal.

#include <Eigen/Core>
#include <map>
#include <vector>

#include "EarFrame.h"
#include "MetalGrid.h"
#include "perilymph/electrode/ArrayDesign.h"

namespace perilymph::outcome {

/// Positions of all contacts from the tip, for the best rows that begin at least 0.4 spacings from each other, the
/// best first. A row's contacts lie on bright spots along the course and keep the array's spacings on it, by dynamic
/// programming over all places; before its first contact there is no metal.
///
/// @param contrast  The metal's difference of Gaussians on the grid, see contrastOf().
/// @param ridge_P   From the apical end of the metal toward the base; it is continued along the metal at both ends.
/// @param byHand    Contacts that a person placed, by their index.
std::vector<std::vector<Eigen::Vector3d>> rowsAlong(
    const MetalGrid& grid, const std::vector<float>& contrast,
    const std::vector<Eigen::Vector3d>& ridge_P, const EarFrame& frame,
    const electrode::ArrayDesign& array, double fwhm_mm,
    const std::map<std::size_t, Eigen::Vector3d>& byHand, std::size_t most);

}  // namespace perilymph::outcome
