// SPDX-License-Identifier: BSD-3-Clause

#include "CallFiles.h"
#include "Commands.h"
#include "Interruption.h"
#include "OutputFolder.h"
#include "Terminal.h"
#include "perilymph/analysis/Prediction.h"

namespace perilymph::cli {

namespace {

std::string degreesOf(Angle angle) { return fixed(inDegrees(angle), 0); }

std::string milli(Force force) { return fixed(inMillinewtons(force), 1); }

const char* verdict(bool isHit) { return isHit ? "hit" : "MISS"; }

void printForce(const char* what, Force found, const analysis::PrintedRange* range)
{
  if (!range) return;
  print("  {:5} {} force {} mN (in vivo {} to {} mN)\n",
        verdict(found.si() >= range->low && found.si() <= range->high), what, milli(found),
        milli(newtons(range->low)), milli(newtons(range->high)));
}

void printArray(const analysis::ArraySummary& array, const analysis::Reference& inVivo)
{
  print("{}\n", array.array);
  if (array.mean)
    print("  average cochlea: {} deg, final force {} mN, peak force {} mN\n",
          degreesOf(array.mean->apical), milli(array.mean->end), milli(array.mean->peak));
  else
    print("  average cochlea: not possible\n");
  if (array.patients > 0)
    print("  {} patients: median {} deg, quartiles {} and {}\n", array.patients,
          degreesOf(array.median), degreesOf(array.lowerQuartile), degreesOf(array.upperQuartile));
  if (array.clinical)
    print("  {:5} clinical median {} deg, {} to {}\n", verdict(array.hitsAngle),
          degreesOf(array.clinical->median), degreesOf(array.clinical->low),
          degreesOf(array.clinical->high));
  if (array.patients == 0) return;
  printForce("end", array.medianEnd, inVivo.findRange("end of insertion"));
  printForce("peak", array.medianPeak, inVivo.findRange("peak"));
}

}  // namespace

Result<Done> predict(const PredictOptions& options, const CallFiles& files)
{
  const auto inVivo = analysis::shippedReference("in-vivo");
  if (!inVivo) return inVivo.error();
  analysis::PredictionRequest request;
  request.arrays = options.arrays;
  request.patients = options.patients;
  request.seed = options.seed;
  request.jobs = options.jobs;
  watchForInterruption();
  const auto result = analysis::predict(request, [](std::size_t done, std::size_t all) {
    return showProgress("insertion", done, all);
  });
  if (isInterrupted()) return Error{"Interrupted; nothing was written."};
  if (!result) return result.error();

  FolderContent content;
  content.texts = {{"prediction.csv", analysis::predictionCsv(*result)},
                   {"prediction.json", analysis::predictionJson(request, *result, *inVivo)}};
  if (const auto done = writeFolder(files, options.out, content); !done) return done.error();
  for (const analysis::ArraySummary& array : result->arrays) printArray(array, *inVivo);
  for (const analysis::PredictedInsertion& each : result->insertions)
    if (!each.error.empty()) print("{} in {}: {}\n", each.array, each.patient, each.error);
  return Done{};
}

}  // namespace perilymph::cli
