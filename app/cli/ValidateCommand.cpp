// SPDX-License-Identifier: BSD-3-Clause

#include "CommandFiles.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <stop_token>
#include "Commands.h"
#include "Interruption.h"
#include "OutputFolder.h"
#include "PatientOption.h"
#include "Terminal.h"
#include "perilymph/foundation/Resources.h"
#include "perilymph/validation/BenchReport.h"
#include "perilymph/validation/PriorPredictive.h"
#include "perilymph/validation/ValidationReport.h"

namespace perilymph::cli {

namespace {

using validation::ValidationRequest;
using validation::ValidationResult;

void printSummary(const ValidationRequest& request, const ValidationResult& result)
{
  print("{} insertions of {}, seed {}, {} samples\n", result.runs, request.nominal.array.name,
        result.seed, result.ticks);
  print("{}\n", validation::completionSentence(result.runs, result.incomplete));
  if (result.ticksNotConverged > 0)
    print("{} samples not converged: solver residual above tolerance\n", result.ticksNotConverged);
  for (const validation::Verdict& verdict : validation::verdictsOf(result, request.experiment))
    print("{:6} {:41} {:10} ({})\n", verdict.isMet ? "met" : "MISSED", verdict.what, verdict.found,
          verdict.wanted);
  print("mean SD over travel: {} mN; contribution of each source alone:\n",
        fixed(inMillinewtons(newtons(result.standardDeviation)), 1));
  for (const validation::SourceSpread& spread : result.spreads)
    print("  {:10} {} mN, {} % of the variance\n", validation::spreadSourceName(spread.source),
          fixed(inMillinewtons(newtons(spread.standardDeviation)), 1),
          fixed(100.0 * spread.fraction, 1));
}

std::string text(const validation::Estimate& friction)
{
  return fixed(friction.median, 3) + " (" + fixed(friction.low, 3) + " to " +
         fixed(friction.high, 3) + ")";
}

void printBench(const validation::BenchResult& result)
{
  print("Friction, median and 95 %:\n");
  for (const auto* list : {&result.media, &result.pairs})
    for (const validation::MediumFriction& each : *list)
      print("  {:<4} {:<14} {}\n", each.specimen, nameIn(validation::benchMedia, each.medium),
            text(each.friction));
  for (const validation::TissueFriction& each : result.tissue)
    print("Fresh tissue over {}: median {}, a further specimen {}, SD of ln friction {}\n",
          each.specimens, text(each.median), text(each.further), fixed(each.between, 2));
  std::size_t inside = 0;
  for (const validation::PredictedForce& each : result.predicted) inside += each.isInside() ? 1 : 0;
  print("From 8 to 13 mm predicted: {} of {} forces up to 14 mm in their 90 % band.\n", inside,
        result.predicted.size());
  for (const validation::ModelScore& each : result.scores)
    print("  {:<4} {} forces, ln p: capstan {}, constant ratio {}\n", each.specimen, each.forces,
          fixed(each.capstan, 2), fixed(each.constantRatio, 2));
  print("Most likely array: EI at the tip {} N mm^2, r {}\n", fixed(1e6 * result.tipStiffness, 4),
        fixed(result.growth, 0));
}

Result<void> inferFromBench(const ValidateOptions& options, const CommandFiles& files)
{
  std::filesystem::path folder = resource("resources/bench") / options.bench;
  std::error_code ignored;
  if (!std::filesystem::is_directory(folder, ignored)) folder = options.bench;
  const auto specimens = validation::loadBench(folder);
  if (!specimens) return specimens.error();
  const validation::BenchResult result = validation::inferFriction(*specimens);
  FolderContent content;
  content.texts = {{"friction.csv", validation::benchFrictionCsv(result)},
                   {"predicted.csv", validation::benchPredictedCsv(result)},
                   {"scores.csv", validation::benchScoresCsv(result)}};
  content.figures = {{"friction", draw(validation::benchFrictionFigure(result))}};
  if (const auto done = writeFolder(files, options.out, content); !done) return done.error();
  printBench(result);
  return {};
}

void printPrior(const validation::PriorSummary& summary)
{
  const auto milli = [](double force) { return fixed(inMillinewtons(newtons(force)), 1); };
  print("{} repetitions of the experiment, {} others cannot be fitted or end early.\n",
        summary.counted, summary.leftOut);
  for (const validation::PredictedAnchor& anchor : summary.anchors) {
    const std::string experiment = anchor.high > anchor.low
                                       ? milli(anchor.low) + " to " + milli(anchor.high)
                                       : milli(anchor.low);
    print(
        "{:5} {} mm: experiment {} mN, standard error {}; inputs {} mN (90 % {} to {}), with the "
        "experiment's errors {} to {}; rank {} %, with errors {} %\n",
        anchor.isInside ? "in" : "OUT", fixed(anchor.travel_mm, 1), experiment,
        milli(anchor.standardError), milli(anchor.mean), milli(anchor.low90), milli(anchor.high90),
        milli(anchor.low90WithError), milli(anchor.high90WithError), fixed(100.0 * anchor.rank, 0),
        fixed(100.0 * anchor.rankWithError, 0));
    std::vector<std::size_t> order(validation::inputCount);
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
      return std::fabs(anchor.correlation[a]) > std::fabs(anchor.correlation[b]);
    });
    print("      depends on");
    for (std::size_t i = 0; i < 4; ++i)
      print(" {} ({})", validation::inputNames[order[i]], fixed(anchor.correlation[order[i]], 2));
    print("\n");
  }
  for (const validation::JointTest& joint : summary.joint)
    print(
        "All five, errors correlated by {}: chi-square {}, p {}; {} of the repetitions are "
        "farther\n",
        fixed(joint.correlation, 1), fixed(joint.distance, 1), fixed(joint.pValue, 3),
        fixed(joint.counted, 3));
}

