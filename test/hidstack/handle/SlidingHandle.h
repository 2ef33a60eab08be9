// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Simulation of the mass of a handle and the hand that pushes it: one-dimensional, exact in time.

namespace perilymph::hidstack {

/// Parameters of the handle.
struct HandleBody {
  double mass = 0.090;     ///< [kg]
  double damping = 0.5;    ///< Damping of its bearings [N.s/m].
  double reach = 80e-3;    ///< Position of the end stops, on both sides of zero [m].
  double watchdog = 0.02;  ///< A force not renewed for this long is switched off [s].
};

/// A handle on a rail under the force of a hand and that of the last output report:
///
///     m dv/dt = push + force - b v
///
/// Between two changes of the force the solution is known in closed form, so a step may have any
/// length. Positive is toward the cochlea.
class SlidingHandle {
public:
  explicit SlidingHandle(const HandleBody& body) : body_(body) {}

  /// Advances to `time` [s]; earlier times are ignored.
  void advanceTo(double time);

  /// Sets the force of the hand [N].
  void push(double force) { push_ = force; }
  /// The hand holds the handle, or lets it slide.
  void hold(bool isHeld);
  /// Puts the handle to a position [m], at rest.
  void put(double position);
  /// Sets the actuator's force [N]: from an output report, or zero after a disconnection.
  void actuate(double force);

  double position() const { return position_; }
  double velocity() const { return velocity_; }
  /// Current force of the actuator [N].
  double force() const { return force_; }
  /// The watchdog switched off a force that was not renewed.
  bool hasTimedOut() const { return hasTimedOut_; }

private:
  void slide(double duration);

  HandleBody body_;
  double time_ = 0.0;         // [s]
  double lastCommand_ = 0.0;  // time of the last force command [s]
  double position_ = 0.0;     // [m]
  double velocity_ = 0.0;     // [m/s]
  double push_ = 0.0;         // [N]
  double force_ = 0.0;        // [N]
  bool isHeld_ = true;
  bool hasTimedOut_ = false;
};

}  // namespace perilymph::hidstack
