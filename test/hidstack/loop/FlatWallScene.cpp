// SPDX-License-Identifier: BSD-3-Clause
#include "FlatWallScene.h"

#include <utility>

#include "lumen/PlainLumens.h"

namespace perilymph::hidstack {

namespace {

constexpr int nodes = 8;
const Length radius = millimeters(0.25);
const Length startInside = millimeters(2);

/// So stiff that 0.2 N compress it by 0.4 um, a thousandth of the coupling's deflection.
electrode::ArrayDesign stiffRod()
{
  electrode::ArrayDesign rod;
  rod.name = "Stiff rod";
  rod.maker = "none";
  rod.note = "For tests: no electrode array is like this.";
  rod.length = millimeters(12);
  rod.insertable = millimeters(10);
  rod.diameter = {{millimeters(0)}, {2.0 * radius}};
  rod.bending = {{millimeters(0)}, {newtonSquareMeters(1e-4)}};
  rod.restCurvature = {{millimeters(0)}, {perMillimeter(0)}};
  return rod;
}

}  // namespace

std::shared_ptr<const mechanics::InsertionModel> flatWallModel()
{
  mechanics::ModelParts parts;
  // The tip's center stops one radius before the wall.
  parts.lumen = std::make_shared<anatomy::FlatWall>((startInside + radius).si() + freeWay);
  parts.array = stiffRod();
  parts.friction = {};
  parts.friction.staticCoefficient = parts.friction.kineticCoefficient =
      parts.friction.stoppingCoefficient = 0.0;
  parts.wall.perSamplePoint = newtonsPerMeter(1e6);
  parts.wall.lining = millimeters(0.001);
  parts.nodes = nodes;
  parts.startInside = startInside;
  return mechanics::InsertionModel::build(std::move(parts));
}

std::unique_ptr<haptics::InsertionEngine> flatWallEngine(double samplePeriod)
{
  haptics::EngineSettings settings;
  settings.coupling = mechanics::Coupling::spring;
  settings.forceScale = forceScale;
  settings.couplingStiffness = couplingStiffness / forceScale;
  settings.couplingDamping /= forceScale;
  settings.samplePeriod = samplePeriod;
  return std::make_unique<haptics::InsertionEngine>(flatWallModel(), settings);
}

}  // namespace perilymph::hidstack
