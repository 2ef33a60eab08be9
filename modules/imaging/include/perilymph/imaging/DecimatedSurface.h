// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The coarse haptic surface derived from the fine visual one.

#include "perilymph/anatomy/ScalaTympani.h"
#include "perilymph/anatomy/Surface.h"
#include "perilymph/anatomy/SurfaceDeviation.h"
#include "perilymph/foundation/Result.h"
#include "perilymph/foundation/Units.h"

namespace perilymph::imaging {

/// Fraction of the visual surface's triangles in the haptic one: "95 % polygon reduction was
/// applied" (Todd and Naghdy, section II.C).
inline constexpr double hapticFraction = 0.05;

/// Angle at which the haptic surface ends: the apex is removed "since the carrier will never reach
/// this point" (same section). The longest array in use, 31.5 mm, covers 74 % of the duct (standard
/// deviation 7.4 %, Breitsprecher 2021); plus two deviations this is 89 %, and on Cohen's spiral 90
/// % of the length lies before two turns (32.28 of 35.85 mm).
inline constexpr Angle hapticEnd = degrees(720.0);

/// The haptic surface of the paper, and its distance from the visual one.
struct HapticSurface {
  anatomy::Surface surface;  ///< Open at the opening and at the removed apex [m, W].
  int visualTriangles = 0;   ///< Triangles of the whole visual surface.
  /// Distance from the visual surface without its apex, both ways, at points at most 0.05 mm apart.
  anatomy::SurfaceDeviation surfaceDistance;
};

/// Computes the visual surface of `maxTriangles`, removes its apex and decimates it by quadric
/// error to 5 % of the visual surface's triangles. Takes seconds; not real-time safe.
Result<HapticSurface> hapticSurface(const anatomy::ScalaTympani& scala, int maxTriangles);

}  // namespace perilymph::imaging
