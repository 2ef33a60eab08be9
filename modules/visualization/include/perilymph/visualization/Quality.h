// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Rendering quality, for machines of different speed.

namespace perilymph::visualization {

/// A quality tier; see QualityTraits.
enum class Quality {
  fast,      ///< Slow CPU rendering: only what shows the position of the array.
  software,  ///< CPU rendering.
  gpu        ///< GPU rendering: the same with a finer wall.
};

/// Rendering options of a tier. In every tier translucent parts blend in the scene's own order:
/// depth peeling would tear the basilar membrane, which lies in the surface of the wall. Edges are
/// smoothed by geometry.
struct QualityTraits {
  int wallTriangles;     ///< Maximum for the scala's wall.
  bool hasSilhouettes;   ///< Contour lines of the wall; its rims are always drawn.
  bool hasShadow;        ///< The array casts a shadow on the wall.
  int frameInterval_ms;  ///< Minimum interval between frames.
};

constexpr QualityTraits traitsOf(Quality quality)
{
  switch (quality) {
    case Quality::fast:
      return {4000, false, false, 33};
    case Quality::software:
      break;
    case Quality::gpu:
      return {40000, true, true, 16};
  }
  return {12000, true, true, 16};
}

}  // namespace perilymph::visualization
