// SPDX-License-Identifier: BSD-3-Clause
#include "ScenarioRun.h"

#include <algorithm>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "perilymph/device/ScriptedDevice.h"
#include "perilymph/session/Insertion.h"

namespace perilymph::test {

namespace {

constexpr std::uint64_t ticksBetweenProbes = 10;

/// Measures how deep the array is in the bone.
class Probe {
public:
  explicit Probe(const mechanics::InsertionModel& model)
      : model_(model), walls_(static_cast<std::size_t>(model.nodes)), reach_(walls_.size(), 1e-3)
  {
  }

  void measure(const mechanics::InsertionState& state, ScenarioRun& run)
  {
    auto tracks = state.track;
    model_.parts.lumen->nearestWall(state.position_W, reach_, tracks, walls_);
    for (std::size_t i = 0; i < walls_.size(); ++i) {
      const double inside = (model_.entry.origin_W - state.position_W[i]).dot(model_.entry.out_W);
      const bool isBeside = state.isBeside[i] != 0;
      // In the first stretch the wall is still setting in, or the rim has taken its place.
      if (!(walls_[i].isNear || isBeside) || inside < 2.0 * model_.spacing) continue;
      const double half = std::min(model_.halfWithin[i], model_.halfAcross[i]);
      const double depth = isBeside ? inside : half - walls_[i].distance;
      run.penetration = std::max(run.penetration, depth);
      // at the edge behind the opening the wall is softer
      const double edge = isBeside ? 0.0 : model_.parts.wall.edge.si();
      const double part = inside < edge ? inside / edge : 1.0;
      const double stiffness = part * part * model_.wallStiffness[i];
      run.unexplained = std::max(run.unexplained, depth - yielded(state, i, stiffness));
    }
  }

private:
  /// Depth at which bone and membrane, in parallel, bear the force on a node, where the wall's full
  /// stiffness or that of its edge is given [N/m].
  double yielded(const mechanics::InsertionState& state, std::size_t i, double stiffness) const
  {
    const mechanics::ModelParts& parts = model_.parts;
    const double force = state.normalForce[i], lining = parts.wall.lining.si();
    if (!model_.membrane) return force / stiffness + lining;
    const double onMembrane =
        model_.membrane
            ->fractionAt(state.position_W[i], model_.radius[i], state.track[i], walls_[i].normal_W)
            .fraction;
    const double bone = (1.0 - onMembrane) * stiffness;
    const double membrane =
        onMembrane * stiffness * (parts.membrane->perSamplePoint / parts.wall.perSamplePoint);
    // the membrane hardens: without that, it would yield more
    double low = 0.0, high = force / (bone + membrane);
    for (int k = 0; k < 50; ++k) {
      const double middle = 0.5 * (low + high), part = middle / parts.membrane->hardening.si();
      ((bone + membrane * (1.0 + part * part)) * middle < force ? low : high) = middle;
    }
    return high + lining;
  }

  const mechanics::InsertionModel& model_;
  std::vector<anatomy::WallPoint> walls_;
  std::vector<double> reach_;
};

/// The scenario's cochlea; built once for all scenarios that differ in other keys only.
std::shared_ptr<const anatomy::ScalaTympani> cochleaOf(const session::Scenario& scenario)
{
  static std::map<std::string, std::shared_ptr<const anatomy::ScalaTympani>> built;
  std::string key;
  for (const auto& [name, value] : scenario.values())
    if (name == "anatomy" || name == "patient" || name == "lead_in_mm") key += value + "|";
  std::shared_ptr<const anatomy::ScalaTympani>& cochlea = built[key];
  if (!cochlea) {
    const auto now = session::buildAnatomy(scenario.parameters());
    if (now) cochlea = *now;
  }
  return cochlea;
}

}  // namespace

ScenarioRun runScenario(const std::string& name, const session::Overrides& changes, Push push)
{
  ScenarioRun run;
  run.end = haptics::InsertionEnd::refused;
  const auto scenario = session::loadScenario(name, changes);
  if (!scenario) return run.error = scenario.error().message, run;
  session::InsertionParameters parameters = scenario->parameters();
  parameters.engine.pushesAlongOpening = push == Push::alongOpening;
  auto insertion = session::Insertion::prepare(
      parameters,
      std::make_unique<device::ScriptedDevice>(scenario->speed().si(), scenario->timeStep().si()),
      cochleaOf(*scenario));
  if (!insertion) return run.error = insertion.error().message, run;

  const mechanics::InsertionModel& model = (*insertion)->model();
  const mechanics::InsertionState& state = (*insertion)->loop().engine().state();
  Probe probe(model);
  haptics::TickOutput last;
  std::optional<Eigen::Vector3d> base_W, force_W;
  const auto ran =
      (*insertion)
          ->runToEnd(
              [&](const haptics::TickRecord& record) {
                last = record.output;
                ++run.ticks;
                if ((last.status & haptics::notConverged) != 0) ++run.ticksNotConverged;
                const Eigen::Vector3d now_W(last.proxy_W[0], last.proxy_W[1], last.proxy_W[2]);
                const Eigen::Vector3d f_W(last.force_W[0], last.force_W[1], last.force_W[2]);
                if (base_W) run.work -= 0.5 * (*force_W + f_W).dot(now_W - *base_W);
                base_W = now_W;
                force_W = f_W;
                run.endForce = f_W.norm();
                run.peakForce = std::max(run.peakForce, run.endForce);
                run.deepest = std::max(run.deepest, last.depth);
                run.lowestTweezers = std::min(
                    run.lowestTweezers, (now_W - model.entry.origin_W).dot(model.entry.out_W));
                if (model.parts.kind == mechanics::ModelKind::rod &&
                    run.ticks % ticksBetweenProbes == 0)
                  probe.measure(state, run);
                return true;
              },
              session::maxTicks((*insertion)->parameters(), model));
  run.depth = last.depth;
  run.angle = last.angularDepth;
  run.end = ran ? endOf(last) : haptics::InsertionEnd::fault;
  if (!ran) run.error = ran.error().message;
  return run;
}

std::string textOf(const session::Overrides& changes)
{
  std::string text;
  for (const auto& [key, value] : changes) text += (text.empty() ? "" : " ") + key + "=" + value;
  return text;
}

}  // namespace perilymph::test
