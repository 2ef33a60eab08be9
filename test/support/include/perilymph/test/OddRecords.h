// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Ticks with every kind of number, and a comparison by bits.

#include <array>
#include <bit>
#include <cstdint>
#include <limits>
#include <random>
#include <vector>

#include "perilymph/haptics/Snapshot.h"
#include "perilymph/session/Recording.h"

namespace perilymph::test {

inline haptics::TickRecord oddRecord(std::uint64_t tick)
{
  std::mt19937_64 random(tick + 1);
  const auto number = [&random] {
    constexpr std::array<double, 5> odd = {-0.0, std::numeric_limits<double>::infinity(),
                                           std::numeric_limits<double>::quiet_NaN(),
                                           std::numeric_limits<double>::denorm_min(), -1.0 / 3.0};
    const std::uint64_t draw = random();
    return draw % 8 < odd.size() ? odd[draw % 8] : std::bit_cast<double>(random());
  };
  haptics::TickRecord record;
  record.tick = tick;
  record.sample.sequence = random();
  for (double& value : record.sample.position_D) value = number();
  for (double& value : record.sample.rotation_D) value = number();
  record.sample.buttons = static_cast<std::uint32_t>(random());
  record.sample.isValid = 1;
  record.commands.count = static_cast<std::uint32_t>(tick % 9);
  for (std::uint32_t i = 0; i < record.commands.count; ++i) {
    record.commands.items[i].kind = static_cast<haptics::Command::Kind>(random() % 8);
    record.commands.items[i].value = number();
  }
  haptics::TickOutput& output = record.output;
  for (double& value : output.wrench_D.force_D) value = number();
  for (double& value : output.wrench_D.torque_D) value = number();
  output.workflow = static_cast<haptics::Workflow>(random() % 6);
  output.status = static_cast<std::uint32_t>(random());
  output.contacts = static_cast<std::uint32_t>(random());
  output.iterations = static_cast<std::uint32_t>(random());
  for (double* value : {&output.time, &output.travel, &output.depth, &output.speed,
                        &output.angularDepth, &output.axialForce, &output.wallForceMax,
                        &output.membraneForce, &output.styletWithdrawal, &output.residual})
    *value = number();
  for (auto* values : {&output.force_W, &output.tip_W, &output.device_W, &output.proxy_W})
    for (double& value : *values) value = number();
  // these are stored, in formats 1 and 2, where they are numbers and the partition has ruptured
  output.partitionForce = number();
  output.plasticWork = number();
  for (double* value : {&output.translocation.angle, &output.translocation.force,
                        &output.translocation.depth, &output.translocation.lengthAbove})
    *value = number();
  return record;
}

/// Every bit of a record, in the order of its declaration.
inline std::vector<std::uint64_t> bitsOf(const haptics::TickRecord& record)
{
  std::vector<std::uint64_t> bits;
  const auto add = [&bits](double value) { bits.push_back(std::bit_cast<std::uint64_t>(value)); };
  bits.push_back(record.tick);
  bits.push_back(record.sample.sequence);
  for (const double value : record.sample.position_D) add(value);
  for (const double value : record.sample.rotation_D) add(value);
  bits.push_back(record.sample.buttons);
  bits.push_back(record.sample.isValid);
  bits.push_back(record.commands.count);
  for (const haptics::Command& command : record.commands.items) {
    bits.push_back(static_cast<std::uint64_t>(command.kind));
    add(command.value);
  }
  const haptics::TickOutput& output = record.output;
  for (const double value : output.wrench_D.force_D) add(value);
  for (const double value : output.wrench_D.torque_D) add(value);
  for (const std::uint32_t value : {static_cast<std::uint32_t>(output.workflow), output.status,
                                    output.contacts, output.iterations})
    bits.push_back(value);
  for (const double value : {output.time, output.travel, output.depth, output.speed,
                             output.angularDepth, output.axialForce, output.wallForceMax,
                             output.membraneForce, output.styletWithdrawal, output.residual})
    add(value);
  for (const auto& values : {output.force_W, output.tip_W, output.device_W, output.proxy_W})
    for (const double value : values) add(value);
  for (const double value :
       {output.partitionForce, output.plasticWork, output.translocation.angle,
        output.translocation.force, output.translocation.depth, output.translocation.lengthAbove})
    add(value);
  return bits;
}

inline session::RecordingFacts someFacts()
{
  session::RecordingFacts facts;
  facts.scenarioName = "somewhere";
  facts.scenarioText = "nodes = 20\n";
  facts.device = "Scripted insertion";
  facts.timeStep = 0.1 + 0.2;
  facts.run.samplePeriod = 1.0 / 3.0;
  facts.run.maxForce = 3.3;
  facts.seed = 7;
  facts.modelFingerprint = 0xffffffffffffffffu;
  facts.version = "0.1.0";
  facts.buildId = "0.1.0+abc";
  facts.startedUtc = "2010-05-17T09:30:00Z";
  return facts;
}

/// Ticks of an ordinary insertion.
inline std::vector<haptics::TickRecord> quietRecords(std::uint64_t first, std::uint64_t count)
{
  std::vector<haptics::TickRecord> records(count);
  for (std::uint64_t i = 0; i < count; ++i) {
    records[i].tick = first + i;
    records[i].output.time = 1e-3 * static_cast<double>(first + i);
  }
  return records;
}

}  // namespace perilymph::test
