// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/planning/PlanReading.h"

#include <cmath>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string_view>

#include "perilymph/foundation/AtomicFile.h"
#include "perilymph/planning/PlanReport.h"

namespace perilymph::planning {

namespace {

/// Key of Influence::finerAngleWidth_deg, which measures alone have.
constexpr const char* finerWidth = "angle_width_if_measured_to_0.1_mm_deg";

using Json = nlohmann::json;

constexpr double maxMagnitude = 1e9;
constexpr std::size_t maxSentence = 1000;

/// Thrown within this file only: what a text lacks.
struct Unreadable : std::runtime_error {
  using std::runtime_error::runtime_error;
};

const Json& at(const Json& parent, const char* key)
{
  const auto found = parent.is_object() ? parent.find(key) : parent.end();
  if (!parent.is_object() || found == parent.end())
    throw Unreadable(std::string(key) + " is missing");
  return *found;
}

double numberAt(const Json& parent, const char* key)
{
  const Json& value = at(parent, key);
  if (!value.is_number() || !(std::fabs(value.get<double>()) <= maxMagnitude))
    throw Unreadable(std::string(key) + " is not a number up to 1e9");
  return value.get<double>();
}

std::size_t countAt(const Json& parent, const char* key)
{
  const Json& value = at(parent, key);
  if (!value.is_number_unsigned() || value.get<std::uint64_t>() > std::size_t{1} << 32)
    throw Unreadable(std::string(key) + " is not a whole number");
  return value.get<std::size_t>();
}

std::string textAt(const Json& parent, const char* key)
{
  const Json& value = at(parent, key);
  if (!value.is_string() || value.get_ref<const std::string&>().size() > maxSentence)
    throw Unreadable(std::string(key) + " is not a text of at most 1000 letters");
  return value.get<std::string>();
}

std::string textOr(const Json& parent, const char* key)
{
  return parent.contains(key) ? textAt(parent, key) : std::string();
}

/// A list of at most `maxSize` entries.
const Json& listAt(const Json& parent, const char* key, std::size_t maxSize)
{
  const Json& value = at(parent, key);
  if (!value.is_array() || value.size() > maxSize)
    throw Unreadable(std::string(key) + " is not a list of at most " + std::to_string(maxSize));
  return value;
}

Band bandAt(const Json& parent, const char* key)
{
  const Json& value = at(parent, key);
  const Band band{numberAt(value, "p5"), numberAt(value, "p25"), numberAt(value, "median"),
                  numberAt(value, "p75"), numberAt(value, "p95")};
  if (!(band.low <= band.lowerQuartile && band.lowerQuartile <= band.median &&
        band.median <= band.upperQuartile && band.upperQuartile <= band.high))
    throw Unreadable(std::string(key) + " has quantiles that decrease");
  return band;
}

analysis::Estimate probabilityAt(const Json& parent, const char* key)
{
  const Json& value = at(parent, key);
  const Json& interval = listAt(value, "ci95", 2);
  if (interval.size() != 2 || !interval[0].is_number() || !interval[1].is_number())
    throw Unreadable(std::string(key) + " has no interval");
  const analysis::Estimate estimate{numberAt(value, "value"), interval[0].get<double>(),
                                    interval[1].get<double>()};
  if (!(0.0 <= estimate.low && estimate.low <= estimate.value && estimate.value <= estimate.high &&
        estimate.high <= 1.0))
    throw Unreadable(std::string(key) + " is not a probability within its interval");
  return estimate;
}

ArrayPlan arrayIn(const Json& value)
{
  ArrayPlan plan;
  plan.array = textAt(value, "array");
  plan.name = textAt(value, "name");
  plan.draws = countAt(value, "draws");
  for (const PlanQuantity& each : planQuantities()) plan.*each.band = bandAt(value, each.key);
  const Json& chances = at(value, "probability");
  for (const PlanProbability& each : planProbabilities())
    plan.*each.estimate = probabilityAt(chances, each.key);
  for (const Json& each : listAt(value, "force", maxStoredRows))
    plan.force.push_back(
        {numberAt(each, "depth_mm"), countAt(each, "draws"), bandAt(each, "force_mN")});
  for (const Json& each : listAt(value, "contacts", maxStoredRows))
    plan.contacts.push_back({static_cast<int>(countAt(each, "number")), countAt(each, "draws"),
                             bandAt(each, "angle_deg"), bandAt(each, "to_modiolus_mm"),
                             numberAt(each, "greenwood_Hz"), numberAt(each, "spiral_ganglion_Hz"),
                             numberAt(each, "filter_Hz"), bandAt(each, "mismatch_semitones")});
  for (const Json& each : listAt(value, "influence", maxStoredRows))
    plan.influences.push_back(
        {textAt(each, "input"), numberAt(each, "on_angle"), numberAt(each, "on_peak_force"),
         numberAt(each, "angle_width_if_known_deg"), numberAt(each, "peak_width_if_known_mN"),
         each.contains(finerWidth) ? numberAt(each, finerWidth) : 0.0});
  return plan;
}

anatomy::Patient patientIn(const Json& value)
{
  const auto length = [&value](const char* key) { return millimeters(numberAt(value, key)); };
  anatomy::Patient patient;
  patient.label = textAt(value, "label");
  patient.side = textAt(value, "side") == "left" ? anatomy::Side::left : anatomy::Side::right;
  anatomy::BasalTurn turn{length("A_mm"), length("B_mm"), std::nullopt};
  anatomy::BasalTurnErrors errors{length("A_sd_mm"), length("B_sd_mm")};
  if (value.contains("H_mm")) {
    turn.h = length("H_mm");
    errors.h = length("H_sd_mm");
  }
  for (const auto& [key, correlation] :
       {std::pair{"AB_correlation", &errors.ab}, std::pair{"AH_correlation", &errors.ah},
        std::pair{"BH_correlation", &errors.bh}})
    if (value.contains(key)) *correlation = numberAt(value, key);
  patient.basalTurn = turn;
  if (textAt(value, "errors") == "as measured") patient.errors = errors;
  patient.origin.seriesKey = textOr(value, "series_sha256");
  patient.origin.software = textOr(value, "measured_with");
  if (const auto possible = anatomy::checkPatient(patient); !possible)
    throw Unreadable("its patient is not possible (" + possible.error().message + ")");
  return patient;
}

StoredPlan storedIn(const Json& value)
{
  StoredPlan stored;
  stored.program = textAt(value, "program");
  stored.plan.fingerprint = textAt(value, "plan");
  PlanRequest& request = stored.plan.request;
  request.seed = countAt(value, "seed");
  request.scenario = textAt(value, "scenario");
  if (value.contains("friction")) request.friction = textAt(value, "friction");
  request.patient = patientIn(at(value, "patient"));
  const Json& thresholds = at(value, "thresholds");
  stored.plan.thresholds = {millinewtons(numberAt(thresholds, "felt_mN")),
                            millinewtons(numberAt(thresholds, "partition_weakest_mN")),
                            millinewtons(numberAt(thresholds, "partition_strongest_mN"))};
  for (const Json& each : listAt(value, "arrays", maxStoredArrays)) {
    stored.plan.arrays.push_back(arrayIn(each));
    request.arrays.push_back(stored.plan.arrays.back().array);
  }
  if (stored.plan.arrays.empty()) throw Unreadable("it has no array");
  for (const Json& each : listAt(value, "sources", maxStoredRows))
    stored.sources.push_back({textAt(each, "file"), textAt(each, "table"), textAt(each, "source"),
                              textAt(each, "confidence")});
  for (const Json& each : listAt(value, "limits", maxStoredRows)) {
    if (!each.is_string()) throw Unreadable("limits holds something that is no sentence");
    stored.limits.push_back(each.get<std::string>());
  }
  return stored;
}

}  // namespace

Result<StoredPlan> planIn(const std::string& text, const std::string& name)
{
  const auto refused = [&name](const std::string& reason) {
    return Error{name + " is not a plan: " + reason +
                 ". Give the folder that 'perilymph-cli plan' wrote."};
  };
  try {
    return storedIn(Json::parse(text));
  } catch (const Unreadable& error) {
    return refused(error.what());
  } catch (const nlohmann::json::exception&) {
    return refused("it is not JSON, or a value has another type");
  }
}

Result<StoredPlan> readPlan(const std::filesystem::path& place)
{
  std::error_code ignored;
  std::filesystem::path file = place;
  if (std::filesystem::is_directory(place, ignored))
    file = place / "plan.json";
  else if (place.extension() == ".sqlite")
    file = place.parent_path() / "plan.json";
  if (file != place && !std::filesystem::exists(file, ignored))
    return Error{place.string() +
                 " holds no plan.json: the plan was not finished. The same 'perilymph-cli plan' "
                 "continues it."};
  const auto text = readWhole(file);
  if (!text) return text.error();
  return planIn(*text, file.string());
}

}  // namespace perilymph::planning
