// SPDX-License-Identifier: BSD-3-Clause
#include "TestRod.h"

#include <cmath>

namespace perilymph::test {
namespace {

electrode::ArrayDesign uniformArray(const RodSpec& spec)
{
  electrode::ArrayDesign array;
  array.name = "uniform rod";
  array.length = meters(spec.length);
  array.insertable = meters(spec.length);
  array.diameter = {{meters(0)}, {meters(2 * spec.radius)}};
  array.bending = {{meters(0)}, {newtonSquareMeters(spec.bending)}};
  array.restCurvature = {{meters(0)}, {Curvature::fromSi(spec.restCurvature)}};
  if (spec.curledFromTip > 0.0)
    array.restCurvature = {
        {meters(0), meters(spec.curledFromTip), meters(spec.curledFromTip + 1e-6)},
        {Curvature::fromSi(spec.restCurvature), Curvature::fromSi(spec.restCurvature),
         Curvature::fromSi(0.0)}};
  if (spec.bendingAcross > 0.0)
    array.bendingAcross = {{meters(0)}, {newtonSquareMeters(spec.bendingAcross)}};
  if (spec.thickness > 0.0) array.thickness = {{meters(0)}, {meters(spec.thickness)}};
  if (spec.twisting > 0.0)
    array.twisting =
        electrode::AlongArray<BendingStiffness>{{meters(0)}, {newtonSquareMeters(spec.twisting)}};
  array.wires = spec.wires;
  array.ribsFromTip = spec.ribsFromTip;
  array.ribHeight = meters(spec.ribHeight);
  array.ribLength = meters(spec.ribLength);
  return array;
}

}  // namespace

TestRod::TestRod(std::shared_ptr<const anatomy::Lumen> lumen, const RodSpec& spec)
{
  mechanics::ModelParts parts;
  parts.lumen = std::move(lumen);
  parts.array = uniformArray(spec);
  parts.nodes = spec.nodes;
  parts.timeStep = seconds(spec.timeStep);
  parts.membrane = spec.membrane;
  parts.partitionStrength = newtons(spec.partitionStrength);
  parts.approachTilt = radians(spec.tilt);
  parts.opening = spec.opening;
  parts.startInside = meters(spec.startInside);
  parts.freeLength = spec.freeLength;
  parts.friction = {spec.friction, spec.friction, spec.friction, millimetersPerSecond(0.1)};
  parts.relaxation = spec.relaxation;
  parts.wall = {newtonsPerMeter(spec.wallStiffness), newtonsPerMeter(spec.wallStiffness),
                millimeters(0.002)};
  model_ = std::make_shared<mechanics::InsertionModel>(*mechanics::InsertionModel::build(parts));
  state_ = std::make_unique<mechanics::InsertionState>(*model_);
  drive_.handPosition_W = model_->startBase_W;
  drive_.handAxis_W = model_->startAxis_W;
  drive_.handCurl_W = model_->startCurl_W;
}

void TestRod::move(const Eigen::Vector3d& motion_W, double speed, double rest)
{
  const Eigen::Vector3d from = drive_.handPosition_W;
  const long ticks = std::lround(std::ceil(motion_W.norm() / speed / model_->timeStep));
  for (long k = 1; k <= ticks; ++k) {
    drive_.handPosition_W = from + (static_cast<double>(k) / static_cast<double>(ticks)) * motion_W;
    tick();
  }
  const long waiting = std::lround(rest / model_->timeStep);
  for (long k = 0; k < waiting; ++k) tick();
}

void TestRod::tick() { mechanics::advance(*model_, *state_, drive_); }

double TestRod::tension(std::size_t edge) const
{
  const double length = (state_->position_W[edge + 1] - state_->position_W[edge]).norm();
  return model_->stretching[edge] * (length - model_->spacing) / model_->spacing;
}

}  // namespace perilymph::test
