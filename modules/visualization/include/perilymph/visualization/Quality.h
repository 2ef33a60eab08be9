#pragma once

// How much of the picture is drawn, for machines of different speed.

namespace perilymph::visualization {

/// A tier. What it switches is in QualityTraits.
enum class Quality {
  fast,      ///< A slow CPU draws: what shows where the array is, and no more.
  software,  ///< A CPU draws: ordered translucency, edges smoothed by geometry.
  gpu        ///< A graphics card draws.
};

/// What a tier draws, and how often.
struct QualityTraits {
  int wallTriangles;    ///< At most, of the scala's wall.
  bool hasSilhouettes;  ///< Lines where the wall turns away; its rims are always drawn.
  bool hasShadow;       ///< The array casts a shadow on the wall.
  int peels;            ///< Layers of translucency sorted at every pixel; 0: by the order of parts.
  bool isSmoothed;      ///< Edges smoothed over the whole picture (FXAA).
  int frameInterval_ms;  ///< Between frames at least.
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
