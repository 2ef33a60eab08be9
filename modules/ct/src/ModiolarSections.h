// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Cross-check of a fit: the half-maximum wall in sections through the modiolus.

#include <optional>

#include "ImageFit.h"
#include "SpiralMotion.h"
#include "perilymph/ct/CtVolume.h"

namespace perilymph::ct {

/// Half-maximum wall compared with the fitted one, along rays from the sections' centers.
struct SectionCheck {
  double rms_mm = 0.0;   ///< Root mean square distance, excluding those over 0.8 mm.
  double bias_mm = 0.0;  ///< Mean, positive if the half-maximum wall is outside.
  double missing = 0.0;  ///< Fraction of the rays without a wall within 0.8 mm.
  double clipped = 0.0;  ///< Fraction of the rays that leave the volume.
  /// Axis of the best-fitting spiral motion of the half-maximum wall, in W.
  std::optional<SpiralAxis> kinematic;
};

/// Sections every 15 degrees from 20 to 540, rays to the outer wall, floor and roof.
SectionCheck checkSections(const CtVolume& volume, const ShapedLumen& lumen, const FitState& state);

}  // namespace perilymph::ct
