#include <cstdio>

#include "CallFiles.h"
#include "Commands.h"
#include "Interruption.h"
#include "OutputFile.h"
#include "OutputFolder.h"
#include "perilymph/analysis/ValidationReport.h"
#include "perilymph/foundation/Resources.h"

namespace perilymph::cli {

namespace {

using analysis::ValidationRequest;
using analysis::ValidationResult;

void print(const ValidationRequest& request, const ValidationResult& result)
{
  std::printf("%d insertions of %s, seed %llu, %llu ticks\n", result.runs,
              request.scenario.array.name.c_str(), static_cast<unsigned long long>(result.seed),
              static_cast<unsigned long long>(result.ticks));
  if (result.ticksNotSettled > 0)
    std::printf("in %llu ticks the solver left more than its tolerance\n",
                static_cast<unsigned long long>(result.ticksNotSettled));
  for (const analysis::Verdict& verdict : analysis::verdictsOf(result, request.experiment))
    std::printf("%-6s %-41s %-10s (%s)\n", verdict.isMet ? "met" : "MISSED", verdict.what.c_str(),
                verdict.found.c_str(), verdict.wanted.c_str());
  std::printf("spread over travel: %s N; what each source makes alone:\n",
              fixed(result.deviation, 4).c_str());
  for (const analysis::SpreadShare& share : result.shares)
    std::printf("  %-10s %s N, %s %% of the variance\n", analysis::spreadSourceName(share.source),
                fixed(share.deviation, 4).c_str(), fixed(100.0 * share.share, 1).c_str());
}

}  // namespace

Result<Done> validate(const ValidateOptions& options, const CallFiles& files)
{
  const auto file = findByName("variability", "resources/validation", options.variability);
  if (!file) return file.error();
  auto variability = analysis::loadVariability(*file);
  if (!variability) return variability.error();
  auto scenario = session::loadScenario(variability->scenario, options.overrides);
  if (!scenario) return scenario.error();
  if (const auto done = files.checkScenarioFiles(scenario->files); !done) return done.error();
  const auto references = analysis::validationReferences();
  if (!references) return references.error();

  ValidationRequest request;
  request.scenario = std::move(*scenario);
  request.variability = std::move(*variability);
  // The paper's own model is held against the paper's own simulated forces.
  const bool isPublishedModel = request.scenario.model == mechanics::ModelKind::points;
  request.experiment = isPublishedModel ? references->simulator : references->experiment;
  request.runs = options.runs;
  request.seed = options.seed;
  request.jobs = options.jobs;
  watchForInterruption();
  std::printf("Repeating %s %d times; each source of spread alone takes some more.\n",
              request.scenario.name.c_str(), request.runs);
  std::fflush(stdout);
  const auto result = analysis::validate(request, [](std::size_t done, std::size_t all) {
    return showProgress("insertion", done, all);
  });
  if (isInterrupted()) return Error{"Interrupted; nothing was written."};
  if (!result) return result.error();

  auto [texts, figures] = analysis::validationFiles(request, *result, *references);
  const FolderContent content{std::move(texts), std::move(figures)};
  if (const auto done = writeFolder(files, options.out, content); !done) return done.error();
  print(request, *result);
  return Done{};
}

}  // namespace perilymph::cli
