// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/validation/BenchReport.h"

#include <algorithm>

#include "ValidationColumns.h"
#include "perilymph/figures/Strings.h"
#include "perilymph/foundation/CsvField.h"
#include "perilymph/foundation/Math.h"
#include "perilymph/foundation/Units.h"

namespace perilymph::validation {

using figures::fixed;

namespace {

std::string row(const std::string& specimen, const std::string& medium, const Estimate& friction)
{
  return csvField(specimen) + "," + medium + "," + fixed(friction.median, 4) + "," +
         fixed(friction.low, 4) + "," + fixed(friction.high, 4) + "\n";
}

Sentence titleOf(BenchMedium medium)
{
  switch (medium) {
    case BenchMedium::soap:
      return Sentence{"PTFE, soap"};
    case BenchMedium::healonInAir:
      return Sentence{"PTFE, Healon in air"};
    case BenchMedium::salineHealon:
      return Sentence{"PTFE, saline and Healon"};
    case BenchMedium::saline:
      return Sentence{"PTFE, saline"};
    case BenchMedium::perilymph:
      return Sentence{"PTFE, artificial perilymph"};
    case BenchMedium::tissue:
      break;
  }
  return Sentence{"fresh cochlea"};
}

}  // namespace

std::string benchFrictionCsv(const BenchResult& result)
{
  std::string csv = headerOf(benchFrictionColumns()) + "\n";
  for (const auto* list : {&result.media, &result.pairs})
    for (const MediumFriction& each : *list)
      csv += row(each.specimen, nameIn(benchMedia, each.medium), each.friction);
  for (const TissueFriction& each : result.tissue) {
    csv += row(each.specimens, "tissue-median", each.median);
    csv += row(each.specimens, "tissue-further", each.further);
  }
  return csv;
}

std::string benchPredictedCsv(const BenchResult& result)
{
  std::string csv = headerOf(benchPredictedColumns()) + "\n";
  for (const PredictedForce& each : result.predicted) {
    csv += csvField(each.specimen) + "," + nameIn(benchMedia, each.medium) + "," +
           fixed(inMillimeters(meters(each.depth)), 2);
    for (const double force : {each.measured, each.median, each.low, each.high})
      csv += "," + fixed(inMillinewtons(newtons(force)), 1);
    csv += each.isInside() ? ",1\n" : ",0\n";
  }
  return csv;
}

std::string benchScoresCsv(const BenchResult& result)
{
  std::string csv = headerOf(benchScoreColumns()) + "\n";
  for (const ModelScore& each : result.scores)
    csv += csvField(each.specimen) + "," + std::to_string(each.forces) + "," +
           fixed(each.capstan, 2) + "," + fixed(each.constantRatio, 2) + "\n";
  return csv;
}

figures::Figure benchFrictionFigure(const BenchResult& result)
{
  namespace ink = figures::ink;
  constexpr figures::Ink inks[] = {ink::green, ink::gray,      ink::purple,
                                   ink::blue,  ink::vermilion, ink::black};
  figures::Figure figure;
  figure.title = Sentence{"Friction from one array in one channel"};
  figure.x = {Sentence{"coefficient of friction"}, 0.0, 0.5, 0.1, 1};
  double highest = 0.0;
  for (const MediumFriction& each : result.media) {
    figures::FigureCurve curve;
    curve.label = titleOf(each.medium);
    curve.ink = inks[static_cast<std::size_t>(each.medium)];
    curve.width = each.medium == BenchMedium::tissue ? 2.4 : 1.2;
    for (std::size_t i = 0; i < result.frictions.size(); ++i) {
      if (result.frictions[i] > figure.x.high) break;
      curve.x.push_back(result.frictions[i]);
      curve.y.push_back(each.density[i]);
      highest = std::max(highest, each.density[i]);
    }
    figure.curves.push_back(std::move(curve));
  }
  figure.y =
      figures::axisOver(Sentence{"posterior in steps of a tenth of ln friction"}, 0.0, highest);
  figure.notes = {
      Sentence{"Measured forces from 8 to 14 mm; the method: the guide's page friction.md."}};
  return figure;
}

}  // namespace perilymph::validation
