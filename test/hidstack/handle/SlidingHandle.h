// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The mass a device's handle is, and the hand that pushes it: one dimension, exact in time.

namespace perilymph::hidstack {

/// Parameters of the handle.
struct HandleBody {
  double mass = 0.090;     ///< [kg]
  double damping = 0.5;    ///< Damping of its bearings [N.s/m].
  double reach = 80e-3;    ///< Where it meets its end stops, on both sides of zero [m].
  double watchdog = 0.02;  ///< A force not renewed for this long is switched off [s].
};

/// A handle on a rail under the push of a hand and the force of the last output report:
///
///     m dv/dt = push + force - b v
///
/// Between two changes of the force the solution is known in closed form, so a step may be as long
/// as it likes. Positive is toward the cochlea.
class SlidingHandle {
public:
  explicit SlidingHandle(const HandleBody& body) : body_(body) {}

  /// Moves on to `time` [s]; the past stays as it is.
  void advanceTo(double time);

  /// Sets the force of the hand [N].
  void push(double force) { push_ = force; }
  /// Somebody holds the handle still, or lets it slide.
  void hold(bool isHeld);
  /// Somebody puts it to a place [m] and lets it rest there.
  void put(double position);
  /// The actuator's force from now on [N]: what an output report says, or none after an unplug.
  void actuate(double force);

  double position() const { return position_; }
  double velocity() const { return velocity_; }
  /// Force of the actuator now [N].
  double force() const { return force_; }
  /// The watchdog switched a force off that was not renewed.
  bool hasTimedOut() const { return hasTimedOut_; }

private:
  void slide(double duration);

  HandleBody body_;
  double time_ = 0.0;         // [s]
  double lastCommand_ = 0.0;  // when the force was last told [s]
  double position_ = 0.0;     // [m]
  double velocity_ = 0.0;     // [m/s]
  double push_ = 0.0;         // [N]
  double force_ = 0.0;        // [N]
  bool isHeld_ = true;
  bool hasTimedOut_ = false;
};

}  // namespace perilymph::hidstack
