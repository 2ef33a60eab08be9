// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The opening of a segmented scala.

#include "importing/AxialSections.h"
#include "importing/ClosedSurface.h"

namespace perilymph::anatomy {

/// The opening of an open surface and the straight stretch behind it.
struct SurfaceOpening {
  Eigen::Vector3d center = Eigen::Vector3d::Zero();  ///< Center of the rim.
  Eigen::Vector3d inward = Eigen::Vector3d::Zero();  ///< Along the wall at the rim, unit.
  double leadIn = 0.0;  ///< Length of the straight stretch along it [m].
};

/// Finds the opening of a surface with a rim, and the straight stretch behind it
/// (StraightStretch.h).
SurfaceOpening openingOf(const ClosedSurface& closed);

/// Creates an opening at the basal end of a surface without a rim: triangles that close the duct
/// before its first section become the lid.
///
/// @param first   Center of the first section.
/// @param inward  Along the duct there, unit.
void openAt(ClosedSurface& closed, const Eigen::Vector3d& first, const Eigen::Vector3d& inward);

}  // namespace perilymph::anatomy
