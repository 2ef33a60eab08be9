// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The scalable model of Clark, Warren and Abbott (2011) on the template spiral of Cohen (1996).

#include <memory>

#include "perilymph/anatomy/ScalaTympani.h"
#include "perilymph/foundation/Result.h"
#include "perilymph/foundation/Units.h"

namespace perilymph::anatomy {

/// A point of the template spiral, in a half-plane through the modiolar axis.
struct SpiralPoint {
  double radius;  ///< Distance from the axis [m].
  double height;  ///< Height along the axis [m], 0 at the round window.
};

/// The template spiral as a function of its own angle, 6.8 to 910.3 degrees; the round window is at
/// 10.3.
SpiralPoint clarkSpiral(Angle spiral);

/// Offset from the spiral to the center of the section, inward and down, as a function of the
/// spiral's own angle (Leon et al. 2014, Table 3).
SpiralPoint medialShift(Angle spiral);

/// Clark's scala tympani: section centers on the template spiral, shifted medially; sections of the
/// mean scala tympani at the same angle; a straight lead-in before the round window. Not real-time
/// safe.
Result<std::shared_ptr<const ScalaTympani>> buildClark(Length leadIn);

}  // namespace perilymph::anatomy
