// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Passivity control: the virtual environment must not generate energy at the hand.

#include <Eigen/Core>

#include "perilymph/foundation/Hash.h"

namespace perilymph::haptics {

/// Time-domain passivity: observer and controller at the device's port (Hannaford and Ryu 2002).
///
///     E(k) = E(k-1) - f(k-1) . (x(k) - x(k-1))
///
/// is the net energy supplied by the hand; exact, because the force is held between ticks. The next
/// force is chosen so that E stays nonnegative if the hand continues its motion:
///
///     f = wanted - b v,   b = -(E - wanted . v dt) / (v . v dt)   if positive
///
/// b is bounded: a sampled damper above m / dt makes a handle of mass m oscillate.
class Passivity {
public:
  /// Upper bound of b [N.s/m]: a ninth of m / dt of the lightest handle (90 g) at 1 kHz.
  static constexpr double maxDamping = 10.0;

  /// @param timeStep  [s]
  explicit Passivity(double timeStep) : timeStep_(timeStep) {}

  /// Updates the energy for a hand displacement under the rendered force.
  void observe(const Eigen::Vector3d& shown_D, const Eigen::Vector3d& moved_D) noexcept;

  /// The force to render instead of the wanted one, for a hand that moves by `moved_D` each tick.
  Eigen::Vector3d control(const Eigen::Vector3d& wanted_D,
                          const Eigen::Vector3d& moved_D) const noexcept;

  /// Net energy supplied by the hand [J].
  double energy() const noexcept { return energy_; }

  /// Resets the energy to zero.
  void reset() noexcept { energy_ = 0.0; }

  void addTo(Hash& hash) const noexcept { hash.add(energy_); }

private:
  double timeStep_;
  double energy_ = 0.0;
};

}  // namespace perilymph::haptics
