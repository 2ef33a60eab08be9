// SPDX-License-Identifier: BSD-3-Clause

// Fuzzes the replay with any bytes as the record of a tick.

#include <cmath>

#include "FuzzTarget.h"
#include "lumen/PlainLumens.h"
#include "perilymph/haptics/InsertionEngine.h"
#include "recording/TickBlob.h"

namespace perilymph::fuzz {

namespace {

/// A round array in a ring-shaped duct.
std::shared_ptr<const mechanics::InsertionModel> modelInRing()
{
  mechanics::ModelParts parts;
  parts.lumen = std::make_shared<anatomy::CircularDuct>(0.6e-3, 4e-3, 3e-3);
  parts.array.name = "Plain array";
  parts.array.length = millimeters(22);
  parts.array.insertable = millimeters(20);
  parts.array.diameter = {{millimeters(0)}, {millimeters(0.5)}};
  parts.array.bending = {{millimeters(0)}, {newtonSquareMeters(1e-6)}};
  parts.array.restCurvature = {{millimeters(0)}, {perMillimeter(0)}};
  parts.nodes = 16;
  parts.startInside = millimeters(2);
  return mechanics::InsertionModel::build(std::move(parts));
}

haptics::EngineSettings settings()
{
  haptics::EngineSettings settings;
  settings.coupling = mechanics::Coupling::spring;
  settings.safety.maxForce = 2.0;
  return settings;
}

/// Any recorded hand and commands give a force within its limit.
void replay(const haptics::TickRecord& record)
{
  static const auto model = modelInRing();
  haptics::InsertionEngine engine(model, settings());
  haptics::TickRecord tick = record;
  for (int i = 0; i < 4; ++i) {
    const haptics::TickOutput output = engine.tick(tick.sample, tick.commands);
    double squared = 0.0;
    for (const double part : output.wrench_D.force_D) squared += part * part;
    promise(std::sqrt(squared) <= 2.0 * (1.0 + 1e-12), "a force within its limit");
    ++tick.sample.sequence;
  }
}

Bytes bytesOf(const haptics::TickRecord& record)
{
  std::vector<unsigned char> bytes;
  session::writeTick(record, bytes);
  return bytes;
}

}  // namespace

std::vector<Bytes> seeds()
{
  haptics::TickRecord quiet;
  haptics::TickRecord held;
  held.tick = 41;
  held.sample.sequence = 41;
  held.sample.position_D = {1e-3, -2e-3, 3e-3};
  held.sample.buttons = device::graspButton;
  held.sample.isValid = 1;
  held.commands.count = haptics::maxCommandsPerTick;
  for (std::uint32_t i = 0; i < held.commands.count; ++i) {
    held.commands.items[i].kind = static_cast<haptics::Command::Kind>(i);
    held.commands.items[i].value = 0.5;
  }
  haptics::TickRecord armed = held;
  armed.commands.count = 1;
  armed.commands.items[0].kind = haptics::Command::Kind::arm;
  return {bytesOf(quiet), bytesOf(held), bytesOf(armed)};
}

}  // namespace perilymph::fuzz

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  using namespace perilymph;
  const auto record = session::readTick({data, size});
  if (!record) return 0;
  const fuzz::Bytes again = fuzz::bytesOf(*record);
  fuzz::promise(again == fuzz::Bytes(data, data + size), "a record is written as it was read");
  fuzz::replay(*record);
  return 0;
}
