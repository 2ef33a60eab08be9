#pragma once

// The tick without its thread: sample and commands in, wrench and pictures out. A recording replays
// through the very same function.

#include <memory>

#include "perilymph/device/HapticDevice.h"
#include "perilymph/foundation/RealTime.h"
#include "perilymph/haptics/Safety.h"
#include "perilymph/haptics/Snapshot.h"
#include "perilymph/mechanics/InsertionModel.h"
#include "perilymph/mechanics/InsertionState.h"

namespace perilymph::haptics {

/// What the engine is told once.
struct EngineSettings {
  mechanics::Coupling coupling = mechanics::Coupling::rigid;
  double couplingStiffness = 441.0;  ///< [N/m]; of the wall in the published simulator.
  double couplingDamping = 1.0;      ///< [N.s/m]
  double stopTravel = 16.5e-3;       ///< Where an insertion is Finished [m].
  double forceScale = 1.0;           ///< Shown force over physical force.
  double motionScale = 1.0;          ///< Motion of the base over motion of the hand.
  double styletSpeed = 5e-3;         ///< Of the stylet when it is pulled [m/s].
  double samplePeriod = 1e-3;        ///< Nominal, of the device [s].
  SafetyLimits safety;
};

/// One insertion: workflow, registration, coupling, mechanics and safety. No thread, no clock, no
/// file. Owned by whoever ticks it.
class InsertionEngine {
public:
  InsertionEngine(std::shared_ptr<const mechanics::InsertionModel> model, EngineSettings settings);

  /// One time step. Real-time safe.
  PERILYMPH_REALTIME TickOutput tick(const device::DeviceSample& sample,
                                     const CommandList& commands) noexcept;

  /// Fills the picture of the last tick (all but the loop's own figures). Real-time safe.
  PERILYMPH_REALTIME void fill(Snapshot& snapshot) const noexcept;

  Workflow workflow() const noexcept { return workflow_; }
  const mechanics::InsertionModel& model() const noexcept { return *model_; }
  const mechanics::InsertionState& state() const noexcept { return state_; }
  /// Of everything the next tick depends on.
  std::uint64_t fingerprint() const noexcept;

private:
  std::shared_ptr<const mechanics::InsertionModel> model_;
  EngineSettings settings_;
  mechanics::InsertionState state_;
  Workflow workflow_ = Workflow::idle;
};

}  // namespace perilymph::haptics
