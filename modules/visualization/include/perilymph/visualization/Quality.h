// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Rendering quality, for machines of different speed.

namespace perilymph::visualization {

/// A quality tier; see QualityTraits.
enum class Quality {
  fast,      ///< Slow CPU rendering: only what shows the position of the array.
  software,  ///< CPU rendering: ordered translucency, edges smoothed by geometry.
  gpu        ///< GPU rendering.
};

/// Rendering options of a tier.
struct QualityTraits {
  int wallTriangles;     ///< Maximum for the scala's wall.
  bool hasSilhouettes;   ///< Contour lines of the wall; its rims are always drawn.
  bool hasShadow;        ///< The array casts a shadow on the wall.
  int peels;             ///< Number of depth peels; 0: translucent parts in fixed order.
  bool isSmoothed;       ///< Full-screen antialiasing (FXAA).
  int frameInterval_ms;  ///< Minimum interval between frames.
};

constexpr QualityTraits traitsOf(Quality quality)
{
  switch (quality) {
    case Quality::fast:
      return {4000, false, false, 0, false, 40};
    case Quality::software:
      break;
    case Quality::gpu:
      return {40000, true, true, 8, true, 16};
  }
  return {12000, true, true, 0, false, 16};
}

}  // namespace perilymph::visualization
