// SPDX-License-Identifier: BSD-3-Clause
#include "SimulationJson.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "JsonText.h"
#include "perilymph/foundation/Version.h"

namespace perilymph::cli {

namespace {

using Json = nlohmann::ordered_json;

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

Json point(const std::optional<analysis::CurvePoint>& point)
{
  if (!point) return nullptr;
  // Points of the curve are at tenths of a millimeter; remove rounding errors.
  return {{"force_N", point->force},
          {"travel_mm", std::round(asMillimeters(point->travel) * 1e6) / 1e6}};
}

}  // namespace

std::string simulationJson(const session::Scenario& scenario, const analysis::ForceProfile& profile,
                           haptics::InsertionEnd end, analysis::Phase phase,
                           const haptics::LoopStatistics& statistics)
{
  Json json;
  json["version"] = version();
  json["build"] = buildId();
  json["seed"] = scenario.seed();
  json["scenario"] = scenarioAsRun(scenario);
  json["end"] = haptics::nameOf(end);
  json["peak_force_N"] = profile.peak.force;
  json["peak_travel_mm"] = asMillimeters(profile.peak.travel);
  json["peak_depth_mm"] = asMillimeters(profile.peakDepth);
  json["basal_turn_peak"] = point(profile.basalTurnPeak);
  json["basal_turn_dip"] = point(profile.basalTurnDip);
  json["work_J"] = profile.work;
  json["final_travel_mm"] = asMillimeters(profile.finalTravel);
  json["final_depth_mm"] = asMillimeters(profile.finalDepth);
  json["final_angle_deg"] = inDegrees(radians(profile.finalAngle));
  json["final_phase"] = analysis::phaseName(phase);
  json["deepest_mm"] = asMillimeters(profile.deepest);
  json["wall_force_max_N"] = profile.wallForceMax;
  json["membrane_force_max_N"] = profile.membraneForceMax;
  json["duration_s"] = profile.duration;
  json["ticks"] = profile.ticks;
  json["ticks_not_converged"] = profile.ticksNotConverged;
  json["overruns"] = statistics.overruns;
  return jsonText(json);
}

}  // namespace perilymph::cli
