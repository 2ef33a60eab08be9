// SPDX-License-Identifier: BSD-3-Clause
#include "experiment/MeasuredInsertion.h"

#include <algorithm>
#include <cmath>
#include <stop_token>

#include "perilymph/analysis/ExperimentDevice.h"
#include "perilymph/analysis/RandomStream.h"
#include "perilymph/session/Insertion.h"

namespace perilymph::validation {

Result<MeasuredInsertion> measure(const DrawnInsertion& drawn,
                                  std::shared_ptr<const anatomy::ScalaTympani> anatomy,
                                  Duration samplePeriod, Length travel, const std::stop_token& stop)
{
  session::InsertionParameters parameters = drawn.parameters;
  parameters.stopTravel = travel;
  parameters.engine.stopTravel = travel.si();
  parameters.engine.samplePeriod = parameters.timeStep.si();
  parameters.engine.pushesAlongOpening = true;
  parameters.withdraws = false;
  auto insertion = session::Insertion::prepare(
      parameters, std::make_unique<analysis::ExperimentDevice>(drawn.push, parameters.timeStep),
      std::move(anatomy));
  if (!insertion) return insertion.error();

  MeasuredInsertion measured;
  const Eigen::Vector3d out_W = (*insertion)->anatomy().entry().out_W;
  std::optional<Eigen::Vector3d> start_W;  // of the tweezers
  analysis::RandomStream noise(drawn.seed, drawn.number,
                               static_cast<std::uint64_t>(SpreadSource::noise));
  const std::uint64_t ticksPerSample =
      static_cast<std::uint64_t>(std::lround(samplePeriod / parameters.timeStep));
  std::uint64_t moving = 0;
  double maxForce = 0.0, maxDepth = 0.0, crosshead = 0.0;
  haptics::InsertionEnd end = haptics::InsertionEnd::none;
  const auto each = [&](const haptics::TickRecord& record) {
    const haptics::TickOutput& now = record.output;
    ++measured.ticks;
    if (now.status & haptics::notConverged) ++measured.ticksNotConverged;
    end = endOf(now);
    if (now.workflow != haptics::Workflow::inserting) return !stop.stop_requested();
    const Eigen::Vector3d base_W(now.proxy_W[0], now.proxy_W[1], now.proxy_W[2]);
    if (!start_W) start_W = base_W;
    crosshead = (*start_W - base_W).dot(out_W);
    maxForce = std::max(maxForce, now.axialForce);
    maxDepth = std::max(maxDepth, now.depth);
    if (moving++ % ticksPerSample == 0) {
      measured.travel.push_back(crosshead);
      measured.depth.push_back(now.depth);
      measured.force.push_back(now.axialForce + drawn.noiseDeviation * noise.normal());
    }
    return !stop.stop_requested();
  };
  const auto ran =
      (*insertion)->runToEnd(each, session::maxTicks(parameters, (*insertion)->model()));
  if (stop.stop_requested()) return Error{"Stopped before insertion %1.", drawn.number + 1};
  if (!ran) end = haptics::InsertionEnd::fault;
  if (end != haptics::InsertionEnd::finished)
    measured.incomplete =
        IncompleteInsertion{drawn.number + 1, end,      maxDepth,
                            crosshead,        maxForce, ran ? Sentence() : ran.error().message};
  return measured;
}

}  // namespace perilymph::validation
