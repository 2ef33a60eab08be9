// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/test/PlainModels.h"

#include <utility>

#include "lumen/PlainLumens.h"

namespace perilymph::test {

namespace {

std::shared_ptr<const mechanics::InsertionModel> insertionIn(
    std::shared_ptr<const anatomy::Lumen> lumen, Duration timeStep)
{
  mechanics::ModelParts parts;
  parts.lumen = std::move(lumen);
  parts.array = plainArray();
  parts.nodes = 40;
  parts.timeStep = timeStep;
  parts.startInside = millimeters(2);
  return mechanics::InsertionModel::build(std::move(parts));
}

}  // namespace

electrode::ArrayDesign plainArray()
{
  electrode::ArrayDesign array;
  array.name = "Plain array";
  array.maker = "none";
  array.note = "A round rod for tests.";
  array.length = millimeters(22);
  array.insertable = millimeters(20);
  array.diameter = {{millimeters(0)}, {millimeters(0.5)}};
  array.bending = {{millimeters(0)}, {newtonSquareMeters(1e-6)}};
  array.restCurvature = {{millimeters(0)}, {perMillimeter(0)}};
  return array;
}

std::shared_ptr<const mechanics::InsertionModel> insertionInTube(Duration timeStep)
{
  return insertionIn(std::make_shared<anatomy::StraightTube>(5e-3), timeStep);
}

std::shared_ptr<const mechanics::InsertionModel> insertionInRing()
{
  return insertionIn(std::make_shared<anatomy::CircularDuct>(0.6e-3, 4e-3, 3e-3), milliseconds(1));
}

}  // namespace perilymph::test
