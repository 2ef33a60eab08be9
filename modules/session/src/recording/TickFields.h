// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The list of a tick's fields, used for writing, reading and comparing.

#include <cmath>
#include <cstdint>

#include "perilymph/haptics/Snapshot.h"

namespace perilymph::session {

/// Calls `each(value)` for every number of a tick before its commands, and for their count.
template <class Record, class Each>
void forEachInput(Record& record, Each&& each)
{
  each(record.tick);
  each(record.sample.sequence);
  for (auto& value : record.sample.position_D) each(value);
  for (auto& value : record.sample.rotation_D) each(value);
  each(record.sample.buttons);
  each(record.sample.isValid);
  each(record.commands.count);
}

/// The fields of an output that recordings of every version have; see forEachField().
template <class Output, class Visit>
void forEachFirstField(Output& output, Visit&& visit)
{
  const auto visitEach = [&visit](const char* name, auto& values) {
    for (std::size_t i = 0; i < values.size(); ++i) visit(name, static_cast<int>(i), values[i]);
  };
  visitEach("wrench_D.force_D", output.wrench_D.force_D);
  visitEach("wrench_D.torque_D", output.wrench_D.torque_D);
  visit("workflow", -1, output.workflow);
  visit("status", -1, output.status);
  visit("contacts", -1, output.contacts);
  visit("iterations", -1, output.iterations);
  visit("time", -1, output.time);
  visit("travel", -1, output.travel);
  visit("depth", -1, output.depth);
  visit("speed", -1, output.speed);
  visit("angularDepth", -1, output.angularDepth);
  visit("axialForce", -1, output.axialForce);
  visitEach("force_W", output.force_W);
  visitEach("tip_W", output.tip_W);
  visitEach("device_W", output.device_W);
  visitEach("proxy_W", output.proxy_W);
  visit("wallForceMax", -1, output.wallForceMax);
  visit("membraneForce", -1, output.membraneForce);
  visit("styletWithdrawal", -1, output.styletWithdrawal);
  visit("residual", -1, output.residual);
}

/// The fields of a rupture; see forEachField().
template <class Output, class Visit>
void forEachRuptureField(Output& output, Visit&& visit)
{
  visit("ruptureAngle", -1, output.translocation.angle);
  visit("ruptureForce", -1, output.translocation.force);
  visit("ruptureDepth", -1, output.translocation.depth);
  visit("lengthAbove", -1, output.translocation.lengthAbove);
}

/// Calls `visit(name, index, value)` for every number of an output; arrays element by element, with
/// index -1 for scalars.
template <class Output, class Visit>
void forEachField(Output& output, Visit&& visit)
{
  forEachFirstField(output, visit);
  // recordings of before have none
  if (!std::isnan(output.partitionForce)) visit("partitionForce", -1, output.partitionForce);
  // recordings of arrays that do not yield, and all of before, have none
  if (!std::isnan(output.plasticWork)) visit("plasticWork", -1, output.plasticWork);
  // recordings without a rupture, and all of before, have none of these
  if ((output.status & haptics::partitionRuptured) != 0) forEachRuptureField(output, visit);
}

/// Calls `each(value)` for every number of a tick but its commands: the columns of a block, always
/// the same.
template <class Record, class Each>
void forEachColumn(Record& record, Each&& each)
{
  const auto visit = [&each](const char*, int, auto& value) { each(value); };
  forEachInput(record, each);
  forEachFirstField(record.output, visit);
  each(record.output.partitionForce);
  each(record.output.plasticWork);
  forEachRuptureField(record.output, visit);
}

}  // namespace perilymph::session
