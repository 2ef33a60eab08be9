// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/analysis/InsertionRun.h"

#include <algorithm>
#include <cmath>
#include <stop_token>

#include "ProfilePoints.h"
#include "perilymph/analysis/ForceProfile.h"
#include "perilymph/analysis/StopForce.h"
#include "perilymph/device/ScriptedDevice.h"
#include "perilymph/session/Highlights.h"
#include "perilymph/session/Insertion.h"

namespace perilymph::analysis {

namespace {

std::unique_ptr<device::HapticDevice> scriptOf(const session::InsertionParameters& parameters)
{
  return std::make_unique<device::ScriptedDevice>(parameters.speed.si(), parameters.timeStep.si());
}

InsertionRun runFully(session::Insertion& insertion, Length profileSpacing,
                      const std::stop_token& stop)
{
  const session::InsertionParameters& parameters = insertion.parameters();
  InsertionRun result;
  haptics::TickOutput last;
  ProfilePoints points(profileSpacing);
  StopForce stopForce(averaged());
  const auto each = [&](const haptics::TickRecord& record) {
    const haptics::TickOutput& now = last = record.output;
    stopForce.add(now);
    ++result.ticks;
    if ((now.status & haptics::notConverged) != 0) ++result.ticksNotConverged;
    if (haptics::raisesPeak(now, result.peak.force.si()))
      result.peak = {meters(now.depth), newtons(now.axialForce)};
    const bool isMoving =
        now.workflow == haptics::Workflow::inserting || now.workflow == haptics::Workflow::finished;
    if (!isMoving) return !stop.stop_requested();
    result.partition = newtons(std::max(result.partition.si(), now.partitionForce));
    result.maxDepth = meters(std::max(result.maxDepth.si(), now.depth));
    points.add(result.profile, now.depth, now.axialForce);
    return !stop.stop_requested();
  };
  const auto ran = insertion.runToEnd(each, session::maxTicks(parameters, insertion.model()));
  if (stop.stop_requested()) return result;
  result.end = ran ? endOf(last) : InsertionEnd::fault;
  if (!ran) result.reason = ran.error().message;
  result.depth = meters(last.depth);
  result.endForce = newtons(stopForce.value());
  insertion.refresh();
  result.contacts = contactPositions(insertion.anatomy(), parameters.array, insertion.latest());
  result.apical = angularInsertionDepth(result.contacts);
  result.coverage = cochlearCoverage(result.contacts);
  return result;
}

}  // namespace

InsertionRun runInsertion(const session::InsertionParameters& given,
                          std::shared_ptr<const anatomy::ScalaTympani> anatomy,
                          Length profileSpacing, const std::stop_token& stop)
{
  session::InsertionParameters parameters = given;
  parameters.withdraws = false;
  auto insertion =
      session::Insertion::prepare(parameters, scriptOf(parameters), std::move(anatomy));
  if (!insertion) {
    InsertionRun refused;
    refused.reason = insertion.error().message;
    return refused;
  }
  return runFully(**insertion, profileSpacing, stop);
}

Result<InsertionRun> runInsertion(const session::Scenario& scenario,
                                  std::shared_ptr<const anatomy::ScalaTympani> anatomy,
                                  const std::filesystem::path& recording,
                                  const std::stop_token& stop)
{
  auto insertion = session::Insertion::prepare(scenario, scriptOf(scenario.parameters()), recording,
                                               std::move(anatomy));
  if (!insertion) return insertion.error();
  InsertionRun result = runFully(**insertion, {}, stop);
  if (stop.stop_requested()) return Error{"Canceled."};
  if (const auto closed = (*insertion)->closeRecording(); !closed) return closed.error();
  return result;
}

}  // namespace perilymph::analysis
