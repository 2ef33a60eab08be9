// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The coarse wall with which the proxies of a point-set model collide, built without a mesh
// library.

#include "perilymph/anatomy/ScalaTympani.h"
#include "perilymph/anatomy/Surface.h"
#include "perilymph/foundation/Units.h"

namespace perilymph::anatomy {

/// Triangles of the visual surface to which the haptic one is related, in pictures and files of
/// this project (the paper gives no number).
inline constexpr int visualTriangles = 20'000;

/// Triangles of the haptic surface: "95 % polygon reduction was applied" (Todd and Naghdy, section
/// II.C).
inline constexpr int hapticTriangles = visualTriangles / 20;

/// The wall from the opening to two turns, at most `hapticTriangles`, open at both ends: "the apex
/// data is removed from the haptic model" (same section; the limit of two turns is our choice, as
/// for the surface in imaging).
///
/// Rings are placed so that the edges between them have equal chord errors; corners are placed
/// where straight edges would deviate most from the outlines. Corners lie on the wall, so edges cut
/// across its hollows. Not real-time safe.
Surface hapticSurface(const ScalaTympani& scala);

}  // namespace perilymph::anatomy
