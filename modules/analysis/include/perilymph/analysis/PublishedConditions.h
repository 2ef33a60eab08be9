// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Whether an insertion may be shown beside the published experiment.

#include "perilymph/session/Scenario.h"

namespace perilymph::analysis {

/// Whether an insertion has the conditions of the published experiment: array, technique, cochlea,
/// friction and speed of the shipped scenario contour-published. The ear, the solver and the input
/// device do not matter. False if the scenario is missing.
bool hasPublishedConditions(const session::Scenario& insertion);

/// Whether it has the array, technique and cochlea of that experiment, in which BasalTurnWindow is the travel
/// of the basal turn. Of others findBasalTurn() finds any dip of the curve there.
bool hasPublishedBasalTurn(const session::Scenario& insertion);

}  // namespace perilymph::analysis
