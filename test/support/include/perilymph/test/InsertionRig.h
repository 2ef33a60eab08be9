// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The headless test harness: a scripted hand and a haptic loop in virtual time, with the same
// commands and channels as the window.

#include <memory>

#include "perilymph/device/ScriptedDevice.h"
#include "perilymph/haptics/HapticLoop.h"
#include "perilymph/mechanics/InsertionModel.h"

namespace perilymph::test {

class InsertionRig {
public:
  /// Initially Idle, the hand at rest.
  ///
  /// @param speed  Of the scripted hand.
  explicit InsertionRig(std::shared_ptr<const mechanics::InsertionModel> model,
                        haptics::EngineSettings settings = {},
                        Speed speed = millimetersPerSecond(2));

  /// A rig in the toroidal duct of PlainModels.h, run until Finished: bent along the wall.
  static InsertionRig fullyInserted();

  /// Sends a command, which is taken in the next tick. @throws std::runtime_error if eight wait.
  void send(haptics::Command::Kind kind, double value = 0.0);
  /// Arms; the hand pushes from the next tick on.
  void start();

  /// Runs one tick. The record is valid until the next one.
  const haptics::TickRecord& tick();
  const haptics::TickOutput& output() const noexcept { return record_.output; }

  /// Runs until the travel is reached, at most `maxTicks` ticks. False if it was not.
  bool runUntilTravel(Length travel, int maxTicks = 1'000'000);
  /// Runs until the workflow state is reached, at most `maxTicks` ticks. False if it was not.
  bool runUntil(haptics::Workflow workflow, int maxTicks = 1'000'000);

  device::ScriptedDevice& device() noexcept { return *device_; }
  haptics::HapticLoop& loop() noexcept { return *loop_; }
  const haptics::InsertionEngine& engine() const noexcept { return loop_->engine(); }

private:
  std::unique_ptr<device::ScriptedDevice> device_;
  std::unique_ptr<haptics::HapticLoop> loop_;
  haptics::TickRecord record_;
};

}  // namespace perilymph::test
