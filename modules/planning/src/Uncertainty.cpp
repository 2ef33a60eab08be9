// SPDX-License-Identifier: BSD-3-Clause
#include "Uncertainty.h"

#include <optional>

#include "perilymph/electrode/WirePacking.h"
#include "perilymph/foundation/Resources.h"
#include "perilymph/foundation/TomlReader.h"

namespace perilymph::planning {

namespace {

TomlReader sourcedTable(TomlReader& file, const char* key, Uncertainty& uncertainty)
{
  TomlReader table = file.table(key);
  const std::string source = table.text("source");
  uncertainty.provenance.push_back(
      {key, source, table.choice("confidence", {"high", "medium", "low"}, std::nullopt)});
  return table;
}

/// A table of what varies along the scala.
Uncertainty::Variation variation(TomlReader& file, const char* table, const char* key,
                                 double maxDeviation, Uncertainty& uncertainty)
{
  TomlReader reader = sourcedTable(file, table, uncertainty);
  const double deviation = reader.number(key, {0.0, maxDeviation});
  // below 20 degrees the wall would fold
  return {deviation, degrees(reader.number("correlation_deg", {20.0, 1000.0}))};
}

}  // namespace

double Uncertainty::stiffnessOf(const electrode::ArrayDesign& array) const
{
  const double lowest = electrode::wirePacking(array) ? mediumStiffness : lowStiffness;
  for (const auto& [table, source] : array.provenance) {
    if (table != "bending") continue;
    if (source.confidence == electrode::Confidence::high) return highStiffness;
    if (source.confidence == electrode::Confidence::medium) return mediumStiffness;
  }
  return lowest;
}

Result<Uncertainty> loadUncertainty(const std::filesystem::path& file)
{
  auto reader = TomlReader::open(file);
  if (!reader) return reader.error();
  Uncertainty uncertainty;
  reader->text("label");
  TomlReader stiffness = sourcedTable(*reader, "stiffness", uncertainty);
  uncertainty.highStiffness = stiffness.number("high_sd_fraction", {0.0, 1.0});
  uncertainty.mediumStiffness =
      stiffness.number("medium_sd_fraction", {uncertainty.highStiffness, 1.0});
  uncertainty.lowStiffness =
      stiffness.number("low_sd_fraction", {uncertainty.mediumStiffness, 1.0});
  TomlReader approach = sourcedTable(*reader, "approach", uncertainty);
  uncertainty.tiltDeviation = degrees(approach.number("tilt_sd_deg", {0.0, 15.0}));
  uncertainty.turnDeviation = degrees(approach.number("turn_sd_deg", {0.0, 15.0}));
  uncertainty.maxDeviates = approach.number("max_deviates", {0.5, 5.0});
  uncertainty.section = variation(*reader, "section", "sd_fraction", 0.3, uncertainty);
  uncertainty.course = variation(*reader, "course", "sd_mm", 0.5, uncertainty);
  uncertainty.course.standardDeviation = millimeters(uncertainty.course.standardDeviation).si();
  uncertainty.radius = variation(*reader, "radius", "sd_fraction", 0.1, uncertainty);
  TomlReader height = sourcedTable(*reader, "height", uncertainty);
  uncertainty.heightDeviation = height.number("sd_fraction", {0.0, 0.3});
  uncertainty.maxHeightDeviates = height.number("max_deviates", {0.5, 3.0});
  TomlReader lining = sourcedTable(*reader, "lining", uncertainty);
  uncertainty.liningLow = millimeters(lining.number("low_mm", {0.01, 0.5}));
  uncertainty.liningHigh =
      millimeters(lining.number("high_mm", {inMillimeters(uncertainty.liningLow), 0.5}));
  TomlReader membrane = sourcedTable(*reader, "membrane", uncertainty);
  uncertainty.membraneLow = newtonsPerMeter(membrane.number("low_N_m", {0.01, 1000.0}));
  uncertainty.membraneHigh =
      newtonsPerMeter(membrane.number("high_N_m", {uncertainty.membraneLow.si(), 1000.0}));
  if (const auto done = reader->finish(); !done) return done.error();
  return uncertainty;
}

std::filesystem::path shippedUncertaintyFile()
{
  return resource("resources/planning/uncertainty.toml");
}

Result<Uncertainty> shippedUncertainty()
{
  auto uncertainty = loadUncertainty(shippedUncertaintyFile());
  if (!uncertainty) return uncertainty;
  const auto packing = analysis::shippedPackingRange();
  if (!packing) return packing.error();
  uncertainty->packing = *packing;
  return uncertainty;
}

}  // namespace perilymph::planning
