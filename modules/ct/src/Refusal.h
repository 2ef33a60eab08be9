// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Why a fit gives no measures.

#include "ImageFit.h"
#include "perilymph/ct/CtVolume.h"
#include "perilymph/foundation/Result.h"

namespace perilymph::ct {

/// Refuses a fit that leaves too many of the voxels near its wall unexplained, a spiral that falls,
/// and diameters beyond four standard deviations of the population's. Metal near the fit is named as
/// the reason.
Result<void> checkMisfit(const CtVolume& volume, const FitResult& fit);
Result<void> checkClimb(const CtVolume& volume, const LumenShape& family, const FitResult& fit);
Result<void> checkDiameters(const CtVolume& volume, const FitResult& fit, double a_mm, double b_mm);

}  // namespace perilymph::ct
