#include <cstdio>

#include "CallFiles.h"
#include "Commands.h"
#include "Interruption.h"
#include "OutputFile.h"
#include "OutputFolder.h"
#include "perilymph/analysis/Prediction.h"

namespace perilymph::cli {

namespace {

std::string degreesOf(Angle angle) { return fixed(inDegrees(angle), 0); }

std::string milli(Force force) { return fixed(inMillinewtons(force), 1); }

const char* verdict(bool isHit) { return isHit ? "hit" : "MISS"; }

void printForce(const char* what, Force found, const analysis::PrintedRange* range)
{
  if (!range) return;
  std::printf("  %-5s %s force %s mN (in vivo %s to %s mN)\n",
              verdict(found.si() >= range->low && found.si() <= range->high), what,
              milli(found).c_str(), milli(newtons(range->low)).c_str(),
              milli(newtons(range->high)).c_str());
}

void print(const analysis::ArraySummary& array, const analysis::Reference& inVivo)
{
  std::printf("%s\n", array.array.c_str());
  if (array.mean)
    std::printf("  mean cochlea: %s deg, force at the end %s mN, peak %s mN\n",
                degreesOf(array.mean->apical).c_str(), milli(array.mean->end).c_str(),
                milli(array.mean->peak).c_str());
  else
    std::printf("  mean cochlea: could not be carried out\n");
  if (array.patients > 0)
    std::printf("  %d patients: median %s deg, quartiles %s and %s\n", array.patients,
                degreesOf(array.median).c_str(), degreesOf(array.lowerQuartile).c_str(),
                degreesOf(array.upperQuartile).c_str());
  if (array.clinical)
    std::printf("  %-5s clinical median %s deg, %s to %s\n", verdict(array.hitsAngle),
                degreesOf(array.clinical->median).c_str(), degreesOf(array.clinical->low).c_str(),
                degreesOf(array.clinical->high).c_str());
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
  for (const analysis::ArraySummary& array : result->arrays) print(array, *inVivo);
  for (const analysis::PredictedInsertion& each : result->insertions)
    if (!each.trouble.empty())
      std::printf("%s in %s: %s\n", each.array.c_str(), each.patient.c_str(), each.trouble.c_str());
  return Done{};
}

}  // namespace perilymph::cli
