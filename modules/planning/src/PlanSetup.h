// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Everything that a plan's insertions need, read once: arrays, distributions, thresholds.

#include <memory>
#include <stop_token>
#include <string>
#include <vector>

#include "PlanDraw.h"
#include "Uncertainty.h"
#include "perilymph/analysis/Surgeon.h"
#include "perilymph/planning/PlanResult.h"
#include "perilymph/planning/PlannedShape.h"
#include "perilymph/planning/ResistanceGrid.h"
#include "perilymph/planning/UnstoppedDraws.h"

namespace perilymph::planning {

/// An array before anything is drawn.
struct Nominal {
  session::InsertionParameters parameters;
  std::string text;  ///< The values of its scenario as run.
  double stiffnessDeviation = 0.0;
};

/// Input of all draws of a plan.
struct PlanSetup {
  Uncertainty uncertainty;
  analysis::HandDistribution hand;
  Thresholds thresholds;
  std::string distributions;         ///< SHA-256 of the files of `uncertainty` and `hand`.
  std::vector<Nominal> nominal;      ///< By array.
  std::vector<PlannedArray> arrays;  ///< By array.
  std::optional<ClinicResistance> clinic = {};
};

/// Reads arrays, scenario and distributions. Refuses a request that no plan can be made of.
Result<PlanSetup> preparePlan(const PlanRequest& request);

/// SHA-256 of everything that a plan depends on but the numbers of draws and of threads.
std::string fingerprintOf(const PlanRequest& request, const PlanSetup& setup);

/// Plan::friction: of the scenario, which all arrays share.
Range frictionOf(const PlanSetup& setup);
/// Plan::frictionSpread.
double frictionSpreadOf(const PlanSetup& setup);

/// Fills Plan::clinic and the arrays' InClinic from the insertions; nothing without a clinic's resistance.
void addClinic(Plan& plan, const PlanSetup& setup);

/// The insertions of all arrays in one draw, in one cochlea; fewer if asked to end.
Result<std::vector<PlannedInsertion>> runDraw(const PlanRequest& request, const PlanSetup& setup,
                                              std::size_t number, const std::stop_token& stop);

/// The cochlea of one draw.
Result<std::shared_ptr<const anatomy::ScalaTympani>> cochleaOf(const PlanRequest& request,
                                                               const PlanSetup& setup,
                                                               std::size_t number);

/// One array in one draw.
///
/// @param cochlea  That of the draw; built if null.
Result<PlannedShape> runShape(const PlanRequest& request, const PlanSetup& setup, std::size_t array,
                              std::size_t number, const std::stop_token& stop,
                              std::shared_ptr<const anatomy::ScalaTympani> cochlea = nullptr);

/// One array in one draw, pushed without a stop.
Result<UnstoppedDraw> runWithoutStop(const PlanRequest& request, const PlanSetup& setup,
                                     std::size_t array, std::size_t number,
                                     const std::stop_token& stop);

}  // namespace perilymph::planning
