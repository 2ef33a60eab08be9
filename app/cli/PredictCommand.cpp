// SPDX-License-Identifier: BSD-3-Clause

#include "CommandFiles.h"

#include <cmath>
#include <stop_token>
#include "Commands.h"
#include "Interruption.h"
#include "OutputFolder.h"
#include "Terminal.h"
#include "perilymph/analysis/SampleStatistics.h"
#include "perilymph/validation/ClinicalPrediction.h"
#include "perilymph/validation/Prediction.h"

namespace perilymph::cli {

namespace {

std::string degreesOf(Angle angle) { return fixed(inDegrees(angle), 0); }

std::string milli(Force force) { return fixed(inMillinewtons(force), 1); }

void printForce(const char* what, Force found, const analysis::PrintedRange* range)
{
  if (!range) return;
  const bool isWithin = found.si() >= range->low && found.si() <= range->high;
  print("  {} the range in vivo: {} force {} mN ({} to {} mN)\n", isWithin ? "within" : "outside",
        what, milli(found), milli(newtons(range->low)), milli(newtons(range->high)));
}

void printArray(const validation::ArraySummary& array, const analysis::Reference& inVivo)
{
  print("{}\n", array.array);
  if (array.mean)
    print("  average cochlea: {} deg, final force {} mN, peak force {} mN\n",
          degreesOf(array.mean->apical), milli(array.mean->end), milli(array.mean->peak));
  else
    print("  average cochlea: not possible\n");
  if (array.patients > 0)
    print("  {} patients, {} complete: median {} deg, quartiles {} and {}\n", array.patients,
          array.complete, degreesOf(array.median), degreesOf(array.lowerQuartile),
          degreesOf(array.upperQuartile));
  if (array.clinical)
    print("  {} the range of clinics: median {} deg, {} to {}\n",
          array.hitsAngle ? "within" : "outside", degreesOf(array.clinical->median),
          degreesOf(array.clinical->low), degreesOf(array.clinical->high));
  if (array.patients == 0) return;
  printForce("end", array.medianEnd, inVivo.findRange("end of insertion"));
  printForce("peak", array.medianPeak, inVivo.findRange("peak"));
}

const char* verdict(validation::RowVerdict verdict)
{
  if (verdict == validation::RowVerdict::notJudged) return "-";
  return validation::RowVerdict::hit == verdict ? "hit" : "MISS";
}

/// The prediction with its unit: "412.0 (401.0 to 425.0) deg", a rate "5 of 6" or "83.3 %".
std::string foundText(const validation::ClinicalRow& row)
{
  if (row.runs == 0) return "none";
  const auto runs = static_cast<std::size_t>(row.runs);
  if (row.unit == "%" && row.isClinical) {
    if (const auto count = analysis::countedOf({row.median / 100.0, 0.0, 1.0}, runs))
      return std::to_string(*count) + " of " + std::to_string(runs);
    return fixed(row.median, 1) + " %";
  }
  const std::string quartiles =
      row.runs > 1 ? " (" + fixed(row.lowerQuartile, 1) + " to " + fixed(row.upperQuartile, 1) + ")"
                   : "";
  return fixed(row.median, 1) + quartiles + " " + row.unit;
}

/// What is beside a verdict: its tolerance and power, the spread, the companions.
std::string besideText(const validation::ClinicalRow& row)
{
  std::string text;
  if (row.tolerance > 0.0)
    text += ", hit within " + fixed(row.tolerance, 0) + " " + row.unit + " of it (" +
            verdict(row.atMedianFriction) + " at the median friction)";
  if (row.power > 0.0) text += ", power " + fixed(row.power, 2);
  if (row.spread != validation::RowVerdict::notJudged)
    text += "; spread " + fixed(row.spreadFactor, 2) + " times (" + verdict(row.spread) + ")";
  if (row.depth_mm > 0.0) text += "; depth " + fixed(row.depth_mm, 1) + " mm";
  if (row.contactsInside) {
    text += "; contacts inside " + fixed(row.contactsInside->found, 1);
    if (std::isfinite(row.contactsInside->published))
      text += " (published " + fixed(row.contactsInside->published, 1) + ")";
  }
  if (row.angleAtLength && row.angleAtLength->runs > 0)
    text += "; " + fixed(row.angleAtLength->found, 0) + " deg at that length (published " +
            fixed(row.angleAtLength->published, 0) + ", " +
            std::to_string(row.angleAtLength->runs) + " as deep)";
  return text + (row.note.empty() ? "" : "; " + row.note);
}

std::string publishedText(const validation::ClinicalRow& row)
{
  if (!(row.high > row.low)) return "none";
  const std::string range = fixed(row.low, 1) + " to " + fixed(row.high, 1);
  const std::string patients = row.patients > 0 ? ", n " + std::to_string(row.patients) : "";
  if (row.tolerance == 0.0) return range + (row.unit == "%" ? " %" : "") + patients;
  return fixed(row.published, 0) + " (" + range + ")" + patients;
}

void printRows(const std::vector<validation::ClinicalRow>& rows, bool isClinical)
{
  int hits = 0, judged = 0;
  for (const validation::ClinicalRow& row : rows) {
    if (row.isClinical != isClinical) continue;
    hits += row.verdict == validation::RowVerdict::hit ? 1 : 0;
    judged += row.verdict == validation::RowVerdict::notJudged ? 0 : 1;
    print("  {:5} {:<58} {:>7}, published {}{}\n", verdict(row.verdict), row.quantity,
          foundText(row), publishedText(row), besideText(row));
  }
  print("{} of {} judged rows met.\n", hits, judged);
}

Result<void> predictAll(const PredictOptions& options, const CommandFiles& files)
{
  validation::ClinicalRequest request;
  request.seeds = options.seeds;
  request.patients = options.patients.value_or(request.patients);
  request.friction = options.friction;
  request.jobs = options.jobs;
  const std::stop_token stop = watchForInterruption();
  const auto result = validation::predictClinic(
      request, [](std::size_t done, std::size_t all) { showProgress("insertion", done, all); },
      stop);
  if (isInterrupted()) return Error{"Interrupted; nothing was written."};
  if (!result) return result.error();
  const auto page = validation::clinicalJson(request, *result);
  if (!page) return page.error();
  FolderContent content;
  content.texts = {
      {"clinical-table.csv", validation::clinicalRowsCsv(result->rows)},
      {"clinical-insertions.csv", validation::clinicalInsertionsCsv(result->insertions)},
      {"clinical-table.json", *page}};
  if (const auto done = writeFolder(files, options.out, content); !done) return done.error();
  print("Insertions by hand in {} cochleae; medians and quartiles:\n",
        request.seeds.size() * static_cast<std::size_t>(request.patients));
  printRows(result->rows, true);
  if (result->perfect.rows > 0)
    print("A perfect model would meet {} of {} on average, all of them with probability {}.\n",
          fixed(result->perfect.expected, 1), result->perfect.rows, fixed(result->perfect.all, 2));
  print("Experiment with a phantom:\n");
  printRows(result->rows, false);
  return {};
}

}  // namespace

Result<void> predict(const PredictOptions& options, const CommandFiles& files)
{
  if (options.isAll) return predictAll(options, files);
  const auto inVivo = analysis::shippedReference("in-vivo");
  if (!inVivo) return inVivo.error();
  validation::PredictionRequest request;
  request.arrays = options.arrays;
  request.patients = options.patients.value_or(request.patients);
  request.seed = options.seeds.front();
  request.jobs = options.jobs;
  const std::stop_token stop = watchForInterruption();
  const auto result = validation::predict(
      request, [](std::size_t done, std::size_t all) { showProgress("insertion", done, all); },
      stop);
  if (isInterrupted()) return Error{"Interrupted; nothing was written."};
  if (!result) return result.error();

  FolderContent content;
  content.texts = {{"prediction.csv", validation::predictionCsv(*result)},
                   {"prediction.json", validation::predictionJson(request, *result, *inVivo)}};
  if (const auto done = writeFolder(files, options.out, content); !done) return done.error();
  print(
      "Scenario {}, each array pushed to its full depth, whatever the force: not comparable with "
      "the "
      "clinical table (predict --all) or a plan, in which a hand stops.\n",
      request.scenario);
  for (const validation::ArraySummary& array : result->arrays) printArray(array, *inVivo);
  for (const validation::PredictedInsertion& each : result->insertions)
    if (!each.error.empty()) print("{} in {}: {}\n", each.array, each.patient, each.error);
  return {};
}

}  // namespace perilymph::cli
