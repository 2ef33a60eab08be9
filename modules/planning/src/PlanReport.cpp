// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/planning/PlanReport.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "ClinicalJson.h"
#include "FrequencyAllocation.h"
#include "PlanNames.h"
#include "PlanNumbers.h"
#include "Uncertainty.h"
#include "perilymph/analysis/ClinicalReports.h"
#include "perilymph/analysis/ErrorBand.h"
#include "perilymph/analysis/PhysicalRanges.h"
#include "perilymph/analysis/Surgeon.h"
#include "perilymph/foundation/Resources.h"
#include "perilymph/foundation/TomlReader.h"
#include "perilymph/foundation/Version.h"
#include "perilymph/planning/ForceCourse.h"
#include "perilymph/planning/PlanWords.h"
#include "perilymph/session/Csv.h"

namespace perilymph::planning {

namespace {

using nlohmann::ordered_json;
namespace ink = figures::ink;

namespace physical = analysis::physical;

constexpr PlanQuantity quantities[] = {
    {"angle_deg", &ArrayPlan::angle_deg, physical::angle_deg},
    {"coverage_percent", &ArrayPlan::coverage_percent, physical::percent},
    {"depth_mm", &ArrayPlan::depth_mm, physical::depth_mm},
    {"peak_mN", &ArrayPlan::peak_mN, physical::force_mN},
    {"end_mN", &ArrayPlan::end_mN, physical::signedForce_mN},
    {"partition_mN", &ArrayPlan::partition_mN, physical::partition_mN},
    {"first_resistance_mm", &ArrayPlan::firstResistance_mm, physical::depth_mm},
    {"force_after_1s_mN", &ArrayPlan::after1s_mN, physical::signedForce_mN, false},
    {"force_after_10s_mN", &ArrayPlan::after10s_mN, physical::signedForce_mN, false}};

constexpr PlanProbability probabilities[] = {
    {"intended_depth_reached", &ArrayPlan::full, true, "full_insertion"},
    {"stopped_by_resistance", &ArrayPlan::resisted},
    {"buckled", &ArrayPlan::buckled},
    {"folded_tip", &ArrayPlan::foldedTip},
    {"other_end", &ArrayPlan::other},
    {"partition_ruptured", &ArrayPlan::ruptured},
    {"translocated", &ArrayPlan::translocated},
    {"partition_reaches_weakest", &ArrayPlan::reachesWeakest},
    {"partition_reaches_strongest", &ArrayPlan::reachesStrongest},
    {"resistance_felt", &ArrayPlan::felt},
    {"all_contacts_inside", &ArrayPlan::allInside, false}};

ordered_json bandJson(const Band& band)
{
  return {{"p5", rounded(band.low)},
          {"p25", rounded(band.lowerQuartile)},
          {"median", rounded(band.median)},
          {"p75", rounded(band.upperQuartile)},
          {"p95", rounded(band.high)}};
}

ordered_json probabilityJson(const analysis::Estimate& estimate)
{
  return {{"value", rounded(estimate.value)},
          {"ci95", {rounded(estimate.low), rounded(estimate.high)}}};
}

ordered_json differenceJson(const Plan& plan, const ArrayDifference& difference)
{
  ordered_json json = {{"first", plan.arrays[difference.first].array},
                       {"second", plan.arrays[difference.second].array},
                       {"draws", difference.draws}};
  for (const DifferenceQuantity& each : differenceQuantities)
    json[each.key] = bandJson(difference.*each.band);
  for (const DifferenceProbability& each : differenceProbabilities)
    json["probability"][each.key] = probabilityJson(difference.*each.estimate);
  return json;
}

ordered_json arrayJson(const ArrayPlan& plan)
{
  ordered_json json = {{"array", plan.array}, {"name", plan.name}, {"draws", plan.draws}};
  for (const PlanQuantity& each : quantities) json[each.key] = bandJson(plan.*each.band);
  if (plan.atMedianFriction)
    for (const FrictionQuantity& each : frictionQuantities)
      json["at_median_friction"][each.key] = bandJson(*plan.atMedianFriction.*each.band);
  if (plan.inClinic)
    json["in_clinic"] = {{"depth_mm", bandJson(plan.inClinic->depth_mm)},
                         {"effective_simulations", rounded(plan.inClinic->effective)}};
  for (const PlanProbability& each : probabilities)
    json["probability"][each.key] = probabilityJson(plan.*each.estimate);
  json["force"] = ordered_json::array();
  for (const ForceBand& each : plan.force)
    json["force"].push_back({{"depth_mm", rounded(each.depth_mm)},
                             {"draws", each.draws},
                             {"force_mN", bandJson(each.force_mN)}});
  json["contacts"] = ordered_json::array();
  for (const ContactBand& each : plan.contacts) {
    json["contacts"].push_back({{"number", each.number},
                                {"draws", each.draws},
                                {"angle_deg", bandJson(each.angle_deg)},
                                {"to_modiolus_mm", bandJson(each.toModiolus_mm)},
                                {"greenwood_Hz", rounded(each.greenwood_Hz)},
                                {"spiral_ganglion_Hz", rounded(each.spiralGanglion_Hz)},
                                {"filter_Hz", rounded(each.filter_Hz)},
                                {"mismatch_semitones", bandJson(each.mismatch_semitones)}});
    if (each.greenwoodHigh_Hz <= 0.0) continue;
    json["contacts"].back()["greenwood_p5_Hz"] = rounded(each.greenwoodLow_Hz);
    json["contacts"].back()["greenwood_p95_Hz"] = rounded(each.greenwoodHigh_Hz);
  }
  json["influence"] = ordered_json::array();
  for (const Influence& each : plan.influences) {
    ordered_json influence = {{"input", each.input},
                              {"on_angle", rounded(each.onAngle)},
                              {"on_peak_force", rounded(each.onPeak)},
                              {"angle_width_if_known_deg", rounded(each.angleWidth_deg)},
                              {"peak_width_if_known_mN", rounded(each.peakWidth_mN)}};
    if (each.finerAngleWidth_deg > 0.0)
      influence["angle_width_if_measured_to_0.1_mm_deg"] = rounded(each.finerAngleWidth_deg);
    json["influence"].push_back(std::move(influence));
  }
  json["clinical"] = clinicalJson(plan.array);
  return json;
}

ordered_json patientJson(const anatomy::Patient& patient)
{
  const anatomy::BasalTurn& turn = *patient.basalTurn;
  const anatomy::BasalTurnErrors errors = analysis::errorsOf(patient);
  ordered_json json = {{"label", patient.label},
                       {"side", anatomy::nameOf(patient.side)},
                       {"A_mm", rounded(inMillimeters(turn.a))},
                       {"A_sd_mm", rounded(inMillimeters(errors.a))},
                       {"B_mm", rounded(inMillimeters(turn.b))},
                       {"B_sd_mm", rounded(inMillimeters(errors.b))}};
  if (turn.h) {
    json["H_mm"] = rounded(inMillimeters(*turn.h));
    json["H_sd_mm"] = rounded(inMillimeters(errors.h.value_or(analysis::measuringError)));
  }
  json["errors"] =
      nameIn(errorSources, patient.errors ? ErrorSource::measured : ErrorSource::assumed);
  for (const auto& [key, correlation] :
       {std::pair{"AB_correlation", errors.ab}, std::pair{"AH_correlation", errors.ah},
        std::pair{"BH_correlation", errors.bh}})
    if (correlation != 0.0) json[key] = rounded(correlation);
  if (!patient.origin.seriesKey.empty()) json["series_sha256"] = patient.origin.seriesKey;
  if (!patient.origin.software.empty()) json["measured_with"] = patient.origin.software;
  if (patient.seal != Seal::intact) json["seal"] = nameOf(patient.seal);
  return json;
}

template <class Provenance>
void addSources(ordered_json& list, const char* file, const std::vector<Provenance>& provenance)
{
  for (const Provenance& each : provenance)
    list.push_back({{"file", file},
                    {"table", each.table},
                    {"source", each.source},
                    {"confidence", each.confidence}});
}

/// The sources of the tapers that are drawn: those of the arrays' files that are there.
void addTaperSources(ordered_json& list, const PlanRequest& request)
{
  for (const std::string& name : request.arrays) {
    const auto file = findByName("array", "plugins/electrodes", name);
    if (!file) continue;
    const auto array = electrode::loadArray(*file);
    if (!array) continue;
    for (const auto& [table, provenance] : array->provenance)
      if (table == "taper")
        list.push_back({{"file", file->filename().string()},
                        {"table", table},
                        {"source", provenance.source},
                        {"confidence", electrode::nameOf(provenance.confidence)}});
  }
}

/// The source of a friction that states its own spread, in place of that of the usual spread.
void addFrictionSource(ordered_json& list, const PlanRequest& request)
{
  std::string name = request.friction.value_or("");
  if (name.empty()) {
    const auto file = findByName("scenario", "resources/scenarios", request.scenario);
    auto scenario = file ? TomlReader::open(*file) : Result<TomlReader>(file.error());
    if (!scenario) return;
    name = scenario->text("friction", "");
  }
  const auto file = findByName("friction", "resources/friction", name);
  auto reader = file ? TomlReader::open(*file) : Result<TomlReader>(file.error());
  if (!reader) return;
  for (const char* table : {"coefficients", "spread"}) {
    TomlReader values = reader->table(table);
    list.push_back({{"file", "friction/" + file->filename().string()},
                    {"table", "friction"},
                    {"source", values.text("source", "")},
                    {"confidence", values.text("confidence", "low")}});
  }
}

figures::Figure forceFigure(const Plan& plan, const ArrayPlan& array)
{
  figures::Figure figure;
  figure.title = array.name + ": insertion force over depth";
  addForceCourse(figure, array, {"median", bandsHold(plan), "25 to 75 %", "simulations ended"},
                 ink::blue);
  double top = 10.0, deepest = 1.0;
  for (const ForceBand& each : array.force) {
    top = std::max(top, each.force_mN.high);
    deepest = std::max(deepest, each.depth_mm);
  }
  figure.x = figures::axisOver("insertion depth, mm", 0.0, deepest);
  figure.y = figures::axisOver("axial insertion force, mN", 0.0, top);
  figure.notes.push_back(std::to_string(array.draws) +
                         " simulations; behind the depth that all of them reached paler and "
                         "dashed, with the number that came that deep.");
  return figure;
}

figures::Figure angleFigure(const Plan& plan)
{
  figures::Figure figure;
  figure.title = "Angular insertion depth: median (" + bandsHold(plan) + ")";
  figures::FigureValues values, median;
  figures::FigureValues clinics;
  values.ink = ink::blue;
  values.label = Sentence{"simulated"};
  median.ink = ink::vermilion;
  median.label = Sentence{"simulated, at the median friction"};
  clinics.ink = ink::green;
  clinics.label = Sentence{"clinics report"};
  double top = 90.0;
  constexpr double beside = 0.15;
  const auto& evidence = analysis::ClinicalEvidence::shipped();
  const auto add = [](figures::FigureValues& to, double x, const Band& band) {
    to.x.push_back(x);
    to.y.push_back(band.median);
    to.low.push_back(band.low);
    to.high.push_back(band.high);
  };
  for (std::size_t i = 0; i < plan.arrays.size(); ++i) {
    const Band& band = plan.arrays[i].angle_deg;
    add(values, static_cast<double>(i + 1), band);
    if (const auto& other = plan.arrays[i].atMedianFriction)
      add(median, static_cast<double>(i + 1) + beside, other->angle_deg);
    top = std::max(top, band.high);
    std::string note = std::to_string(i + 1) + ": " + plan.arrays[i].name;
    const analysis::ClinicalReport* report =
        evidence ? evidence->find(plan.arrays[i].array, analysis::ReportedQuantity::angle)
                 : nullptr;
    if (report != nullptr && report->value) {
      const bool isBounded = report->spread != analysis::ReportedSpread::none;
      add(clinics, static_cast<double>(i + 1) + 2.0 * beside,
          {isBounded ? report->low : *report->value, 0.0, *report->value, 0.0,
           isBounded ? report->high : *report->value});
      top = std::max(top, clinics.high.back());
      note += "; clinics: " + report->statistic + " " + analysis::numbersOf(*report) + " deg" +
              (report->n > 0 ? ", n " + std::to_string(report->n) : std::string()) +
              (report->nOf.empty() ? std::string() : " of " + report->nOf) + ", " + report->source +
              " (" + report->definition + ")";
      if (evidence->verdictOf(plan.arrays[i].array) == analysis::ArrayVerdict::miss)
        note += "; simulated: not validated";
    }
    figure.notes.push_back(note);
  }
  figure.values = {values};
  if (!median.x.empty()) figure.values.push_back(median);
  if (!clinics.x.empty()) figure.values.push_back(clinics);
  figure.x = {"array", 0.5, static_cast<double>(plan.arrays.size()) + 0.5, 1.0, 0};
  figure.y = figures::axisOver("angle of the most apical contact, deg", 0.0, top);
  return figure;
}

/// Ranked bars: by how much the bands of angle and peak force would be narrower if an input were known.
figures::Figure influenceFigure(const ArrayPlan& plan)
{
  constexpr std::size_t maxBars = 8;
  constexpr double width = 0.35;
  figures::Figure figure;
  figure.title = plan.name + ": what the band's width rests on";
  const auto addBar = [&](const Sentence& label, std::size_t i, double from, double known,
                          figures::Ink color) {
    const double x = static_cast<double>(i) + 1.0 + from;
    const double narrower = 100.0 * (1.0 - std::sqrt(std::max(0.0, 1.0 - known)));
    figure.bands.push_back(
        {i == 0 ? label : Sentence(), {x, x + width}, {0.0, 0.0}, {narrower, narrower}, color});
  };
  std::vector<Influence> largest = plan.influences;
  std::stable_sort(largest.begin(), largest.end(), [](const Influence& a, const Influence& b) {
    return std::max(a.onAngle, a.onPeak) > std::max(b.onAngle, b.onPeak);
  });
  const std::size_t bars = std::min(maxBars, largest.size());
  for (std::size_t i = 0; i < bars; ++i) {
    const Influence& each = largest[i];
    addBar("angular insertion depth", i, -width, each.onAngle, ink::tint(ink::blue, 0.8));
    addBar("peak force", i, 0.0, each.onPeak, ink::tint(ink::vermilion, 0.5));
    std::string note = std::to_string(i + 1) + ": " + each.input;
    if (each.finerAngleWidth_deg > 0.0)
      note += "; measured to 0.1 mm: 90 % band of the angle " +
              session::shortestDecimal(std::round(each.finerAngleWidth_deg)) + " instead of " +
              session::shortestDecimal(std::round(plan.angle_deg.high - plan.angle_deg.low)) +
              " deg";
    figure.notes.push_back(note);
  }
  figure.x = {"input", 0.5, static_cast<double>(std::max<std::size_t>(bars, 1)) + 0.5, 1.0, 0};
  figure.y = figures::axisOver("narrower if it were known, %", 0.0, 100.0);
  figure.notes.push_back(
      "1 - sqrt(1 - r^2) with the squared rank correlation r^2 over " + std::to_string(plan.draws) +
      " simulations, adjusted for chance and, where all add up to more, reduced "
      "to a sum of 1. The " +
      std::to_string(bars) + " largest inputs of " + std::to_string(largest.size()) + ".");
  return figure;
}

}  // namespace

const std::vector<Sentence>& limitsOfPlans()
{
  static const std::vector<Sentence> limits = {
      Sentence{
          "The shape of the cochlea is the mean one, scaled to A, B and H; sections, course of the "
          "center line and outer wall vary along it as in few measured ears. Outline and tilt of "
          "the "
          "sections are those of the mean."},
      Sentence{
          "The partition ruptures at one strength, bone and membrane alike, into a mirrored scala "
          "vestibuli. The model gives fewer translocations than clinics report."},
      Sentence{
          "Insertions have longer steps than the scenario: their median angle differs by up to %1 "
          "degrees.",
          9},
      Sentence{"No friction in a living ear is known. The default is an estimate from pig tissue, "
               "median %1; "
               "95 % of what is drawn for the simulations lie from %2 to %3. A second inversion of "
               "the same "
               "curves gives %4. Frictions chosen by name are drawn about their own values.",
               "0.165", "0.08", "0.33", "0.27"},
      Sentence{"Errors of A, B and H are independent unless the patient's file states their "
               "correlations."},
      Sentence{"The strength of the cochlear partition and the surgeon's force limit rest on few "
               "publications; see sources."},
      Sentence{"Ends are those of the model: a probability is not a clinical risk."}};
  return limits;
}

Sentence clinicSentence(const ClinicSource& clinic)
{
  return Sentence{
      "Depths in this clinic rest on its resistance, number %1: %2 outcomes that ended by "
      "resistance, %3 that ended before, %4 that tell nothing, %5 to %6. They move neither forces "
      "nor ruptures.",
      clinic.number.substr(0, 8),
      clinic.resisted,
      clinic.censored,
      clinic.uninformative,
      clinic.firstYear,
      clinic.lastYear};
}

const std::vector<Sentence>& formerLimitsOfPlans()
{
  static const std::vector<Sentence> limits = {
      Sentence{"No friction in a living ear is known. The default, %1, is the low end of what is "
               "reported "
               "for arrays on endosteum, chosen with the depths in view that clinics report: four "
               "of five "
               "straight arrays come within %2 degrees of them, FLEXSOFT stops %3 short. With the "
               "friction "
               "of a tissue simulant straight arrays stop at %4 to %5.",
               "0.12", 20, 80, 240, 350}};
  return limits;
}

std::span<const PlanQuantity> planQuantities() { return quantities; }

std::span<const PlanProbability> planProbabilities() { return probabilities; }

Result<std::string> planJson(const Plan& plan)
{
  if (plan.seal != Seal::intact) return Error{noteOn(plan.seal)};
  const auto hand = analysis::shippedHand();
  if (!hand) return hand.error();
  const auto uncertainty = shippedUncertainty();
  if (!uncertainty) return uncertainty.error();
  const auto allocations = shippedAllocations();
  if (!allocations) return allocations.error();
  ordered_json json = {{"format", planFormat},
                       {"program", "Perilymph " + version()},
                       {"plan", plan.fingerprint},
                       {"seed", plan.request.seed},
                       {"scenario", plan.request.scenario}};
  if (plan.request.friction) json["friction"] = *plan.request.friction;
  if (const auto& approach = plan.request.approach)
    json["approach"] = {{"tilt_deg", rounded(inDegrees(approach->tilt))},
                        {"turn_deg", rounded(inDegrees(approach->turn))}};
  json["patient"] = patientJson(plan.request.patient);
  json["thresholds"] = {
      {"felt_mN", rounded(inMillinewtons(plan.thresholds.felt))},
      {"partition_weakest_mN", rounded(inMillinewtons(plan.thresholds.ruptureLow))},
      {"partition_strongest_mN", rounded(inMillinewtons(plan.thresholds.ruptureHigh))}};
  json["bands_hold"] = bandsHold(plan);
  if (std::isfinite(plan.friction.low) && std::isfinite(plan.friction.high))
    json["friction_range"] = {plan.friction.low, plan.friction.high};
  if (plan.frictionSpread > 0.0) json["friction_sd_log"] = rounded(plan.frictionSpread);
  if (plan.clinic)
    json["clinic_resistance"] = {
        {"number", plan.clinic->number},        {"stopped_by_resistance", plan.clinic->resisted},
        {"censored", plan.clinic->censored},    {"not_informative", plan.clinic->uninformative},
        {"first_year", plan.clinic->firstYear}, {"last_year", plan.clinic->lastYear}};
  json["arrays"] = ordered_json::array();
  for (const ArrayPlan& each : plan.arrays) json["arrays"].push_back(arrayJson(each));
  json["differences"] = ordered_json::array();
  for (const ArrayDifference& each : plan.differences)
    json["differences"].push_back(differenceJson(plan, each));
  json["sources"] = ordered_json::array();
  auto ofHand = hand->provenance;
  if (plan.frictionSpread > 0.0) {
    std::erase_if(ofHand, [](const auto& each) { return each.table == "friction"; });
    addFrictionSource(json["sources"], plan.request);
  }
  addSources(json["sources"], "clinical/hand.toml", ofHand);
  addSources(json["sources"], "planning/uncertainty.toml", uncertainty->provenance);
  json["sources"].push_back({{"file", "clinical/wires.toml"},
                             {"table", "wires"},
                             {"source", uncertainty->packing.source},
                             {"confidence", uncertainty->packing.confidence}});
  addTaperSources(json["sources"], plan.request);
  for (const FrequencyAllocation& each : *allocations)
    json["sources"].push_back({{"file", "planning/frequency-allocation.toml"},
                               {"table", each.maker},
                               {"source", each.source},
                               {"confidence", each.confidence}});
  json["limits"] = limitsOfPlans();
  if (plan.clinic) json["limits"].push_back(clinicSentence(*plan.clinic));
  json[sealKey] = sealToBe();
  return sealed(json.dump(2) + "\n");
}

std::vector<std::pair<std::string, figures::Figure>> planFigures(const Plan& plan)
{
  std::vector<std::pair<std::string, figures::Figure>> figures = {{"angle", angleFigure(plan)}};
  for (std::size_t i = 0; i < plan.arrays.size(); ++i) {
    figures.emplace_back("force-" + std::to_string(i + 1), forceFigure(plan, plan.arrays[i]));
    if (!plan.arrays[i].influences.empty())
      figures.emplace_back("influence-" + std::to_string(i + 1), influenceFigure(plan.arrays[i]));
  }
  return figures;
}

}  // namespace perilymph::planning
