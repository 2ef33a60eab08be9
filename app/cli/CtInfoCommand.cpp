// SPDX-License-Identifier: BSD-3-Clause
#include <nlohmann/json.hpp>

#include "Commands.h"
#include "JsonText.h"
#include "Terminal.h"
#include "perilymph/foundation/AtomicFile.h"
#include "perilymph/foundation/Version.h"
#if PERILYMPH_HAS_TOOLKIT
#include "perilymph/imaging/CtSeries.h"
#endif

namespace perilymph::cli {

#if PERILYMPH_HAS_TOOLKIT

namespace {

using imaging::CtSeries;
using Json = nlohmann::ordered_json;

Json described(const CtSeries& series)
{
  Json json;
  json["uid"] = series.uid;
  json["key"] = series.key;
  json["format"] = series.format;
  json["modality"] = series.modality;
  json["scanner"] = series.scanner;
  json["kernel"] = series.kernel;
  json["size"] = series.size;
  json["slices"] = series.size[2];
  json["spacing_mm"] = {series.spacing_mm.x(), series.spacing_mm.y(), series.spacing_mm.z()};
  json["score"] = series.score;
  json["readable"] = series.obstacle.empty();
  json["obstacle"] = series.obstacle;
  json["warnings"] = series.warnings;
  return json;
}

std::string times(const std::array<std::string, 3>& parts)
{
  return parts[0] + " x " + parts[1] + " x " + parts[2];
}

void printSeries(const CtSeries& series)
{
  const auto number = [&](std::size_t axis) { return std::to_string(series.size[axis]); };
  const auto mm = [&](Eigen::Index axis) { return fixed(series.spacing_mm[axis], 3); };
  print("{}\n", series.uid.empty() ? series.format : series.uid);
  print("    {}, {} voxels of {} mm{}{}\n", series.modality.empty() ? "?" : series.modality,
        times({number(0), number(1), number(2)}), times({mm(0), mm(1), mm(2)}),
        series.scanner.empty() ? "" : ", " + series.scanner,
        series.kernel.empty() ? "" : ", kernel " + series.kernel);
  if (!series.obstacle.empty()) {
    print("    Cannot be read. {}\n", series.obstacle);
    return;
  }
  print("    Suitability for a cochlea: {} of 100.\n", fixed(series.score, 0));
  for (const std::string& warning : series.warnings) print("    {}\n", warning);
}

}  // namespace

Result<void> ctInfo(const CtInfoOptions& options)
{
  const auto list = imaging::findSeries(options.path);
  if (!list) return list.error();
  print("{} series, best suited first; {} other files\n", list->series.size(), list->otherFiles);
  for (const CtSeries& series : list->series) printSeries(series);
  if (options.json.empty()) return {};
  Json json;
  json["version"] = version();
  json["series"] = Json::array();
  for (const CtSeries& series : list->series) json["series"].push_back(described(series));
  json["other_files"] = list->otherFiles;
  return writeWhole(options.json, jsonText(json));
}

#else

Result<void> ctInfo(const CtInfoOptions&)
{
  return Error{"This build has no VTK, so it cannot read a CT; use a build of the preset release."};
}

#endif

}  // namespace perilymph::cli
