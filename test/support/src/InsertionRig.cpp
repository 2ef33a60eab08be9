// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/test/InsertionRig.h"

#include <stdexcept>
#include <utility>

#include "perilymph/test/PlainModels.h"

namespace perilymph::test {

InsertionRig::InsertionRig(std::shared_ptr<const mechanics::InsertionModel> model,
                           haptics::EngineSettings settings, Speed speed)
    : device_(std::make_unique<device::ScriptedDevice>(speed.si(), model->timeStep))
{
  settings.samplePeriod = model->timeStep;
  loop_ = std::make_unique<haptics::HapticLoop>(
      *device_, std::make_unique<haptics::InsertionEngine>(std::move(model), settings));
}

InsertionRig InsertionRig::fullyInserted()
{
  InsertionRig rig(insertionInRing(), {}, millimetersPerSecond(10));
  rig.start();
  if (!rig.runUntil(haptics::Workflow::finished, 5000))
    throw std::runtime_error("The rig's array did not reach its stop travel in 5 s.");
  return rig;
}

void InsertionRig::send(haptics::Command::Kind kind, double value)
{
  haptics::Command command;
  command.kind = kind;
  command.value = value;
  if (!loop_->send(command)) throw std::runtime_error("Eight commands wait; tick the rig first.");
}

void InsertionRig::start()
{
  send(haptics::Command::Kind::arm);
  device_->move(device::ScriptedDevice::Motion::insert);
}

const haptics::TickRecord& InsertionRig::tick()
{
  loop_->runOnce();
  if (!loop_->take(record_)) throw std::runtime_error("A tick of the rig left no record.");
  return record_;
}

bool InsertionRig::runUntilTravel(Length travel, int maxTicks)
{
  for (int i = 0; i < maxTicks; ++i)
    if (tick().output.travel >= travel.si()) return true;
  return false;
}

bool InsertionRig::runUntil(haptics::Workflow workflow, int maxTicks)
{
  for (int i = 0; i < maxTicks; ++i)
    if (tick().output.workflow == workflow) return true;
  return false;
}

}  // namespace perilymph::test
