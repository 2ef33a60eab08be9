#pragma once

// Cross-check of a fit: the wall at half maximum in sections through the modiolus.

#include <optional>

#include "ImageFit.h"
#include "SpiralMotion.h"
#include "perilymph/ct/CtVolume.h"

namespace perilymph::ct {

/// Half-maximum wall against the fitted one, along rays from the sections' middles.
struct SectionCheck {
  double rms_mm = 0.0;   ///< Root mean square of their distance, those over 0.8 mm left out.
  double bias_mm = 0.0;  ///< Mean, positive where the half-maximum wall lies outside.
  double missing = 0.0;  ///< Share of the rays that meet no wall within 0.8 mm.
  double clipped = 0.0;  ///< Share of the rays that leave the volume.
  /// Axis of the spiral motion nearest to the half-maximum wall, in W.
  std::optional<SpiralAxis> kinematic;
};

/// Sections every 15 degrees from 20 to 540, rays to the outer wall, floor and roof.
SectionCheck checkSections(const CtVolume& volume, const ShapedLumen& lumen, const FitState& state);

}  // namespace perilymph::ct
