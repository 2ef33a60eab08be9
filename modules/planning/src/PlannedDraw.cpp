// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/planning/PlannedDraw.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <map>
#include <memory>
#include <stop_token>
#include <utility>

#include "PlanSetup.h"
#include "perilymph/foundation/InParallel.h"

namespace perilymph::planning {
namespace {

/// What a plan's draws are run with. Refused if it is no longer what they were run with.
Result<PlanSetup> currentSetup(const Plan& plan)
{
  auto setup = preparePlan(plan.request);
  if (!setup) return setup.error();
  if (!plan.isCurrent || fingerprintOf(plan.request, *setup) != plan.fingerprint)
    return Error{
        "An array, the scenario, a distribution or the program was changed since the plan of %1 "
        "was made. Make it again.",
        plan.request.patient.label};
  return setup;
}

/// @param cochlea  That of the draw; built if null.
Result<PlannedShape> shapeIn(const Plan& plan, const PlanSetup& setup, std::size_t array,
                             std::size_t draw, const std::stop_token& stop,
                             std::shared_ptr<const anatomy::ScalaTympani> cochlea)
{
  auto shape = runShape(plan.request, setup, array, draw, stop, std::move(cochlea));
  if (!shape) return shape.error();
  if (stop.stop_requested()) return Error{"Stopped."};
  if (shape->insertion.insertion.end == haptics::InsertionEnd::refused)
    return Error{shape->insertion.insertion.reason};
  return shape;
}

}  // namespace

std::size_t medianDraw(const Plan& plan, std::size_t array)
{
  const ArrayPlan& summary = plan.arrays[array];
  const auto squared = [](double value, const Band& band) {
    const double range = band.upperQuartile - band.lowerQuartile;
    const double off = range > 0.0 ? (value - band.median) / range : 0.0;
    return off * off;
  };
  std::size_t found = 0;
  double smallest = std::numeric_limits<double>::infinity();
  for (const PlannedInsertion& each : plan.insertions) {
    if (each.array != array || each.insertion.end == haptics::InsertionEnd::refused) continue;
    const double off = squared(inDegrees(each.insertion.apical), summary.angle_deg) +
                       squared(inMillinewtons(each.insertion.peak), summary.peak_mN);
    if (off < smallest) {
      smallest = off;
      found = each.draw;
    }
  }
  return found;
}

Result<PlannedShape> shapeOf(const Plan& plan, std::size_t array, std::size_t draw,
                             const std::stop_token& stop)
{
  const auto isRun =
      std::any_of(plan.insertions.begin(), plan.insertions.end(),
                  [=](const auto& each) { return each.array == array && each.draw == draw; });
  if (!isRun)
    return Error{
        "The plan has no simulation %1 of array %2; it has %3 of each of %4 arrays. Choose one of "
        "them.",
        draw, array + 1,
        plan.request.arrays.empty() ? 0 : plan.insertions.size() / plan.request.arrays.size(),
        plan.request.arrays.size()};
  const auto setup = currentSetup(plan);
  if (!setup) return setup.error();
  return shapeIn(plan, *setup, array, draw, stop, nullptr);
}

Result<std::vector<RepresentativeEnd>> representativeEnds(const Plan& plan,
                                                          const std::stop_token& stop)
{
  std::vector<RepresentativeEnd> ends(plan.arrays.size());
  std::vector<std::size_t> missing;  // arrays to run again
  std::map<std::size_t, std::shared_ptr<const anatomy::ScalaTympani>> cochleae;  // by their draw
  for (std::size_t array = 0; array < ends.size(); ++array) {
    const std::size_t draw = ends[array].draw = medianDraw(plan, array);
    if (draw == 0) continue;
    const auto found = std::find_if(
        plan.insertions.begin(), plan.insertions.end(),
        [=](const PlannedInsertion& each) { return each.array == array && each.draw == draw; });
    ends[array].node_W = found->end_W;
    if (!ends[array].node_W.empty()) continue;
    missing.push_back(array);
    cochleae[draw] = nullptr;
  }
  if (missing.empty()) return ends;
  const auto setup = currentSetup(plan);
  if (!setup) return setup.error();

  const auto build = [&](std::size_t piece, const std::stop_token&) -> Result<void> {
    auto& [draw, cochlea] = *std::next(cochleae.begin(), static_cast<std::ptrdiff_t>(piece));
    auto built = cochleaOf(plan.request, *setup, draw);
    if (!built) return built.error();
    (*built)->prepare();
    cochlea = *std::move(built);
    return {};
  };
  if (const auto built = doInParallel(cochleae.size(), plan.request.jobs, build, {}, stop); !built)
    return built.error();
  const auto run = [&](std::size_t piece, const std::stop_token& ending) -> Result<void> {
    const std::size_t array = missing[piece];
    const std::size_t draw = ends[array].draw;
    auto shape = shapeIn(plan, *setup, array, draw, ending, cochleae.at(draw));
    if (!shape) return shape.error();
    ends[array].node_W = std::move(shape->insertion.end_W);
    return {};
  };
  if (const auto ran = doInParallel(missing.size(), plan.request.jobs, run, {}, stop); !ran)
    return ran.error();
  return ends;
}

}  // namespace perilymph::planning