Result<void> repeatWithDrawnInputs(const ValidateOptions& options, const CommandFiles& files)
{
  auto request = validation::shippedPrior();
  if (!request) return request.error();
  request->draws = options.draws;
  request->seed = options.seed;
  request->jobs = options.jobs;
  const std::stop_token stop = watchForInterruption();
  const auto repetitions = validation::repeatExperiments(
      *request, [](std::size_t done, std::size_t all) { showProgress("repetition", done, all); },
      stop);
  if (isInterrupted()) return Error{"Interrupted; nothing was written."};
  if (!repetitions) return repetitions.error();
  const auto summary = validation::summarize(*repetitions, request->experiment);
  if (!summary) return summary.error();
  FolderContent content;
  content.texts = {{"prior-predictive.csv", validation::priorSummaryCsv(*summary)},
                   {"prior-predictive-draws.csv", validation::priorCsv(*repetitions)},
                   {"prior-predictive.json", validation::priorJson(*request, *summary)}};
  if (const auto done = writeFolder(files, options.out, content); !done) return done.error();
  printPrior(*summary);
  return {};
}

}  // namespace

Result<void> validate(const ValidateOptions& options, const CommandFiles& files)
{
  if (!options.bench.empty()) return inferFromBench(options, files);
  if (options.isPriorPredictive) return repeatWithDrawnInputs(options, files);
  const auto file = findByName("variability", "resources/validation", options.variability);
  if (!file) return file.error();
  auto variability = validation::loadVariability(*file);
  if (!variability) return variability.error();
  auto scenario = session::loadScenario(variability->scenario, options.overrides);
  if (!scenario) return scenario.error();
  if (const auto done = files.checkScenarioFiles(scenario->files()); !done) return done.error();
  printNoteOn(scenario->patient());
  const auto references = validation::validationReferences();
  if (!references) return references.error();

  ValidationRequest request;
  request.nominal = scenario->parameters();
  request.variability = std::move(*variability);
  // The paper's own model is compared with the paper's simulated forces.
  const bool isPublishedModel = request.nominal.model == mechanics::ModelKind::points;
  request.experiment = isPublishedModel ? references->simulator : references->experiment;
  request.runs = options.runs;
  request.seed = options.seed;
  request.jobs = options.jobs;
  const std::stop_token stop = watchForInterruption();
  print("Simulating {} {} times; each source of variability alone takes additional runs.\n",
        request.nominal.name, request.runs);
  flushOutput();
  const auto result = validation::validate(
      request, [](std::size_t done, std::size_t all) { showProgress("insertion", done, all); },
      stop);
  if (isInterrupted()) return Error{"Interrupted; nothing was written."};
  if (!result) return result.error();

  auto [texts, figures] = validation::validationFiles(request, *result, *references);
  const FolderContent content{std::move(texts), std::move(figures)};
  if (const auto done = writeFolder(files, options.out, content); !done) return done.error();
  printSummary(request, *result);
  return {};
}

}  // namespace perilymph::cli
