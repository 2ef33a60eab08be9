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

/// Whether a device sends one report a tick by its own clock, within 10 %, so that reports may
/// begin the ticks.
bool followsReports(const device::DeviceTraits& traits, double timeStep) noexcept;

/// The limit of a device; none for a hand that feels no force.
///
///     late = T/2 + td           td: to the device and back, and half a period of its reports
///                               where they do not begin the ticks
///     K <= 3/4 b / late         K <= b / late is passive (Colgate and Schenkel 1997) but lets an
///                               oscillation go on; a quarter of the damping is left to end it
///     B <= m / (e (late + lag)) a damper that acts late lets a mass m swing beyond this: the first
///                               roots of s + (B/m) exp(-s late) = 0 become complex; lag is the
///                               smoothing of the hand's speed (SampleValidator)
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
