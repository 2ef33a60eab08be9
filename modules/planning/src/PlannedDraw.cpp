// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/planning/PlannedDraw.h"

#include <algorithm>
#include <limits>
#include <stop_token>

#include "PlanSetup.h"

namespace perilymph::planning {

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
  const auto setup = preparePlan(plan.request);
  if (!setup) return setup.error();
  if (!plan.isCurrent || fingerprintOf(plan.request, *setup) != plan.fingerprint)
    return Error{
        "An array, the scenario, a distribution or the program was changed since the plan of %1 "
        "was made. Make it again.",
        plan.request.patient.label};
  auto shape = runShape(plan.request, *setup, array, draw, stop);
  if (!shape) return shape.error();
  if (stop.stop_requested()) return Error{"Stopped."};
  if (shape->insertion.insertion.end == haptics::InsertionEnd::refused)
    return Error{shape->insertion.insertion.reason};
  return shape;
}

}  // namespace perilymph::planning
