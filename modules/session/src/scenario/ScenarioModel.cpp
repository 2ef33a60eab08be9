// SPDX-License-Identifier: BSD-3-Clause

// Builds the model of a scenario. Exceptions for invalid parts become error messages here.

#include <stdexcept>

#include "perilymph/anatomy/HapticSurface.h"
#include "perilymph/session/Scenario.h"

namespace perilymph::session {

Result<std::shared_ptr<const anatomy::ScalaTympani>> buildAnatomy(const Scenario& scenario)
{
  return anatomy::buildAnatomy({scenario.anatomy, scenario.patient, scenario.leadIn},
                               scenario.name);
}

Result<std::shared_ptr<const mechanics::InsertionModel>> buildModel(
    const Scenario& scenario, std::shared_ptr<const anatomy::ScalaTympani> anatomy)
{
  mechanics::ModelParts parts;
  parts.kind = scenario.model;
  if (parts.kind == mechanics::ModelKind::points)
    parts.hapticSurface =
        std::make_shared<const anatomy::Surface>(anatomy::hapticSurface(*anatomy));
  parts.lumen = std::move(anatomy);
  parts.array = scenario.array;
  parts.friction = scenario.friction;
  parts.wall = scenario.wall;
  parts.opening = scenario.opening;
  parts.membrane = scenario.membrane;
  parts.nodes = scenario.nodes;
  parts.timeStep = scenario.timeStep;
  parts.startInside = scenario.startInside;
  parts.approachTilt = scenario.approachTilt;
  parts.approachTurn = scenario.approachTurn;
  try {
    return mechanics::InsertionModel::build(std::move(parts));
  } catch (const std::invalid_argument& error) {
    return Error{"The model of " + scenario.name + " cannot be built: " + error.what()};
  }
}

}  // namespace perilymph::session
