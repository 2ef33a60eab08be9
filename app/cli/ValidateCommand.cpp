// SPDX-License-Identifier: BSD-3-Clause

#include "CallFiles.h"

#include <stop_token>
#include "Commands.h"
#include "Interruption.h"
#include "OutputFolder.h"
#include "PatientOption.h"
#include "Terminal.h"
#include "perilymph/foundation/Resources.h"
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

}  // namespace

Result<Done> validate(const ValidateOptions& options, const CallFiles& files)
{
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
  return Done{};
}

}  // namespace perilymph::cli
