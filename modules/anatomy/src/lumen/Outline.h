// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Closed outlines of sections in a half-plane through the modiolar axis.

#include <cstddef>
#include <vector>

#include "perilymph/foundation/Math.h"

namespace perilymph::anatomy {

/// A point of a half-plane through the axis: distance from it, and height [m].
struct HalfPlanePoint {
  double r, z;
};

/// Linear interpolation from a to b.
inline HalfPlanePoint mix(const HalfPlanePoint& a, const HalfPlanePoint& b, double fraction)
{
  return {a.r + fraction * (b.r - a.r), a.z + fraction * (b.z - a.z)};
}

/// Corners of a polygon, counter-clockwise.
using Outline = std::vector<HalfPlanePoint>;

/// The centroid of the outline's area.
HalfPlanePoint centroid(const Outline& outline);

/// Distance from `center` to the outline in a direction [m]; 0 if there is none.
///
/// @param near  Corner at which the search begins; set to the one before the intersection.
double radiusIn(const Outline& outline, const HalfPlanePoint& center, const SineCosine& direction,
                std::size_t& near);

/// Height of the outline's highest point at a distance from the axis [m]; that of its highest
/// corner if the outline does not extend to it.
double roofAt(const Outline& outline, double r);

}  // namespace perilymph::anatomy
