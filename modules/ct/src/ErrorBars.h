// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Errors of A, B and H, by source.

#include "ImageFit.h"
#include "LumenWall.h"
#include "RoundWindow.h"
#include "perilymph/ct/Measures.h"

namespace perilymph::ct {

/// Fills A, B, H and the organ-of-Corti length with their values and errors.
///
/// Statistical: the fit's covariance, with noise correlated between voxels by the blur. Model:
/// limits of the shape family, by voxel size, as calibrated on phantoms. Definition: the round
/// window's angle, propagated by finite differences.
void fillMeasures(const LumenShape& family, const FitResult& fit, const RoundWindow& window,
                  const Eigen::Vector3d& axis_W, const Eigen::Vector3d& spacing_mm,
                  CochleaMeasures& measures);

}  // namespace perilymph::ct
