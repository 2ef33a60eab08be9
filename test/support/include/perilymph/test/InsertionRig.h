#pragma once

// The headless harness: a scripted hand and a haptic loop in virtual time, with the same commands
// and channels the window uses.

#include <memory>

#include "perilymph/device/ScriptedDevice.h"
#include "perilymph/haptics/HapticLoop.h"
#include "perilymph/mechanics/InsertionModel.h"

namespace perilymph::test {

class InsertionRig {
public:
  /// Idle, the hand at rest.
  ///
  /// @param speed  Of the scripted hand.
  explicit InsertionRig(std::shared_ptr<const mechanics::InsertionModel> model,
                        haptics::EngineSettings settings = {},
                        Speed speed = millimetersPerSecond(2));

  /// A rig in the ring-shaped duct of PlainModels.h, run until Finished: bent along the wall.
  static InsertionRig fullyInserted();

  /// Sends a command; it is taken in the next tick. @throws std::runtime_error if eight wait.
  void send(haptics::Command::Kind kind, double value = 0.0);
  /// Arms and lets the hand push from the next tick on.
  void start();

  /// One tick. The record stays valid until the next one.
  const haptics::TickRecord& tick();
  const haptics::TickOutput& output() const noexcept { return record_.output; }

  /// Ticks until the travel is reached, at most `maxTicks` times. False if it was not.
  bool runUntilTravel(Length travel, int maxTicks = 1'000'000);
  /// Ticks until the workflow is reached, at most `maxTicks` times. False if it was not.
  bool runUntil(haptics::Workflow workflow, int maxTicks = 1'000'000);

  device::ScriptedDevice& hand() noexcept { return *hand_; }
  haptics::HapticLoop& loop() noexcept { return *loop_; }
  const haptics::InsertionEngine& engine() const noexcept { return loop_->engine(); }

private:
  std::unique_ptr<device::ScriptedDevice> hand_;
  std::unique_ptr<haptics::HapticLoop> loop_;
  haptics::TickRecord record_;
};

}  // namespace perilymph::test
