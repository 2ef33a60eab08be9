// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/planning/PlanReading.h"

#include <algorithm>
#include <array>
#include <limits>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <utility>

#include "PlanNames.h"
#include "PlanNumbers.h"
#include "perilymph/analysis/PhysicalRanges.h"
#include "perilymph/foundation/AtomicFile.h"
#include "perilymph/foundation/Utf8.h"
#include "perilymph/planning/PlanReport.h"

namespace perilymph::planning {

namespace {

/// Key of Influence::finerAngleWidth_deg, which measures alone have.
constexpr const char* finerWidth = "angle_width_if_measured_to_0.1_mm_deg";

using Json = nlohmann::json;

namespace physical = analysis::physical;
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

/// A number within a range, which the key's unit is that of.
double numberAt(const Json& parent, const char* key, Range range)
{
  const Json& value = at(parent, key);
  if (!value.is_number()) throw Unreadable(std::string(key) + " is not a number");
  const double number = value.get<double>();
  if (auto reason = analysis::impossibility(key, "", number, range); !reason.empty())
    throw Unreadable(std::move(reason));
  return number;
}

std::size_t countAt(const Json& parent, const char* key,
                    std::uint64_t highest = std::uint64_t{1} << 32)
{
  const Json& value = at(parent, key);
  if (!value.is_number_unsigned() || value.get<std::uint64_t>() > highest)
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

/// The value of a name in a table of choices.
template <class Value, std::size_t count>
Value choiceAt(const Json& parent, const char* key, const std::array<Choice<Value>, count>& table)
{
  const std::string name = textAt(parent, key);
  if (const auto value = valueIn(table, name)) return *value;
  std::string names;
  for (const auto& row : table) names += (names.empty() ? "" : " or ") + std::string(row.name);
  throw Unreadable(std::string(key) + " is \"" + onOneLine(name) + "\"; it must be " + names);
}

/// A list of at most `maxSize` entries.
const Json& listAt(const Json& parent, const char* key, std::size_t maxSize)
{
  const Json& value = at(parent, key);
  if (!value.is_array() || value.size() > maxSize)
    throw Unreadable(std::string(key) + " is not a list of at most " + std::to_string(maxSize));
  return value;
}

Band bandAt(const Json& parent, const char* key, Range range)
{
  const Json& value = at(parent, key);
  Band band;
  for (const auto& [quantile, number] :
       {std::pair{"p5", &band.low}, std::pair{"p25", &band.lowerQuartile},
        std::pair{"median", &band.median}, std::pair{"p75", &band.upperQuartile},
        std::pair{"p95", &band.high}}) {
    const Json& given = at(value, quantile);
    if (!given.is_number())
      throw Unreadable(quantile + std::string(" of ") + key + " is not a number");
    *number = given.get<double>();
    if (auto reason = analysis::impossibility(key, "", *number, range); !reason.empty())
      throw Unreadable(std::move(reason));
  }
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
  const analysis::Estimate estimate{numberAt(value, "value", physical::fraction),
                                    interval[0].get<double>(), interval[1].get<double>()};
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
  for (const PlanQuantity& each : planQuantities())
    if (each.isInFirstVersions || value.contains(each.key))
      plan.*each.band = bandAt(value, each.key, each.range);
  const Json& chances = at(value, "probability");
  constexpr double notStated = std::numeric_limits<double>::quiet_NaN();
  for (const PlanProbability& each : planProbabilities()) {
    const bool isFormer = each.formerKey != nullptr && !chances.contains(each.key);
    plan.*each.estimate = each.isInFirstVersions || chances.contains(each.key)
                              ? probabilityAt(chances, isFormer ? each.formerKey : each.key)
                              : analysis::Estimate{notStated, notStated, notStated};
  }
  if (value.contains("at_median_friction"))
    for (const FrictionQuantity& each : frictionQuantities)
      plan.atMedianFriction.emplace(plan.atMedianFriction.value_or(AtMedianFriction{})).*each.band =
          bandAt(at(value, "at_median_friction"), each.key, each.range);
  if (value.contains("in_clinic")) {
    const Json& clinic = at(value, "in_clinic");
    plan.inClinic =
        InClinic{bandAt(clinic, "depth_mm", physical::depth_mm),
                 numberAt(clinic, "effective_simulations", {0.0, static_cast<double>(maxDraws)})};
  }
  for (const Json& each : listAt(value, "force", maxStoredRows))
    plan.force.push_back({numberAt(each, "depth_mm", physical::depth_mm), countAt(each, "draws"),
                          bandAt(each, "force_mN", physical::signedForce_mN)});
  for (const Json& each : listAt(value, "contacts", maxStoredRows)) {
    plan.contacts.push_back({static_cast<int>(countAt(each, "number")), countAt(each, "draws"),
                             bandAt(each, "angle_deg", physical::angle_deg),
                             bandAt(each, "to_modiolus_mm", physical::toModiolus_mm),
                             numberAt(each, "greenwood_Hz", physical::frequency_Hz),
                             numberAt(each, "spiral_ganglion_Hz", physical::frequency_Hz),
                             numberAt(each, "filter_Hz", physical::frequency_Hz),
                             bandAt(each, "mismatch_semitones", physical::semitones)});
    if (!each.contains("greenwood_p5_Hz")) continue;  // of a former version
    ContactBand& contact = plan.contacts.back();
    contact.greenwoodLow_Hz = numberAt(each, "greenwood_p5_Hz", physical::frequency_Hz);
    contact.greenwoodHigh_Hz = numberAt(each, "greenwood_p95_Hz", physical::frequency_Hz);
  }
  const Range width_deg{0.0, physical::angle_deg.high - physical::angle_deg.low};
  for (const Json& each : listAt(value, "influence", maxStoredRows))
    plan.influences.push_back(
        {textAt(each, "input"), numberAt(each, "on_angle", physical::fraction),
         numberAt(each, "on_peak_force", physical::fraction),
         numberAt(each, "angle_width_if_known_deg", width_deg),
         numberAt(each, "peak_width_if_known_mN", physical::force_mN),
         each.contains(finerWidth) ? numberAt(each, finerWidth, width_deg) : 0.0});
  return plan;
}

ArrayDifference differenceIn(const Json& value, const std::vector<std::string>& arrays)
{
  const auto place = [&](const char* key) {
    const auto found = std::ranges::find(arrays, textAt(value, key));
    if (found == arrays.end()) throw Unreadable(std::string(key) + " is none of its arrays");
    return static_cast<std::size_t>(found - arrays.begin());
  };
  ArrayDifference difference;
  difference.first = place("first");
  difference.second = place("second");
  difference.draws = countAt(value, "draws");
  for (const DifferenceQuantity& each : differenceQuantities)
    difference.*each.band = bandAt(value, each.key, each.range);
  for (const DifferenceProbability& each : differenceProbabilities)
    difference.*each.estimate = probabilityAt(at(value, "probability"), each.key);
  return difference;
}

anatomy::Patient patientIn(const Json& value)
{
  const auto length = [&value](const char* key, Range range) {
    return millimeters(numberAt(value, key, range));
  };
  constexpr Range error_mm{0.0, 2.0};
  anatomy::Patient patient;
  patient.label = textAt(value, "label");
  patient.side = choiceAt(value, "side", anatomy::sides);
  anatomy::BasalTurn turn{length("A_mm", physical::a_mm), length("B_mm", physical::b_mm),
                          std::nullopt};
  anatomy::BasalTurnErrors errors{length("A_sd_mm", error_mm), length("B_sd_mm", error_mm)};
  if (value.contains("H_mm")) {
    turn.h = length("H_mm", physical::h_mm);
    errors.h = length("H_sd_mm", error_mm);
  }
  for (const auto& [key, correlation] :
       {std::pair{"AB_correlation", &errors.ab}, std::pair{"AH_correlation", &errors.ah},
        std::pair{"BH_correlation", &errors.bh}})
    if (value.contains(key)) *correlation = numberAt(value, key, {-1.0, 1.0});
  patient.basalTurn = turn;
  if (choiceAt(value, "errors", errorSources) == ErrorSource::measured) patient.errors = errors;
  patient.origin.seriesKey = textOr(value, "series_sha256");
  patient.origin.software = textOr(value, "measured_with");
  if (value.contains("seal")) patient.seal = choiceAt(value, "seal", seals);
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
  request.seed = countAt(value, "seed", maxSeed);
  request.scenario = textAt(value, "scenario");
  if (value.contains("friction")) request.friction = textAt(value, "friction");
  if (value.contains("approach")) {
    constexpr Range approach_deg{-anatomy::steepestApproach_deg, anatomy::steepestApproach_deg};
    const Json& approach = at(value, "approach");
    request.approach = anatomy::Approach{degrees(numberAt(approach, "tilt_deg", approach_deg)),
                                         degrees(numberAt(approach, "turn_deg", approach_deg))};
  }
  request.patient = patientIn(at(value, "patient"));
  const Json& thresholds = at(value, "thresholds");
  stored.plan.thresholds = {
      millinewtons(numberAt(thresholds, "felt_mN", physical::force_mN)),
      millinewtons(numberAt(thresholds, "partition_weakest_mN", physical::partition_mN)),
      millinewtons(numberAt(thresholds, "partition_strongest_mN", physical::partition_mN))};
  if (value.contains("friction_range")) {
    const Json& range = listAt(value, "friction_range", 2);
    if (range.size() != 2 || !range[0].is_number() || !range[1].is_number())
      throw Unreadable("friction_range is not two numbers");
    stored.plan.friction = {range[0].get<double>(), range[1].get<double>()};
    for (const double each : {stored.plan.friction.low, stored.plan.friction.high})
      if (auto reason = analysis::impossibility("friction_range", "", each, {0.0, 2.0});
          !reason.empty())
        throw Unreadable(std::move(reason));
  }
  if (value.contains("friction_sd_log"))
    stored.plan.frictionSpread = numberAt(value, "friction_sd_log", {0.0, 2.0});
  if (value.contains("clinic_resistance")) {
    const Json& clinic = at(value, "clinic_resistance");
    constexpr Range years{0.0, 9999.0};
    stored.plan.clinic = ClinicSource{textAt(clinic, "number"),
                                      countAt(clinic, "stopped_by_resistance"),
                                      countAt(clinic, "censored"),
                                      countAt(clinic, "not_informative"),
                                      static_cast<int>(numberAt(clinic, "first_year", years)),
                                      static_cast<int>(numberAt(clinic, "last_year", years))};
  }
  for (const Json& each : listAt(value, "arrays", maxStoredArrays)) {
    stored.plan.arrays.push_back(arrayIn(each));
    request.arrays.push_back(stored.plan.arrays.back().array);
  }
  if (stored.plan.arrays.empty()) throw Unreadable("it has no array");
  if (value.contains("differences"))
    for (const Json& each : listAt(value, "differences", maxStoredRows))
      stored.plan.differences.push_back(differenceIn(each, request.arrays));
  for (const Json& each : listAt(value, "sources", maxStoredRows)) {
    choiceAt(each, "confidence", confidences);
    stored.sources.push_back({textAt(each, "file"), textAt(each, "table"), textAt(each, "source"),
                              textAt(each, "confidence")});
  }
  std::vector<Phrase> limits;
  for (const auto* list : {&limitsOfPlans(), &formerLimitsOfPlans()})
    for (const Sentence& each : *list) limits.emplace_back(each.phrase());
  limits.emplace_back(clinicSentence({}).phrase());
  for (const Json& each : listAt(value, "limits", maxStoredRows)) {
    if (!each.is_string()) throw Unreadable("limits holds something that is no sentence");
    stored.limits.push_back(recognized(each.get<std::string>(), limits));
  }
  return stored;
}

}  // namespace

Result<StoredPlan> planIn(const std::string& text, const std::string& name)
{
  const auto refused = [&name](const std::string& reason) {
    return Error{"%1 is not a plan: %2. Give the folder that 'perilymph-cli plan' wrote.", name,
                 reason};
  };
  try {
    const Json json = Json::parse(text);
    const std::uint64_t format =
        json.is_object() && json.contains("format") ? countAt(json, "format") : 1;
    if (format > planFormat)
      return Error{"%1 is of a newer program (format %2). Open it with that one.", name, format};
    StoredPlan stored = storedIn(json);
    stored.text = text;
    stored.plan.seal = sealIn(text, format >= firstSealedPlanFormat, stored.program);
    if (stored.plan.seal == Seal::changed) stored.plan.fingerprint.clear();
    if (stored.plan.seal == Seal::absent)
      stored.limits.push_back(Sentence{
          "The force on the partition is the sum on the basilar membrane, as former versions "
          "computed "
          "it: not the force that ruptures."});
    return stored;
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
    return Error{
        "%1 holds no plan.json: the plan was not finished. The same 'perilymph-cli plan' continues "
        "it.",
        place};
  const auto text = readWhole(file);
  if (!text) return text.error();
  return planIn(*text, file.string());
}

}  // namespace perilymph::planning
