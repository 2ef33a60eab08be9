#include <cstdio>

#include "CallFiles.h"
#include "Commands.h"
#include "OutputFile.h"
#include "OutputFolder.h"
#include "perilymph/analysis/Comparison.h"

namespace perilymph::cli {

namespace {

void print(const std::vector<analysis::ComparedInsertion>& insertions)
{
  std::printf("%-24s %8s %8s %9s %9s %7s\n", "recording", "peak, N", "at, mm", "work, mJ",
              "reversals", "time, s");
  for (const analysis::ComparedInsertion& each : insertions)
    std::printf("%-24s %8s %8s %9s %9d %7s\n", each.name.c_str(),
                fixed(each.profile.peak.force, 4).c_str(),
                fixed(inMillimeters(meters(each.profile.peak.travel)), 1).c_str(),
                fixed(each.profile.work * 1e3, 4).c_str(), each.reversals,
                fixed(each.profile.duration, 2).c_str());
}

}  // namespace

Result<Done> compare(const CompareOptions& options, const CallFiles& files)
{
  std::vector<analysis::ComparedInsertion> insertions;
  for (const std::string& file : options.files) {
    auto compared = analysis::readCompared(file);
    if (!compared) return compared.error();
    insertions.push_back(std::move(*compared));
  }
  analysis::tellApart(insertions);
  FolderContent content;
  content.texts = {{"comparison.csv", analysis::comparisonCsv(insertions)},
                   {"curves.csv", analysis::curvesCsv(insertions)}};
  content.figures = {{"curves", draw(analysis::comparisonFigure(insertions))}};
  if (const auto done = writeFolder(files, options.out, content); !done) return done.error();
  print(insertions);
  return Done{};
}

}  // namespace perilymph::cli
