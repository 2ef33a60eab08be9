// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// What the voxels show along a fitted lumen. The shape prior continues a fit where a cochlea has no
// lumen or no wall; these findings tell how much of it was seen.

#include <optional>

#include "ImageFit.h"
#include "perilymph/ct/CtVolume.h"

namespace perilymph::ct {

/// Whether the middle turn winds around bone. In an incomplete partition of type II the middle and
/// the apical turn are one cavity, which a fit fills with turns.
enum class ModiolusFinding {
  seen,
  absent,     ///< What lies within the turn is as much lumen as the turn.
  notJudged,  ///< Blur or noise hide the difference, or the turn is not empty.
};

struct LumenFindings {
  /// Turns from 0 degrees to the first angle beyond 180 degrees where bone fills the section for
  /// 40 degrees, or where it fades before something else is seen again; the fitted lumen's own if it is
  /// open to its apex.
  double turns = 0.0;
  /// Fraction of the first turn without a contrast between lumen and outer wall.
  double basalGap = 0.0;
  double unmeasured = 0.0;  ///< Fraction of the sections in or beside unmeasured voxels.
  ModiolusFinding modiolus;
  double metal_mm3 =
      0.0;  ///< See metalAround_mm3(), which is evidence even if metal drew the fit aside.
};

/// Examines sections every 10 degrees from 20 degrees to the apex.
/// @param result  The fit's.
LumenFindings examineLumen(const CtVolume& volume, const ShapedLumen& lumen, const ImageFit& fit,
                           const FitResult& result);

/// Volume of the metal within 8 mm of a fit that may lie beside the cochlea: of voxels above
/// `metalLevel` with at least two neighbors above it [mm^3].
double metalAround_mm3(const CtVolume& volume, const Pose& pose);

/// Brighter than bone of any density: the Hounsfield units above which only metal is expected.
inline constexpr std::int16_t metalLevel = 3000;
/// Ten ears have up to 0.5 of dense bone and noise, implants 8 [mm^3].
inline constexpr double minMetal_mm3 = 2.0;

}  // namespace perilymph::ct
