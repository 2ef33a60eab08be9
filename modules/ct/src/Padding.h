// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Voxels that a file holds but no scanner measured: corners that a tilt or a rotation left empty,
// the surroundings of a cropped or masked part.

#include <optional>

#include "perilymph/ct/CtVolume.h"

namespace perilymph::ct {

/// Marks padding as unmeasured: regions of exactly one intensity that begin at the volume's border,
/// darker than bone, and end abruptly. Measured voxels have noise; clipped air is as constant, but
/// passes into air of nearly its intensity. The voxels around a region are marked, too: resampling
/// mixes them with the padding.
///
/// @param center_P  Where to look: within 20 mm; empty: in the whole volume.
/// @return The volume with `unmeasured` voxels, or empty if it has no padding.
std::optional<CtVolume> withPaddingMarked(const CtVolume& volume,
                                          const std::optional<Eigen::Vector3d>& center_P);

/// A quantile of the measured intensities.
double quantile(const CtVolume& volume, double fraction);

}  // namespace perilymph::ct
