#pragma once

// The coarse wall that a point-set hand feels, made without a mesh library: what the engine builds
// its proxies on.

#include "perilymph/anatomy/ScalaTympani.h"
#include "perilymph/anatomy/Surface.h"
#include "perilymph/foundation/Units.h"

namespace perilymph::anatomy {

/// Triangles of the visual surface that the haptic one stands beside, of this project's pictures
/// and files (the paper gives no number of its own).
inline constexpr int visualTriangles = 20'000;

/// Triangles of the haptic surface: "95 % polygon reduction was applied" (Todd and Naghdy, section
/// II.C).
inline constexpr int hapticTriangles = visualTriangles / 20;

/// The wall from the opening to two turns, at most `hapticTriangles`, open at both ends: "the apex
/// data is removed from the haptic model" (same section; where it begins is our choice, and that
/// of imaging's surface).
///
/// Rings stand where the edges between them cut off equally much; their corners lie where straight
/// edges would leave the outlines most. Corners lie on the wall, so edges cut across its hollows.
/// Not real-time safe.
Surface hapticSurface(const ScalaTympani& scala);

}  // namespace perilymph::anatomy
