// SPDX-License-Identifier: BSD-3-Clause
#include "gui/pages/plan/PlannedSetup.h"

#include <QCoreApplication>

#include "gui/setup/PatientSetup.h"
#include "gui/setup/PlannedFriction.h"

namespace perilymph::gui {

Result<Setup> plannedSetup(const planning::Plan& plan, std::size_t array)
{
  const auto scenario = surgicalScenario(plan.request, plan.request.arrays[array]);
  if (!scenario) return scenario.error();
  return setupOfPatient(plan.request.patient, &*scenario);
}

PlannedForce plannedForce(const planning::Plan& plan, std::size_t array)
{
  const planning::ArrayPlan& planned = plan.arrays[array];
  PlannedForce force;
  force.hold = bandsHold(plan);
  force.peak_mN = planned.peak_mN;
  force.end_mN = planned.end_mN;
  force.angle_deg = planned.angle_deg;
  if (planned.after1s_mN.high > 0.0) force.after1s_mN = planned.after1s_mN;
  force.label = QCoreApplication::translate("perilymph::gui", "plan: %1").arg(force.hold);
  if (!planned.force.empty())
    force.label += QCoreApplication::translate("perilymph::gui", ", at last %1 of %2")
                       .arg(planned.force.back().draws)
                       .arg(planned.draws);
  force.patient = plan.request.patient;
  force.array = plan.request.arrays[array];
  for (const planning::ForceBand& each : planned.force)
    force.points.push_back(
        {each.depth_mm, each.force_mN.low, each.force_mN.median, each.force_mN.high});
  return force;
}

}  // namespace perilymph::gui
