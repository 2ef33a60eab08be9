// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <cstddef>

#include "perilymph/foundation/Resources.h"
#include "perilymph/foundation/TomlReader.h"
#include "perilymph/foundation/Units.h"
#include "perilymph/validation/BenchChain.h"

namespace perilymph::validation {

namespace {

BenchCurve readCurve(TomlReader table, BenchMedium medium)
{
  BenchCurve curve;
  curve.medium = medium;
  const std::vector<double> depths_mm = table.numbers("depth_mm", {1.0, 30.0}, 3);
  const std::vector<double> forces_mN = table.numbers("force_mN", {0.1, 1000.0}, 3);
  table.number("reading_error_mN", {0.0, 20.0});
  table.integer("insertions", 1, 1000, 1);
  table.text("source");
  if (forces_mN.size() != depths_mm.size())
    table.refuse("force_mN", "force_mN has " + std::to_string(forces_mN.size()) +
                                 " values and depth_mm " + std::to_string(depths_mm.size()) +
                                 "; give a force at each depth.");
  std::size_t fitted = 0;
  for (std::size_t i = 0; i < depths_mm.size(); ++i) {
    if (i > 0 && depths_mm[i] <= depths_mm[i - 1])
      table.refuse("depth_mm", "depth_mm does not increase; put the forces in order of depth.");
    if (std::fabs(20.0 * depths_mm[i] - std::round(20.0 * depths_mm[i])) > 1e-6)
      table.refuse("depth_mm", "depth_mm has a depth that is no multiple of 0.05 mm.");
    if (depths_mm[i] >= 8.0 && depths_mm[i] <= 13.0) ++fitted;
    curve.depths.push_back(millimeters(depths_mm[i]).si());
  }
  if (fitted < 2) table.refuse("depth_mm", "depth_mm needs two depths from 8 to 13 mm.");
  for (const double force_mN : forces_mN) curve.forces.push_back(millinewtons(force_mN).si());
  return curve;
}

bool hasCurve(const BenchSpecimen& specimen, BenchMedium medium)
{
  return std::any_of(specimen.curves.begin(), specimen.curves.end(),
                     [&](const BenchCurve& curve) { return curve.medium == medium; });
}

Result<BenchSpecimen> loadSpecimen(const std::filesystem::path& file)
{
  auto reader = TomlReader::open(file);
  if (!reader) return reader.error();
  BenchSpecimen specimen;
  specimen.name = reader->text("name");
  specimen.isPoor = reader->choice("agreement", {"good", "poor"}) == "poor";
  reader->text("note", "");
  for (const Choice<BenchMedium>& medium : benchMedia)
    if (reader->has(medium.name))
      specimen.curves.push_back(readCurve(reader->table(medium.name), medium.value));
  for (const BenchMedium needed : {BenchMedium::tissue, BenchMedium::saline})
    if (!hasCurve(specimen, needed))
      reader->refuse("name", std::string("There is no [") + nameIn(benchMedia, needed) +
                                 "]; a specimen needs [tissue] and [saline].");
  if (const auto done = reader->finish(); !done) return done.error();
  return specimen;
}

}  // namespace

Result<std::vector<BenchSpecimen>> loadBench(const std::filesystem::path& folder)
{
  const std::vector<std::filesystem::path> files = tomlFilesIn(folder);
  if (files.empty())
    return Error{
        "There are no bench curves in '%1'. Give slim-straight, or a folder with a TOML "
        "file for each specimen.",
        folder.string()};
  std::vector<BenchSpecimen> specimens;
  for (const std::filesystem::path& file : files) {
    auto specimen = loadSpecimen(file);
    if (!specimen) return specimen.error();
    specimens.push_back(std::move(*specimen));
  }
  const auto hasSoap = [](const BenchSpecimen& each) { return hasCurve(each, BenchMedium::soap); };
  const auto count = std::count_if(specimens.begin(), specimens.end(), hasSoap);
  if (count != 1)
    return Error{
        "The folder '%1' has %2 specimens with a curve in soap; one is needed, whose array "
        "stands for all.",
        folder.string(), count};
  std::stable_partition(specimens.begin(), specimens.end(), hasSoap);
  return specimens;
}

}  // namespace perilymph::validation
