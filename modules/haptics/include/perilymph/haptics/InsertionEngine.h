// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The tick, independent of threads: sample and commands in, wrench and snapshot out. Replay of a
// recording uses the same function.

#include <limits>
#include <memory>
#include <optional>

#include "perilymph/device/HapticDevice.h"
#include "perilymph/haptics/EndDetector.h"
#include "perilymph/haptics/Registration.h"
#include "perilymph/haptics/Rest.h"
#include "perilymph/haptics/Safety.h"
#include "perilymph/haptics/SampleValidator.h"
#include "perilymph/haptics/Snapshot.h"
#include "perilymph/haptics/StyletMotion.h"
#include "perilymph/haptics/WorkflowEvent.h"
#include "perilymph/mechanics/InsertionModel.h"
#include "perilymph/mechanics/InsertionState.h"
#include "perilymph/mechanics/advance.h"

namespace perilymph::haptics {

/// Constant settings of the engine.
struct EngineSettings {
  mechanics::Coupling coupling = mechanics::Coupling::rigid;
  /// That of the wall in the published simulator [N/m].
  double couplingStiffness = mechanics::WallLaw{}.perSamplePoint.si();
  double couplingDamping = 1.0;  ///< [N.s/m]
  /// Maximum that the device can render at the hand (CouplingLimit). The coupling is reduced to it,
  /// taking force and motion scales into account.
  double maxStiffness = std::numeric_limits<double>::infinity();  ///< [N/m]
  double maxDamping = std::numeric_limits<double>::infinity();    ///< [N.s/m]
  double stopTravel = 16.5e-3;  ///< Travel at which an insertion is Finished [m].
  double stopForce = 0.0;       ///< Axial force at which the surgeon stops [N]; 0: none.
  /// The hand pushes along the axis of the opening, whatever the approach of the array: a clamped
  /// array on the crosshead of a tester. Otherwise it pushes along the approach.
  bool pushesAlongOpening = false;
  double forceScale = 1.0;    ///< Rendered force over physical force.
  double motionScale = 1.0;   ///< Motion of the base over motion of the hand.
  double styletSpeed = 5e-3;  ///< Speed of the stylet while it is pulled [m/s].
  /// Advance off-stylet: depth of the stylet's tip past the opening from which it is held still
  /// [m].
  std::optional<double> styletHoldDepth;
  double samplePeriod = 1e-3;  ///< Nominal report period of the device [s].
  /// Time without motion after which the insertion rests [s]; infinite: it never rests.
  double restAfter = std::numeric_limits<double>::infinity();
  /// RestLimits::motion [m].
  double restMotion = 0.0;
  /// RestLimits::handMotion [m].
  double restHandMotion = 0.0;
  SafetyLimits safety;
};

/// One insertion: workflow, registration, coupling, mechanics and safety. No thread, no clock, no
/// file. Used by one thread at a time.
///
/// In the state Inserting the base follows the hand; in every other state it is held. In Idle the
/// mechanics is suspended, in every other state time advances. At the stop travel the base stops
/// and the insertion is Finished; because travel is measured along a bending array, it may exceed
/// the limit by about ten nanometers. After `withdraw` (from Finished, Inserting or Paused) the
/// stop no longer applies, and the insertion is Finished again when the tip is back at its initial
/// depth. The base never passes the bone around the opening. An event of InsertionEnd.h, such as
/// buckling, ends the insertion early: it is Finished where it is, TickOutput::status states why, and
/// except after a stop by resistance no force is rendered any more. After `stop` no hand grasps and no force is rendered, whatever the state, until `resume`.
///
/// The insertion rests when nothing moves and no force is rendered for `restAfter`, and from the
/// beginning until the hand grasps: its state and its time stand still (Status::resting) until a
/// command, a grasp, or the loss of the device. At full depth and while it inserts it also rests
/// while the hand holds the device still, with the force of the tick before, until the hand
/// releases or moves it. What ends a
/// rest is decided by the current sample and commands alone, so that a replay without the ticks of
/// the rest gives the same bits.
class InsertionEngine {
public:
  /// @throws std::invalid_argument with a message for settings out of range.
  InsertionEngine(std::shared_ptr<const mechanics::InsertionModel> model, EngineSettings settings);

  /// Computes one time step. Real-time safe.
  TickOutput tick(const device::DeviceSample& sample, const CommandList& commands) noexcept;

  /// Whether the insertion rests while the hand holds the device: its force stays.
  bool isHeldAtRest() const noexcept { return rest_.isHeld(); }

  /// Fills the snapshot of the last tick, except for the loop's own statistics. After an overflow
  /// of the mechanics the shape in the snapshot is left unchanged. Real-time safe.
  void fill(Snapshot& snapshot) const noexcept;

  /// Limits the maximum rendered force to that of a device [N]; before the first tick.
  void lowerMaxForce(double maxForce) noexcept { safety_.lowerMaxForce(maxForce); }

  Workflow workflow() const noexcept { return workflow_; }
  /// Stiffness of the coupling spring, reduced for the device [N/m].
  double couplingStiffness() const noexcept;
  const EngineSettings& settings() const noexcept { return settings_; }
  const SafetyLimits& safetyLimits() const noexcept { return safety_.limits(); }
  const mechanics::InsertionModel& model() const noexcept { return *model_; }
  const mechanics::InsertionState& state() const noexcept { return state_; }
  /// Fingerprint of all data that the next tick depends on.
  std::uint64_t fingerprint() const noexcept;

private:
  void applyCommand(const Command& command) noexcept;
  void transition(WorkflowEvent event) noexcept;
  void startWithdrawing() noexcept;
  void stop() noexcept;
  bool endsRest(const device::DeviceSample& sample, const CommandList& commands) noexcept;
  void stayAtRest() noexcept;
  void noteRest(const HandState& hand) noexcept;
  void validate(const HandState& hand, std::uint32_t& status) noexcept;
  HandCondition conditionOf(const HandState& hand) const noexcept;
  void moveMechanics(const HandState& hand) noexcept;
  mechanics::Drive hold() const noexcept;
  double softened(double asked, double maximum) const noexcept;
  mechanics::Drive follow(const HandState& hand) noexcept;
  void noteEnd() noexcept;
  void noteArrival() noexcept;
  double travel() const noexcept;
  bool isFinite() const noexcept;
  void updateOutput() noexcept;

  std::shared_ptr<const mechanics::InsertionModel> model_;
  EngineSettings settings_;
  mechanics::InsertionState state_;
  Workflow workflow_ = Workflow::idle;
  SampleValidator validator_;
  Registration registration_;
  Safety safety_;
  double startDepth_;  // of the tip [m]
  BasePose base_;      // last pose given to the mechanics
  StyletMotion stylet_;
  EndDetector detector_;
  InsertionEnd end_ = InsertionEnd::none;  // the event that ended the insertion
  bool needsAnchor_ = true;                // the hand takes a new anchor
  bool isWithdrawing_ = false;             // the stop travel no longer applies
  bool isWithdrawn_ = false;               // back at the initial depth
  bool isStopped_ = false;                 // by the user
  bool hasBegun_ = false;                  // there was a tick in Inserting
  Rest rest_;
  std::uint64_t ticks_ = 0;  // of this engine
  std::uint64_t ticksSinceBegin_ = 0;
  PeakForce peak_;
  TickOutput output_;  // of the last tick; values remain after an overflow
};

}  // namespace perilymph::haptics
