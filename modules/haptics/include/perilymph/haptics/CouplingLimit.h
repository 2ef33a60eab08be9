#pragma once

// What a device can render of a virtual spring without trembling.

#include <limits>
#include <string>

#include "perilymph/device/HapticDevice.h"

namespace perilymph::haptics {

/// The stiffest spring and the strongest damper at the hand.
struct CouplingLimit {
  double stiffness = std::numeric_limits<double>::infinity();  ///< [N/m]
  double damping = std::numeric_limits<double>::infinity();    ///< [N.s/m]
  std::string reason;  ///< What sets the stiffness, as words for a sentence; empty without limit.
};

/// The limit of a device; none for a hand that feels no force.
///
///     K <= b / (T/2 + td)      passive for any hand: Colgate and Schenkel (1997), with the delay
///     td
///                              of the way to the device and back added to the half period
///     B <= m / (e tau)         a damper that acts tau late lets a mass m swing beyond this: of the
///                              roots of s + (B/m) exp(-s tau) = 0 the first pair becomes complex
///     tau = T/2 + td + 2 ms    with the smoothing of the hand's speed (SampleWatch)
///
/// b is the handle's own damping and m its mass; where nobody knows them, those of a light handle
/// stand in (0.5 N.s/m, 90 g). The maker's own bounds of stiffness and damping hold besides.
///
/// @param traits    Of the open device: with its measured delay.
/// @param timeStep  Of the loop [s].
CouplingLimit couplingLimit(const device::DeviceTraits& traits, double timeStep);

/// The sentence for people: what was asked, what is given, why. Empty if all is given.
///
/// @param asked  Stiffness of the scenario at the hand, scales included [N/m].
std::string couplingSentence(double asked, const CouplingLimit& limit, const std::string& device);

}  // namespace perilymph::haptics
