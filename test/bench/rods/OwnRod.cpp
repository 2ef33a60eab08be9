// SPDX-License-Identifier: BSD-3-Clause

// The project's rod.

#include <algorithm>
#include <cmath>
#include <memory>

#include "RodTrial.h"
#include "lumen/PlainLumens.h"
#include "perilymph/mechanics/advance.h"

namespace {

using namespace perilymph;

// A wall that is hard against everything here, as in test/physics/mechanics/TestRod.
constexpr Stiffness wallStiffness = newtonsPerMeter(1e5);
constexpr Length lining = millimeters(0.002);

std::shared_ptr<const anatomy::Lumen> lumenOf(const bench::RodTube& tube)
{
  if (tube.bend > 0.0)
    return std::make_shared<anatomy::CircularDuct>(tube.radius, tube.bend, tube.lead);
  return std::make_shared<anatomy::StraightTube>(tube.radius);
}

mechanics::InsertionModel modelOf(const bench::RodTrial& trial)
{
  mechanics::ModelParts parts;
  parts.lumen = lumenOf(trial.tube);
  parts.array.name = "uniform rod";
  parts.array.length = parts.array.insertable = meters(trial.rod.length);
  parts.array.diameter = {{meters(0)}, {meters(2.0 * trial.rod.radius)}};
  parts.array.bending = {{meters(0)}, {newtonSquareMeters(trial.rod.bending)}};
  parts.array.restCurvature = {{meters(0)}, {perMillimeter(0)}};
  parts.nodes = trial.nodes;
  parts.timeStep = seconds(bench::rodTimeStep);
  parts.startInside = meters(trial.startInside);
  parts.friction = {trial.friction, trial.friction, trial.friction, millimetersPerSecond(0.1)};
  parts.wall = {wallStiffness, wallStiffness, lining};
  mechanics::InsertionModel model = *mechanics::InsertionModel::build(parts);
  // there is no fluid in the closed forms
  std::fill(model.drag.begin(), model.drag.end(), 0.0);
  return model;
}

class OwnRod {
public:
  explicit OwnRod(const bench::RodTrial& trial) : model_(modelOf(trial)), state_(model_) {}

  void start() { state_.reset(model_); }

  void tick(const bench::RodHandAt& hand)
  {
    const double sine = std::sin(hand.turned), cosine = std::cos(hand.turned);
    mechanics::Drive drive;
    drive.handPosition_W = model_.startBase_W - hand.pushed * Eigen::Vector3d::UnitZ();
    drive.handAxis_W = {sine, 0.0, -cosine};
    drive.handCurl_W = {cosine, 0.0, sine};
    mechanics::advance(model_, state_, drive);
  }

  bench::RodForces forces() const
  {
    bench::RodForces forces;
    // the readings hold the force on the hand
    forces.push = state_.readings.handForce_W.z();
    forces.side = -state_.readings.handForce_W.x();
    for (std::size_t i = 0; i < state_.position_W.size(); ++i)
      forces.loads.push_back({state_.position_W[i], state_.normalForce[i]});
    return forces;
  }

private:
  mechanics::InsertionModel model_;
  mechanics::InsertionState state_;
};

void rod(benchmark::State& state, bench::RodQuestion question, double maxPercent)
{
  bench::rodBy<OwnRod>(state, question, maxPercent);
}

BENCHMARK_CAPTURE(rod, tube, bench::RodQuestion::pressedTip, 0.2)
    ->Name("rod/own/tube")
    ->Apply(bench::rodNodes);
BENCHMARK_CAPTURE(rod, torus, bench::RodQuestion::pushForce, 1.5)
    ->Name("rod/own/torus")
    ->Apply(bench::rodNodes);
BENCHMARK_CAPTURE(rod, capstan, bench::RodQuestion::capstan, 1.0)
    ->Name("rod/own/capstan")
    ->Apply(bench::rodNodes);

}  // namespace
