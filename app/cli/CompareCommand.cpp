// SPDX-License-Identifier: BSD-3-Clause

#include "CallFiles.h"
#include "Commands.h"
#include "OutputFolder.h"
#include "Terminal.h"
#include "perilymph/analysis/Comparison.h"

namespace perilymph::cli {

namespace {

void printSummary(const std::vector<analysis::ComparedInsertion>& insertions)
{
  print("{:24} {:>8} {:>8} {:>9} {:>9} {:>7}\n", "recording", "peak, mN", "at, mm", "work, mJ",
        "reversals", "time, s");
  for (const analysis::ComparedInsertion& each : insertions)
    print("{:24} {:>8} {:>8} {:>9} {:>9} {:>7}\n", labelOf(each),
          fixed(inMillinewtons(newtons(each.profile.peak.force)), 1),
          fixed(inMillimeters(meters(each.profile.peak.travel)), 1),
          fixed(each.profile.work * 1e3, 4), each.reversals, fixed(each.profile.duration, 2));
}

}  // namespace

Result<Done> compare(const CompareOptions& options, const CallFiles& files)
{
  std::vector<analysis::ComparedInsertion> insertions;
  for (const std::string& file : options.files) {
    auto compared = analysis::readCompared(file);
    if (!compared) return compared.error();
    if (const std::string note = noteOn(compared->check, file); !note.empty())
      printError("{}\n", note);
    insertions.push_back(std::move(*compared));
  }
  analysis::tellApart(insertions);
  FolderContent content;
  content.texts = {{"comparison.csv", analysis::comparisonCsv(insertions)},
                   {"curves.csv", analysis::curvesCsv(insertions)}};
  content.figures = {{"curves", draw(analysis::comparisonFigure(insertions))}};
  if (const auto done = writeFolder(files, options.out, content); !done) return done.error();
  printSummary(insertions);
  return Done{};
}

}  // namespace perilymph::cli
