#pragma once

// The coarse surface that a hand is shown, beside the fine one that the eye sees.

#include "perilymph/anatomy/ScalaTympani.h"
#include "perilymph/anatomy/Surface.h"
#include "perilymph/anatomy/SurfaceDeviation.h"
#include "perilymph/foundation/Result.h"
#include "perilymph/foundation/Units.h"

namespace perilymph::imaging {

/// Share of the visual surface's triangles that the haptic one keeps: "95 % polygon reduction was
/// applied" (Todd and Naghdy, section II.C).
inline constexpr double hapticFraction = 0.05;

/// The apex, from this angle on, is not part of the haptic surface, "since the carrier will never
/// reach this point" (same section). The longest array in use, 31.5 mm, covers 74 % of the duct
/// (standard deviation 7.4 %, Breitsprecher 2021); two deviations more are 89 %, and on the spiral
/// of Cohen 90 % of the length lie before two turns (32.28 of 35.85 mm).
inline constexpr Angle hapticEnd = degrees(720.0);

/// The haptic surface of the paper, and how far it is from what it stands for.
struct HapticSurface {
  anatomy::Surface surface;  ///< Open at the opening and where the apex was [m, W].
  int visualTriangles = 0;   ///< Triangles of the whole visual surface.
  /// From the visual surface without its apex, both ways, at places at most 0.05 mm apart.
  anatomy::SurfaceDeviation surfaceDistance;
};

/// Cuts the visual surface of `maxTriangles`, takes its apex away and merges triangles by quadric
/// error until 5 % of the visual surface's are left. Takes seconds; not real-time safe.
Result<HapticSurface> hapticSurface(const anatomy::ScalaTympani& scala, int maxTriangles);

}  // namespace perilymph::imaging
