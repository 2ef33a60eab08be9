// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Stick-slip friction of the array on the wall.

#include <algorithm>

#include "perilymph/foundation/Units.h"
#include "perilymph/mechanics/FrictionBySpeed.h"

namespace perilymph::mechanics {

/// Coefficients of dry friction. The published values are silicone on Teflon under soap (Todd and
/// Naghdy, section II.C).
///
/// A resting node starts to slide when the tangential force exceeds `staticCoefficient` times the
/// normal force. While it slides, the coefficient depends on its speed v and the Stribeck speed
/// v_s:
///
///     mu(v) = kinetic + (static - kinetic) / (1 + (v / v_s)^2)
///
/// It sticks again when the tangential force has fallen below `stoppingCoefficient` times the
/// normal force. If `bySpeed` has points, it replaces this curve.
struct FrictionLaw {
  double staticCoefficient = 0.0605;   ///< Measured (published, confidence high).
  double kineticCoefficient = 0.0395;  ///< Measured (published, confidence high).
  double stoppingCoefficient =
      0.0185;  ///< Estimated by the paper; its meaning here is our interpretation (medium).
  Speed stribeck = millimetersPerSecond(0.1);  ///< v_s: an engineering choice (low).
  FrictionBySpeed bySpeed = {};                ///< Empty: the curve above.

  /// Kinetic coefficient at a sliding speed [m/s]. Real-time safe.
  double sliding(double speed) const noexcept
  {
    if (!bySpeed.isEmpty()) return bySpeed.at(speed);
    const double fast = speed / stribeck.si();
    return kineticCoefficient + (staticCoefficient - kineticCoefficient) / (1.0 + fast * fast);
  }

  /// How much the kinetic coefficient rises with the speed [s/m]; 0 where it falls. Real-time safe.
  double rise(double speed) const noexcept
  {
    return bySpeed.isEmpty() ? 0.0 : std::max(bySpeed.slopeAt(speed), 0.0);
  }

  /// All coefficients times a factor of 0 or more, reduced where one would exceed the maximum of 2.
  FrictionLaw scaled(double factor) const noexcept
  {
    const double highest = std::max(staticCoefficient, bySpeed.isEmpty() ? 0.0 : bySpeed.maximum());
    const double allowed = std::min(factor, 2.0 / std::max(highest, 1e-9));
    FrictionLaw law = *this;
    law.staticCoefficient *= allowed;
    law.kineticCoefficient *= allowed;
    law.stoppingCoefficient *= allowed;
    law.bySpeed = bySpeed.scaled(allowed);
    return law;
  }
};

}  // namespace perilymph::mechanics
