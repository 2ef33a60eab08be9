// SPDX-License-Identifier: BSD-3-Clause

// Builds the model of a scenario. Exceptions for invalid parts become error messages here.

#include <stdexcept>

#include "perilymph/anatomy/HapticSurface.h"
#include "perilymph/session/Scenario.h"

namespace perilymph::session {

Result<std::shared_ptr<const anatomy::ScalaTympani>> buildAnatomy(
    const InsertionParameters& parameters)
{
  return anatomy::buildAnatomy(parameters.cochlea, parameters.name);
}

Result<std::shared_ptr<const mechanics::InsertionModel>> buildModel(
    const InsertionParameters& parameters, std::shared_ptr<const anatomy::ScalaTympani> anatomy)
{
  mechanics::ModelParts parts;
  parts.kind = parameters.model;
  if (parts.kind == mechanics::ModelKind::points)
    parts.hapticSurface =
        std::make_shared<const anatomy::Surface>(anatomy::hapticSurface(*anatomy));
  parts.lumen = std::move(anatomy);
  parts.array = parameters.array;
  parts.friction = parameters.friction;
  parts.relaxation = parameters.relaxation;
  parts.wall = parameters.wall;
  parts.opening = parameters.opening;
  parts.membrane = parameters.membrane;
  parts.partitionStrength = parameters.partitionStrength;
  parts.nodes = parameters.nodes;
  parts.timeStep = parameters.timeStep;
  parts.startInside = parameters.startInside;
  parts.approachTilt = parameters.approachTilt;
  parts.approachTurn = parameters.approachTurn;
  parts.freeLength = parameters.freeLength;
  try {
    return mechanics::InsertionModel::build(std::move(parts));
  } catch (const std::invalid_argument& error) {
    return Error{"The model of %1 cannot be built: %2", parameters.name, error.what()};
  }
}

}  // namespace perilymph::session
