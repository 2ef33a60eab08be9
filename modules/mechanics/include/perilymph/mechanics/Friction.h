#pragma once

// Stick and slip of the array on the wall.

#include "perilymph/foundation/Units.h"

namespace perilymph::mechanics {

/// Coefficients of dry friction: sticks up to `starting`, slides at `dynamic`, sticks again below
/// `stopping`. The published pair is silicone on Teflon under soap (Todd and Naghdy, section II.C).
struct FrictionLaw {
  double starting = 0.0605;  ///< Of the normal force, at which a resting node starts to slide.
  double dynamic = 0.0395;   ///< While it slides.
  double stopping = 0.0185;  ///< Below which a sliding node rests again (an estimate of the paper).
  Speed stribeck = millimetersPerSecond(0.1);  ///< Over which starting falls to dynamic.
};

}  // namespace perilymph::mechanics
