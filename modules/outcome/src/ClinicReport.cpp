// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "perilymph/analysis/ColumnDictionary.h"
#include "perilymph/foundation/CsvField.h"
#include "perilymph/foundation/Seal.h"
#include "perilymph/foundation/Version.h"
#include "perilymph/outcome/ClinicOutcomes.h"
#include "perilymph/session/Csv.h"

namespace perilymph::outcome {

namespace {

using nlohmann::ordered_json;
namespace ink = figures::ink;

constexpr std::uint64_t outcomesFormat = 1;

/// A number to four decimals: more would be noise.
double rounded(double value)
{
  constexpr double scale = 1e4;
  return std::isfinite(value) ? std::round(value * scale) / scale : 0.0;
}

const char* nameOf(Evidence evidence)
{
  switch (evidence) {
    case Evidence::resisted:
      return "resisted";
    case Evidence::censored:
      return "censored";
    case Evidence::none:
      break;
  }
  return "none";
}

ordered_json bandJson(const planning::Band& band)
{
  return {{"p5", rounded(band.low)},
          {"p25", rounded(band.lowerQuartile)},
          {"median", rounded(band.median)},
          {"p75", rounded(band.upperQuartile)},
          {"p95", rounded(band.high)}};
}

ordered_json coverageJson(std::size_t hits, const analysis::Estimate& share)
{
  return {{"inside", hits},
          {"value", rounded(share.value)},
          {"ci95", {rounded(share.low), rounded(share.high)}}};
}

ordered_json hitsJson(const BandHits& hits)
{
  return {{"ears", hits.all},
          {"band50", coverageJson(hits.inHalf, hits.half())},
          {"band90", coverageJson(hits.inNinety, hits.ninety())}};
}

ordered_json arrayJson(const ArrayOutcomes& arrays)
{
  ordered_json json = {{"array", arrays.array},
                       {"depth", hitsJson(arrays.depth)},
                       {"angle", hitsJson(arrays.angle)},
                       {"depth_percentiles", arrays.depthPercentiles},
                       {"angle_percentiles", arrays.anglePercentiles}};
  if (const auto mean = analysis::meanWithInterval(arrays.depthDifferences_mm))
    json["depth_difference_mm"] = {{"mean", rounded(mean->value)},
                                   {"ci95", {rounded(mean->low), rounded(mean->high)}}};
  return json;
}

ordered_json earJson(const ScoredOutcome& ear, std::size_t number)
{
  ordered_json json = {{"number", number},
                       {"year", ear.year},
                       {"array", ear.array},
                       {"stop_reason", nameIn(stopReasons, ear.stopReason)},
                       {"evidence", nameOf(ear.evidence)},
                       {"depth_mm", rounded(ear.depth_mm.value)},
                       {"depth_sd_mm", rounded(ear.depth_mm.sd)},
                       {"planned_depth_mm", bandJson(ear.plannedDepth_mm)},
                       {"depth_percentile", rounded(ear.percentile)}};
  if (ear.anglePercentile) {
    json["angle_deg"] = rounded(ear.angle_deg->value);
    json["angle_sd_deg"] = rounded(ear.angle_deg->sd);
    json["planned_angle_deg"] = bandJson(ear.plannedAngle_deg);
    json["angle_percentile"] = rounded(*ear.anglePercentile);
  }
  if (ear.resistance) {
    json["clinic_depth_percentile"] = rounded(ear.resistance->percentile);
    json["log_p_clinic"] = rounded(ear.resistance->logClinic);
    json["log_p_shipped"] = rounded(ear.resistance->logShipped);
  }
  return json;
}

std::size_t countOf(const ClinicOutcomes& outcomes, Evidence evidence)
{
  return static_cast<std::size_t>(
      std::count_if(outcomes.ears.begin(), outcomes.ears.end(),
                    [=](const ScoredOutcome& ear) { return ear.evidence == evidence; }));
}

/// "8 of 10 (80 %, 49 to 94)".
std::string shareOf(std::size_t hits, std::size_t all)
{
  const analysis::Estimate share = analysis::proportionOf(hits, all);
  const auto percent = [](double value) { return std::to_string(std::lround(100.0 * value)); };
  return std::to_string(hits) + " of " + std::to_string(all) + " (" + percent(share.value) +
         " %, 95 % interval " + percent(share.low) + " to " + percent(share.high) + ")";
}

struct Column {
  const char *name, *unit, *meaning;
};
constexpr Column columns[] = {
    {"number", "", "number of the ear in the order of surgery; no code"},
    {"year", "", "year of the surgery"},
    {"array", "", "file name of the implanted array"},
    {"stop_reason", "",
     "why the surgeon stopped: unknown, mark, resistance, buckling, hearing, bleeding, other"},
    {"evidence", "",
     "what the length tells about resistance: resisted, censored (not reached there), none"},
    {"depth_mm", "mm", "inserted length of the tip past the opening, measured in the CT"},
    {"depth_sd_mm", "mm", "its standard deviation"},
    {"planned_depth_p5_mm", "mm", "depth that the plan made before surgery states, 5 % quantile"},
    {"planned_depth_p25_mm", "mm", "25 % quantile"},
    {"planned_depth_mm", "mm", "median"},
    {"planned_depth_p75_mm", "mm", "75 % quantile"},
    {"planned_depth_p95_mm", "mm", "95 % quantile"},
    {"depth_percentile", "", "place of the measured depth in the plan's, 0 to 1"},
    {"angle_deg", "degrees", "angular insertion depth measured in the CT; empty if unknown"},
    {"angle_sd_deg", "degrees", "its standard deviation"},
    {"planned_angle_p5_deg", "degrees", "angular insertion depth of the plan, 5 % quantile"},
    {"planned_angle_p25_deg", "degrees", "25 % quantile"},
    {"planned_angle_deg", "degrees", "median"},
    {"planned_angle_p75_deg", "degrees", "75 % quantile"},
    {"planned_angle_p95_deg", "degrees", "95 % quantile"},
    {"angle_percentile", "", "place of the measured angle in the plan's, 0 to 1"},
    {"clinic_depth_percentile", "",
     "place of the measured depth among those expected with the resistance known from earlier "
     "ears of the clinic, 0 to 1; empty without stop lengths"},
    {"log_p_clinic", "", "ln p of the length with the resistance known from earlier ears"},
    {"log_p_shipped", "", "ln p of the length with the shipped resistance"}};

}  // namespace

Sentence resistanceSentence(const ClinicOutcomes& outcomes)
{
  const std::size_t all = outcomes.ears.size();
  const std::size_t resisted = countOf(outcomes, Evidence::resisted),
                    informative = resisted + countOf(outcomes, Evidence::censored);
  if (informative == 0)
    return Sentence{
        "%1 of %2 outcomes are informative about resistance: the shipped resistance stays.", 0,
        all};
  if (outcomes.resistance.isOffered())
    return Sentence{
        "%1 of %2 outcomes are informative about resistance, %3 ended by it: the clinic's "
        "resistance can be used, its gain in ln p is %4.",
        informative, all, resisted,
        session::shortestDecimal(std::round(100.0 * outcomes.resistance.logScore()) / 100.0)};
  return Sentence{
      "%1 of %2 outcomes are informative about resistance, %3 ended by it; the clinic's resistance "
      "is not offered yet: that needs %4 that ended by it and a gain in ln p of %5, which is %6.",
      informative,
      all,
      resisted,
      fewestResisted,
      session::shortestDecimal(minGain),
      session::shortestDecimal(std::round(100.0 * outcomes.resistance.logScore()) / 100.0)};
}

std::string outcomesJson(const ClinicOutcomes& outcomes)
{
  ordered_json json = {{"format", outcomesFormat}, {"program", "Perilymph " + version()}};
  json["ears"] = ordered_json::array();
  for (std::size_t i = 0; i < outcomes.ears.size(); ++i)
    json["ears"].push_back(earJson(outcomes.ears[i], i + 1));
  const LeftOut& leftOut = outcomes.leftOut;
  json["left_out"] = {{"ears", leftOut.all()},
                      {"unreadable", leftOut.unreadable},
                      {"impossible", leftOut.impossible},
                      {"without_plan", leftOut.withoutPlan},
                      {"twice", leftOut.twice},
                      {"without_day", leftOut.withoutDay}};
  json["arrays"] = ordered_json::array();
  for (const ArrayOutcomes& each : outcomes.arrays) json["arrays"].push_back(arrayJson(each));
  const std::size_t resisted = countOf(outcomes, Evidence::resisted),
                    censored = countOf(outcomes, Evidence::censored);
  json["resistance"] = {{"summary", resistanceSentence(outcomes)},
                        {"resisted", resisted},
                        {"censored", censored},
                        {"not_informative", outcomes.ears.size() - resisted - censored},
                        {"gain", rounded(outcomes.resistance.logScore())},
                        {"is_offered", outcomes.resistance.isOffered()},
                        {"log_friction_shift", rounded(outcomes.resistance.meanFrictionShift())},
                        {"log_stop_force_shift", rounded(outcomes.resistance.meanStopShift())},
                        {"depth_by_clinic", hitsJson(outcomes.byClinic)}};
  json["angle_offset_deg"] = {{"mean", rounded(outcomes.angleOffset.mean_deg)},
                              {"sd", rounded(outcomes.angleOffset.sd_deg)}};
  json[sealKey] = sealToBe();
  return sealed(json.dump(2) + "\n");
}

const FieldMeanings& outcomesColumns()
{
  static const FieldMeanings meanings = [] {
    FieldMeanings list;
    for (const Column& each : columns) list.push_back({each.name, each.unit, each.meaning});
    return list;
  }();
  return meanings;
}

std::string outcomesDictionaryCsv() { return analysis::dictionaryCsv(outcomesColumns()); }

std::string outcomesCsv(const ClinicOutcomes& outcomes)
{
  std::string csv = headerOf(outcomesColumns()) + "\n";
  const auto number = [](double value) { return session::shortestDecimal(rounded(value)); };
  const auto band = [&](const planning::Band& of) {
    return "," + number(of.low) + "," + number(of.lowerQuartile) + "," + number(of.median) + "," +
           number(of.upperQuartile) + "," + number(of.high);
  };
  for (std::size_t i = 0; i < outcomes.ears.size(); ++i) {
    const ScoredOutcome& ear = outcomes.ears[i];
    csv += std::to_string(i + 1) + "," + std::to_string(ear.year) + "," + csvField(ear.array) +
           "," + nameIn(stopReasons, ear.stopReason) + "," + nameOf(ear.evidence) + "," +
           number(ear.depth_mm.value) + "," + number(ear.depth_mm.sd) + band(ear.plannedDepth_mm) +
           "," + number(ear.percentile);
    csv += ear.anglePercentile
               ? "," + number(ear.angle_deg->value) + "," + number(ear.angle_deg->sd) +
                     band(ear.plannedAngle_deg) + "," + number(*ear.anglePercentile)
               : std::string(",,,,,,,,");
    csv += ear.resistance
               ? "," + number(ear.resistance->percentile) + "," +
                     number(ear.resistance->logClinic) + "," + number(ear.resistance->logShipped)
               : std::string(",,,");
    csv += '\n';
  }
  return csv;
}

std::string outcomesText(const ClinicOutcomes& outcomes)
{
  std::string text = "# Outcomes beside their plans\n\n" + std::to_string(outcomes.ears.size()) +
                     (outcomes.ears.size() == 1 ? " ear" : " ears") +
                     ", in the order of surgery; for each the plan as it was made before. " +
                     "For research and training; not a medical device.\n\n";
  if (const LeftOut& leftOut = outcomes.leftOut; leftOut.all() > 0)
    text += std::to_string(leftOut.all()) + " left out: " + std::to_string(leftOut.unreadable) +
            " not readable, " + std::to_string(leftOut.impossible) + " impossible, " +
            std::to_string(leftOut.withoutPlan) + " without a plan made before, " +
            std::to_string(leftOut.twice) + " twice, " + std::to_string(leftOut.withoutDay) +
            " without a known day of surgery.\n\n";
  for (const ArrayOutcomes& each : outcomes.arrays) {
    if (each.depth.all == 0) continue;
    text += "## " + (each.array.empty() ? std::string("All arrays") : each.array) + "\n\n";
    text += "- depth inside the 50 % band: " + shareOf(each.depth.inHalf, each.depth.all) + "\n";
    text += "- depth inside the 90 % band: " + shareOf(each.depth.inNinety, each.depth.all) + "\n";
    if (each.angle.all > 0) {
      text += "- angle inside the 50 % band: " + shareOf(each.angle.inHalf, each.angle.all) + "\n";
      text +=
          "- angle inside the 90 % band: " + shareOf(each.angle.inNinety, each.angle.all) + "\n";
    }
    text += "\n";
  }
  text += "## Resistance in this clinic\n\n" + resistanceSentence(outcomes) + "\n";
  if (outcomes.byClinic.all > 0)
    text += "Depth inside the 90 % band, with the resistance known from earlier ears: " +
            shareOf(outcomes.byClinic.inNinety, outcomes.byClinic.all) + ".\n";
  return text;
}

std::vector<std::pair<std::string, figures::Figure>> outcomesFigures(const ClinicOutcomes& outcomes)
{
  figures::Figure depths;
  depths.title = Sentence{"Insertion depth: planned and measured"};
  figures::FigureValues values;
  values.label = Sentence{"median, 5 to 95 % of the plan"};
  values.ink = ink::blue;
  double low = 20.0, high = 25.0;  // an axis without ears
  for (const ScoredOutcome& ear : outcomes.ears) {
    values.x.push_back(ear.depth_mm.value);
    values.y.push_back(ear.plannedDepth_mm.median);
    values.low.push_back(ear.plannedDepth_mm.low);
    values.high.push_back(ear.plannedDepth_mm.high);
    low = std::min({low, ear.depth_mm.value, ear.plannedDepth_mm.low});
    high = std::max({high, ear.depth_mm.value, ear.plannedDepth_mm.high});
  }
  constexpr double tick_mm = 5.0;
  low = tick_mm * std::floor(low / tick_mm);
  high = tick_mm * std::ceil(high / tick_mm);
  depths.x = {Sentence{"measured depth, mm"}, low, high, tick_mm, 0};
  depths.y = {Sentence{"planned depth, mm"}, low, high, tick_mm, 0};
  depths.values.push_back(std::move(values));
  figures::FigureCurve equal;
  equal.label = Sentence{"equal"};
  equal.ink = ink::gray;
  equal.dash = 3.0;
  equal.x = equal.y = {low, high};
  depths.curves.push_back(std::move(equal));
  figures::Figure percentiles;
  percentiles.title = Sentence{"Percentiles of the measured depths in their plans"};
  std::size_t top = 1;
  constexpr double width = 100.0 / static_cast<double>(percentileBins);
  for (std::size_t i = 0; i < percentileBins; ++i) {
    const auto count = outcomes.arrays.empty() ? 0 : outcomes.arrays.front().depthPercentiles[i];
    top = std::max(top, count);
    const double from = width * static_cast<double>(i), height = static_cast<double>(count);
    percentiles.bands.push_back({i == 0 ? Sentence{"ears"} : Sentence(),
                                 {from + 0.5, from + width - 0.5},
                                 {0.0, 0.0},
                                 {height, height},
                                 ink::tint(ink::blue, 0.8)});
  }
  percentiles.levels.push_back(
      {Sentence(), static_cast<double>(outcomes.ears.size()) / static_cast<double>(percentileBins),
       ink::black});
  percentiles.notes.push_back(
      Sentence{"Dashed: as many in each tenth, to which the numbers tend if the bands hold."});
  percentiles.x = {Sentence{"percentile"}, 0.0, 100.0, 10.0, 0};
  percentiles.y = figures::axisOver(Sentence{"number of ears"}, 0.0, static_cast<double>(top));
  if (percentiles.y.tick < 1.0) {  // few ears, of which there are no parts
    percentiles.y.tick = 1.0;
    percentiles.y.decimals = 0;
  }
  return {{"depths", std::move(depths)}, {"percentiles", std::move(percentiles)}};
}

}  // namespace perilymph::outcome
