// SPDX-License-Identifier: BSD-3-Clause
#include "validation/MeasuredInsertion.h"

#include <algorithm>
#include <cmath>

#include "perilymph/session/Insertion.h"
#include "statistics/RandomStream.h"
#include "validation/ExperimentDevice.h"

namespace perilymph::analysis {

Result<MeasuredInsertion> measure(const DrawnInsertion& drawn,
                                  std::shared_ptr<const anatomy::ScalaTympani> anatomy,
                                  Duration samplePeriod, Length stop,
                                  const std::atomic<bool>& isAsked)
{
  session::InsertionParameters parameters = drawn.parameters;
  parameters.stopTravel = stop;
  parameters.engine.stopTravel = stop.si();
  parameters.engine.samplePeriod = parameters.timeStep.si();
  parameters.withdraws = false;
  auto insertion = session::Insertion::prepare(
      parameters, std::make_unique<ExperimentDevice>(drawn), std::move(anatomy));
  if (!insertion) return insertion.error();

  MeasuredInsertion measured;
  const Eigen::Vector3d out_W = (*insertion)->anatomy().entry().out_W;
  std::optional<Eigen::Vector3d> start_W;  // of the tweezers
  RandomStream noise(drawn.seed, drawn.number, static_cast<std::uint64_t>(SpreadSource::noise));
  const std::uint64_t ticksPerSample =
      static_cast<std::uint64_t>(std::lround(samplePeriod / parameters.timeStep));
  std::uint64_t moving = 0;
  bool hasArrived = false;
  const auto each = [&](const haptics::TickRecord& record) {
    const haptics::TickOutput& now = record.output;
    ++measured.ticks;
    if (now.status & haptics::notConverged) ++measured.ticksNotConverged;
    hasArrived = now.workflow == haptics::Workflow::finished;
    if (now.workflow == haptics::Workflow::inserting && moving++ % ticksPerSample == 0) {
      const Eigen::Vector3d base_W(now.proxy_W[0], now.proxy_W[1], now.proxy_W[2]);
      if (!start_W) start_W = base_W;
      measured.travel.push_back((*start_W - base_W).dot(out_W));
      measured.depth.push_back(now.depth);
      measured.force.push_back(now.axialForce + drawn.noiseDeviation * noise.normal());
    }
    return !isAsked;
  };
  // Twice the time for the travel, plus a second to start.
  const double ticks =
      2.0 * stop.si() / (drawn.speed * parameters.timeStep.si()) + 1.0 / parameters.timeStep.si();
  const auto ran = (*insertion)->runToEnd(each, static_cast<std::uint64_t>(ticks));
  if (isAsked) return Error{"Stopped before insertion " + std::to_string(drawn.number + 1) + "."};
  if (!ran) return ran.error();
  if (!hasArrived)
    return Error{"Insertion " + std::to_string(drawn.number + 1) + " of the study with seed " +
                 std::to_string(drawn.seed) + " did not reach " +
                 std::to_string(inMillimeters(stop)) +
                 " mm of travel. Lower the spread in its validation file."};
  return measured;
}

}  // namespace perilymph::analysis
