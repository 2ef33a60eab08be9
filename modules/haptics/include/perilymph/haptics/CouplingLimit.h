// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Stiffness and damping that a device can render stably.

#include <limits>
#include <string>

#include "perilymph/device/HapticDevice.h"

namespace perilymph::haptics {

/// Maximum stiffness and damping of the coupling at the hand.
struct CouplingLimit {
  double stiffness = std::numeric_limits<double>::infinity();  ///< [N/m]
  double damping = std::numeric_limits<double>::infinity();    ///< [N.s/m]
  std::string reason;  ///< What limits the stiffness, as part of a sentence; empty if unlimited.
};

/// Whether a device sends one report per tick by its own clock, within 10 %, so that reports may
/// trigger the ticks.
bool followsReports(const device::DeviceTraits& traits, double timeStep) noexcept;

/// The limit of a device; infinite if it renders no force.
///
///     late = T/2 + td           td: delay to the device and back, plus half a report period if
///                               reports do not trigger the ticks
///     K <= 3/4 b / late         a spring alone of K <= b / late is passive (Colgate and Schenkel
///                               1997) but lets an oscillation persist; a quarter of the damping
///                               remains to damp it
///     B <= m / (e (late + lag)) above this a delayed damper makes a mass m oscillate: the first
///                               roots of s + (B/m) exp(-s late) = 0 become complex; lag is the
///                               smoothing of the hand's velocity (SampleValidator)
///
/// b is the handle's own damping and m its mass; if unknown, those of a light handle are assumed
/// (0.5 N.s/m, 90 g). The maker's limits of stiffness and damping apply as well. Within the limits spring
/// and damper together are stable in a hand of any mass from m; passive they are only in a handle that is
/// damped by passiveHandleDamping(): what else they would give back, Passivity takes away.
///
/// @param traits    Of the open device, with its measured delay.
/// @param timeStep  Of the loop [s].
CouplingLimit couplingLimit(const device::DeviceTraits& traits, double timeStep);

/// Damping that a handle needs so that spring and damper of the coupling give no energy back at any
/// frequency [N.s/m]:
///
///     b >= T/2 / (1 - cos wT) Re[(1 - 1/z) (K + B F (1 - 1/z) / T) exp(-i w delay)],   z = exp(i w T)
///
/// for all w up to pi/T (Colgate and Schenkel 1997), with F the smoothing of the hand's velocity. Without
/// delay and smoothing it is K T/2 + B.
///
/// @param stiffness  K, at the hand [N/m].
/// @param damping    B, at the hand [N.s/m].
/// @param delay      Of a force to the device and back, beyond the half step that it is held [s].
/// @param timeStep   T, of the loop [s].
double passiveHandleDamping(double stiffness, double damping, double delay, double timeStep);

/// The delay of a device's forces beyond half a step: that of its transport and the wait for a tick [s].
double delayOf(const device::DeviceTraits& traits, double timeStep) noexcept;

/// A message about the limit: requested and applied stiffness, and the reason. Empty if not
/// limited.
///
/// @param asked  Stiffness of the scenario at the hand, including scales [N/m].
std::string couplingSentence(double asked, const CouplingLimit& limit, const std::string& device);

}  // namespace perilymph::haptics
