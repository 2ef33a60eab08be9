// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/validation/Prediction.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stop_token>

#include "perilymph/analysis/InsertionRun.h"
#include "perilymph/analysis/RunProgress.h"
#include "perilymph/foundation/InParallel.h"
#include "perilymph/foundation/Quantile.h"
#include "perilymph/foundation/Resources.h"
#include "perilymph/foundation/TomlReader.h"
#include "prediction/VirtualInsertion.h"

namespace perilymph::validation {

namespace {

/// A fifth of the ticks of a live insertion; with the friction of tissue 1 ms gives peaks of FLEX24
/// and FLEX28 within 2 % of it.
constexpr Duration predictionStep = milliseconds(5);

constexpr std::array<Choice<PublishedSpread>, 4> publishedSpreads{{
    {PublishedSpread::interquartile, "interquartile"},
    {PublishedSpread::range, "range"},
    {PublishedSpread::deviation, "sd"},
    {PublishedSpread::none, "none"},
}};

PredictedInsertion insert(const session::InsertionParameters& parameters,
                          std::shared_ptr<const anatomy::ScalaTympani> anatomy,
                          const std::stop_token& stop)
{
  const analysis::InsertionRun full =
      analysis::runInsertion(parameters, std::move(anatomy), Length{}, stop);
  PredictedInsertion predicted;
  if (full.end != haptics::InsertionEnd::finished)
    predicted.error =
        full.reason.empty() ? std::string("The array ") + clauseOf(full.end) + "." : full.reason;
  predicted.apical = full.apical;
  predicted.depth = full.depth;
  predicted.end = full.endForce;
  predicted.peak = full.peak.force;
  return predicted;
}

ArraySummary summaryOf(const std::string& array, const std::vector<PredictedInsertion>& all,
                       const std::vector<ClinicalAngle>& clinical)
{
  ArraySummary summary;
  summary.array = array;
  std::vector<double> angles, ends, peaks;
  for (const PredictedInsertion& each : all) {
    if (each.array != array) continue;
    if (each.patient == "mean") {
      if (each.error.empty()) summary.mean = each;
      continue;
    }
    // one that ended early counts with the depth it reached
    summary.complete += each.error.empty() ? 1 : 0;
    angles.push_back(each.apical.si());
    ends.push_back(each.end.si());
    peaks.push_back(each.peak.si());
  }
  summary.patients = static_cast<int>(angles.size());
  if (!angles.empty()) {
    summary.median = radians(quantile(angles, 0.5));
    summary.lowerQuartile = radians(quantile(angles, 0.25));
    summary.upperQuartile = radians(quantile(angles, 0.75));
    summary.medianEnd = newtons(quantile(ends, 0.5));
    summary.medianPeak = newtons(quantile(peaks, 0.5));
  }
  for (const ClinicalAngle& angle : clinical)
    if (angle.array == array && angle.spread != PublishedSpread::none) summary.clinical = angle;
  if (summary.clinical) {
    const Angle found = angles.empty() && summary.mean ? summary.mean->apical : summary.median;
    summary.hitsAngle = (summary.mean || !angles.empty()) && found >= summary.clinical->low &&
                        found <= summary.clinical->high;
  }
  return summary;
}

}  // namespace

Result<std::vector<ClinicalAngle>> clinicalAngles()
{
  auto reader = TomlReader::open(resource("resources/clinical/insertion-angles.toml"));
  if (!reader) return reader.error();
  std::vector<ClinicalAngle> angles;
  reader->text("label");
  for (TomlReader& table : reader->tables("angle")) {
    ClinicalAngle angle;
    angle.array = table.text("array");
    angle.median = degrees(table.number("median_deg", {0.0, 1100.0}));
    angle.spread = table.choice("spread", publishedSpreads);
    angle.low = angle.high = angle.median;
    if (angle.spread != PublishedSpread::none) {
      angle.low = degrees(table.number("low_deg", {0.0, inDegrees(angle.median)}));
      angle.high = degrees(table.number("high_deg", {inDegrees(angle.median), 1100.0}));
    }
    angle.patients = static_cast<int>(table.integer("patients", 2, 100'000, 2));
    if (table.has("contacts_inside")) {
      angle.contactsInside = table.number("contacts_inside", {0.0, 100.0});
      angle.contactsDeviation = table.number("contacts_sd", {0.0, 100.0});
    }
    angle.source = table.text("source");
    angles.push_back(angle);
  }
  if (const auto done = reader->finish(); !done) return done.error();
  return angles;
}

Result<PredictionResult> predict(const PredictionRequest& request,
                                 const analysis::RunProgress& progress, const std::stop_token& stop)
{
  const auto clinical = clinicalAngles();
  if (!clinical) return clinical.error();
  std::vector<session::InsertionParameters> nominal;
  for (const std::string& array : request.arrays) {
    auto scenario = fullInsertionOf(request.scenario, array, request.startInside, predictionStep);
    if (!scenario) return scenario.error();
    nominal.push_back(scenario->parameters());
  }

  // One piece per cochlea, so that each is built once for all arrays.
  const std::size_t arrays = nominal.size();
  const std::size_t cochleae = static_cast<std::size_t>(request.patients) + 1;
  std::vector<PredictedInsertion> insertions(arrays * cochleae);
  const auto work = [&](std::size_t number, const std::stop_token& ending) -> Result<void> {
    std::shared_ptr<const anatomy::ScalaTympani> anatomy;
    for (std::size_t i = 0; i < arrays && !ending.stop_requested(); ++i) {
      const auto parameters = withCochlea(nominal[i], request.seed, number);
      if (!parameters) return parameters.error();
      if (!anatomy) {
        auto built = session::buildAnatomy(*parameters);
        if (!built) return built.error();
        anatomy = *built;
      }
      PredictedInsertion& place = insertions[i * cochleae + number];
      place = insert(*parameters, anatomy, ending);
      place.array = request.arrays[i];
      place.patient = number == 0 ? "mean" : "sample " + std::to_string(number);
    }
    return {};
  };
  const auto done = doInParallel(
      cochleae, request.jobs, work,
      [&](std::size_t count) {
        if (progress) progress(count * arrays, cochleae * arrays);
      },
      stop);
  if (!done) return done.error();

  PredictionResult result;
  result.insertions = std::move(insertions);
  for (const std::string& array : request.arrays)
    result.arrays.push_back(summaryOf(array, result.insertions, *clinical));
  return result;
}

}  // namespace perilymph::validation
