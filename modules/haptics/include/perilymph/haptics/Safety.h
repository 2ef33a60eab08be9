#pragma once

// What stands between the physics and a hand: a force is clamped, slewed, watched, and goes to zero
// on any doubt.

#include <cstdint>

#include "perilymph/device/HapticDevice.h"
#include "perilymph/foundation/RealTime.h"

namespace perilymph::haptics {

struct SafetyLimits {
  double mostForce = 3.3;    ///< Of the shown force's magnitude [N]; lower of this and the device's.
  double mostSlew = 100.0;   ///< Of the shown force [N/s].
  double rampTime = 0.5;     ///< Over which the force fades in after a pause or a fault [s].
};

}  // namespace perilymph::haptics
