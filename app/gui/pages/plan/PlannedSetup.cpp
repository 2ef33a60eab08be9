// SPDX-License-Identifier: BSD-3-Clause
#include "gui/pages/plan/PlannedSetup.h"

#include "gui/setup/PatientSetup.h"

namespace perilymph::gui {

Result<Setup> plannedSetup(const planning::Plan& plan, std::size_t array)
{
  const auto scenario = surgicalScenario(plan.request, plan.request.arrays[array]);
  if (!scenario) return scenario.error();
  return setupOfPatient(plan.request.patient, &*scenario);
}

}  // namespace perilymph::gui
