// SPDX-License-Identifier: BSD-3-Clause
#include "validation/MeasuredInsertion.h"

#include <algorithm>
#include <cmath>

#include "perilymph/analysis/RandomStream.h"
#include "perilymph/session/Insertion.h"
#include "validation/ExperimentDevice.h"

namespace perilymph::analysis {

namespace {

/// Depth from which a tip counts as inside; tremor moves one at the opening by less (choice, high).
constexpr Length enteredDepth = millimeters(0.1);
/// Crosshead travel beyond the stop without arrival that counts as buckling. A shallow bow of
/// length l and height a shortens the array by (pi a)^2 / (4 l): 3 mm on the 20 mm in front of the
/// opening are a bow of 5 mm. In completed insertions the tip lags by less than 1 mm (choice,
/// high).
constexpr Length maxLag = millimeters(3);

}  // namespace

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
  bool hasArrived = false, hasEntered = false;
  double maxForce = 0.0, maxDepth = 0.0, crosshead = 0.0;
  std::optional<IncompleteEnd> end;
  const auto each = [&](const haptics::TickRecord& record) {
    const haptics::TickOutput& now = record.output;
    ++measured.ticks;
    if (now.status & haptics::notConverged) ++measured.ticksNotConverged;
    hasArrived = now.workflow == haptics::Workflow::finished;
    if (now.workflow != haptics::Workflow::inserting) return !isAsked;
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
    hasEntered = hasEntered || now.depth > enteredDepth.si();
    if (hasEntered && now.depth <= 0.0) end = IncompleteEnd::slippedOut;
    if (crosshead > stop.si() + maxLag.si()) end = IncompleteEnd::buckled;
    return !end && !isAsked;
  };
  // Twice the time for the travel, plus a second to start.
  const double ticks =
      2.0 * stop.si() / (drawn.speed * parameters.timeStep.si()) + 1.0 / parameters.timeStep.si();
  const auto ran = (*insertion)->runToEnd(each, static_cast<std::uint64_t>(ticks));
  if (isAsked) return Error{"Stopped before insertion " + std::to_string(drawn.number + 1) + "."};
  if (!ran) end = IncompleteEnd::fault;
  if (!hasArrived || end)
    measured.incomplete = IncompleteInsertion{
        drawn.number + 1, end.value_or(IncompleteEnd::buckled),     maxDepth, crosshead,
        maxForce,         ran ? std::string() : ran.error().message};
  return measured;
}

}  // namespace perilymph::analysis
