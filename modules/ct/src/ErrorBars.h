#pragma once

// The errors of A, B and H, by source.

#include "ImageFit.h"
#include "LumenWall.h"
#include "RoundWindow.h"
#include "perilymph/ct/Measures.h"

namespace perilymph::ct {

/// Fills A, B, H and the organ-of-Corti length with their values and errors.
///
/// Statistical: the fit's covariance, with the noise correlated from voxel to voxel by the blur.
/// Model: what the shapes leave out, by the voxel's length, as calibrated on phantoms.
/// Definition: the round window's angle, carried through the measures by differences.
void fillMeasures(const LumenShape& family, const FitResult& fit, const RoundWindow& window,
                  const Eigen::Vector3d& axis_W, const Eigen::Vector3d& spacing_mm,
                  CochleaMeasures& measures);

}  // namespace perilymph::ct
