// SPDX-License-Identifier: BSD-3-Clause
#include "gui/run/PlannedForce.h"

#include <cmath>

#include "gui/run/ScenarioApproach.h"

namespace perilymph::gui {

namespace {

constexpr double sameLength_m = 1e-9;  // texts of patients are rounded to a picometer

bool areSame(Length one, Length other) { return std::fabs((one - other).si()) < sameLength_m; }

}  // namespace

bool PlannedForce::isFor(const session::Scenario& scenario) const
{
  const anatomy::Patient& other = scenario.patient();
  if (scenario.anatomy() != anatomy::AnatomySource::mean || scenario.arrayName() != array ||
      !areSame(approachOf(scenario), approach) || other.side != patient.side || !other.basalTurn ||
      !patient.basalTurn)
    return false;
  const anatomy::BasalTurn &own = *patient.basalTurn, &turn = *other.basalTurn;
  return areSame(own.a, turn.a) && areSame(own.b, turn.b) &&
         own.h.has_value() == turn.h.has_value() && (!own.h || areSame(*own.h, *turn.h));
}

}  // namespace perilymph::gui
