// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/analysis/SimulatedInsertion.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "perilymph/analysis/ContactPositions.h"
#include "perilymph/analysis/Phase.h"
#include "perilymph/analysis/PublishedConditions.h"
#include "perilymph/figures/Strings.h"
#include "perilymph/foundation/Version.h"
#include "perilymph/haptics/InsertionEnd.h"

namespace perilymph::analysis {

namespace {

using Json = nlohmann::ordered_json;

// A tip less deep than this has not entered; tremor moves one at the opening by less (choice, high).
constexpr Length minDepth = millimeters(0.1);

double asMillimeters(double length) { return inMillimeters(meters(length)); }

/// The scenario's values under their own keys; tables as objects.
Json scenarioAsRun(const session::Scenario& scenario)
{
  Json json;
  json["name"] = scenario.name();
  for (const auto& [key, value] : scenario.values()) {
    const std::size_t dot = key.find('.');
    if (dot == std::string::npos)
      json[key] = Json::parse(value);
    else
      json[key.substr(0, dot)][key.substr(dot + 1)] = Json::parse(value);
  }
  return json;
}

Json pointJson(const std::optional<CurvePoint>& point)
{
  if (!point) return nullptr;
  // Points of the curve are at tenths of a millimeter; remove rounding errors.
  return {{"force_N", point->force},
          {"travel_mm", std::round(asMillimeters(point->travel) * 1e6) / 1e6}};
}

Json passedStopJson(const std::optional<PassedStop>& passed)
{
  if (!passed) return nullptr;
  return {{"stop_force_N", passed->stop.si()},
          {"depth_mm", inMillimeters(passed->depth)},
          {"angular_insertion_depth_deg", inDegrees(passed->apical)},
          {"contacts_inside", passed->inside},
          {"contacts", passed->contacts}};
}

/// The rupture of the partition; null if it held.
Json translocationJson(const haptics::TickOutput& last)
{
  if ((last.status & haptics::partitionRuptured) == 0) return nullptr;
  return {{"rupture_angle_deg", inDegrees(radians(last.translocation.angle))},
          {"rupture_force_N", last.translocation.force},
          {"rupture_depth_mm", asMillimeters(last.translocation.depth)},
          {"translocated", (last.status & haptics::translocated) != 0},
          {"length_above_mm", asMillimeters(last.translocation.lengthAbove)}};
}

}  // namespace

std::string placeOf(const haptics::TickOutput& now)
{
  const auto& f = now.force_W;
  const double force = std::sqrt(f[0] * f[0] + f[1] * f[1] + f[2] * f[2]);
  return "at " + figures::fixed(asMillimeters(now.depth), 2) + " mm of depth, " +
         figures::fixed(inMillinewtons(newtons(force)), 0) + " mN on the hand";
}

Result<SimulatedInsertion> simulate(session::Insertion& insertion,
                                    const std::function<bool(const haptics::TickRecord&)>& each)
{
  const auto hand = shippedHand();
  if (!hand) return hand.error();
  const std::optional<Force> stop = stopToPass(insertion.parameters(), *hand);
  SimulatedInsertion simulated;
  ForceProfiler profiler;
  bool isStopped = false;
  const auto ran = insertion.runToEnd(
      [&](const haptics::TickRecord& record) {
        profiler.add(record);
        simulated.last = record.output;
        if (stop && !simulated.passedStop && haptics::raisesPeak(record.output, stop->si())) {
          insertion.refresh();
          simulated.passedStop = passedStop(insertion.anatomy(), insertion.parameters().array,
                                            *stop, insertion.latest());
        }
        isStopped = !each(record);
        return !isStopped;
      },
      session::maxTicks(insertion.parameters(), insertion.model()));
  if (isStopped) return Error{"The insertion was stopped before its end. Run it again."};
  if (!ran) return ran.error();
  simulated.profile = profiler.profile();
  insertion.refresh();
  simulated.angularInsertionDepth =
      angularInsertionDepth(insertion.anatomy(), insertion.parameters().array, insertion.latest());
  if (simulated.profile.deepest < minDepth.si())
    return Error{
        "The tip did not enter the opening: %1. Aim at the opening (approach_tilt_deg, "
        "approach_turn_deg), or start deeper inside (start_inside_mm).",
        placeOf(simulated.last)};
  return simulated;
}

std::string simulationJson(const session::Scenario& scenario, const SimulatedInsertion& simulated,
                           const haptics::LoopStatistics& statistics)
{
  const ForceProfile& profile = simulated.profile;
  Json json;
  json["version"] = version();
  json["build"] = buildId();
  json["seed"] = scenario.seed();
  json["scenario"] = scenarioAsRun(scenario);
  json["end"] = haptics::nameOf(endOf(simulated.last));
  json["peak_force_N"] = profile.peak.force;
  json["peak_travel_mm"] = asMillimeters(profile.peak.travel);
  json["peak_depth_mm"] = asMillimeters(profile.peakDepth);
  const bool hasBasalTurn = hasPublishedBasalTurn(scenario);
  json["basal_turn_peak"] = hasBasalTurn ? pointJson(profile.basalTurnPeak) : Json(nullptr);
  json["basal_turn_dip"] = hasBasalTurn ? pointJson(profile.basalTurnDip) : Json(nullptr);
  json["passed_stop"] = passedStopJson(simulated.passedStop);
  json["work_J"] = profile.work;
  json["final_travel_mm"] = asMillimeters(profile.finalTravel);
  json["final_depth_mm"] = asMillimeters(profile.finalDepth);
  json["angular_insertion_depth_deg"] = inDegrees(simulated.angularInsertionDepth);
  json["final_angle_deg"] = inDegrees(radians(profile.finalAngle));
  json["final_phase"] = phaseName(phaseOf(simulated.last, scenario.stopTravel()));
  json["deepest_mm"] = asMillimeters(profile.deepest);
  json["wall_force_max_N"] = profile.wallForceMax;
  json["partition_force_max_N"] = profile.partitionForceMax;
  if (scenario.array().yields()) json["plastic_work_J"] = simulated.last.plasticWork;
  if (scenario.parameters().partitionStrength.si() > 0.0)
    json["translocation"] = translocationJson(simulated.last);
  json["duration_s"] = profile.duration;
  json["ticks"] = profile.ticks;
  json["ticks_not_converged"] = profile.ticksNotConverged;
  json["overruns"] = statistics.overruns;
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace perilymph::analysis
