#pragma once

// Stick and slip of the array on the wall.

#include "perilymph/foundation/Units.h"
#include "perilymph/mechanics/FrictionBySpeed.h"

namespace perilymph::mechanics {

/// Coefficients of dry friction. The published values are silicone on Teflon under soap (Todd and
/// Naghdy, section II.C).
///
/// A resting node starts to slide when the tangential force exceeds `staticCoefficient` times the normal
/// force. While it slides, the coefficient falls with its speed v over the Stribeck speed v_s:
///
///     mu(v) = dynamic + (starting - dynamic) / (1 + (v / v_s)^2)
///
/// and it rests again once the tangential force has fallen below `stoppingCoefficient` times the normal force.
/// Where friction rises with speed, or rises and falls, `bySpeed` takes the place of this curve.
struct FrictionLaw {
  double staticCoefficient = 0.0605;   ///< Measured (published, confidence high).
  double kineticCoefficient = 0.0395;  ///< Measured (published, confidence high).
  double stoppingCoefficient =
      0.0185;  ///< Estimated by the paper; its meaning here is our reading (medium).
  Speed stribeck = millimetersPerSecond(0.1);  ///< v_s: an engineering choice (low).
  FrictionBySpeed bySpeed = {};                ///< Empty: the curve above.

  /// The coefficient of a sliding node by its speed [m/s]. Real-time safe.
  double sliding(double speed) const noexcept
  {
    if (!bySpeed.isEmpty()) return bySpeed.at(speed);
    const double fast = speed / stribeck.si();
    return kineticCoefficient + (staticCoefficient - kineticCoefficient) / (1.0 + fast * fast);
  }
};

}  // namespace perilymph::mechanics
