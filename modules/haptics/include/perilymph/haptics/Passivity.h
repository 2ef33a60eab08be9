#pragma once

// Nothing virtual may push a hand with energy it was not given.

#include <Eigen/Core>

#include "perilymph/foundation/Hash.h"
#include "perilymph/foundation/RealTime.h"

namespace perilymph::haptics {

/// Time-domain passivity: observer and controller at the device's port (Hannaford and Ryu 2002).
///
///     E(k) = E(k-1) - f(k-1) . (x(k) - x(k-1))
///
/// is what the hand put in and has not got back: exact, because the force is held between ticks.
/// The next force is chosen so that E stays at or above zero if the hand goes on as it does:
///
///     f = wanted - b v,   b = -(E - wanted . v dt) / (v . v dt)   where that is above 0
///
/// b is bounded: a sampled damper above m / dt shakes a handle of mass m by itself.
class Passivity {
public:
  /// Bound of b [N.s/m]: a ninth of m / dt of the lightest handle (90 g) at 1 kHz.
  static constexpr double maxDamping = 10.0;

  /// @param timeStep  [s]
  explicit Passivity(double timeStep) : timeStep_(timeStep) {}

  /// Accounts for a hand that moved while a force was shown to it.
  PERILYMPH_REALTIME void observe(const Eigen::Vector3d& shown_D,
                                  const Eigen::Vector3d& moved_D) noexcept;

  /// The force to show in place of the wanted one to a hand that moves by so much each tick.
  PERILYMPH_REALTIME Eigen::Vector3d control(const Eigen::Vector3d& wanted_D,
                                             const Eigen::Vector3d& moved_D) const noexcept;

  /// What the hand put in and has not got back [J].
  double energy() const noexcept { return energy_; }

  /// Forgets the past.
  PERILYMPH_REALTIME void reset() noexcept { energy_ = 0.0; }

  void addTo(Hash& hash) const noexcept { hash.add(energy_); }

private:
  double timeStep_;
  double energy_ = 0.0;
};

}  // namespace perilymph::haptics
