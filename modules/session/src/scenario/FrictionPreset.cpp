// SPDX-License-Identifier: BSD-3-Clause
#include "scenario/FrictionPreset.h"

#include <algorithm>

#include "perilymph/foundation/Resources.h"
#include "perilymph/foundation/TomlReader.h"
#include "scenario/ScenarioFriction.h"

namespace perilymph::session {

namespace {

/// A table with the sources of its values.
TomlReader tableOf(TomlReader& file, const char* name)
{
  TomlReader table = file.table(name);
  table.text("source");
  table.choice("confidence", {"high", "medium", "low"});
  return table;
}

}  // namespace

Result<FrictionPreset> loadFriction(const std::string& nameOrFile)
{
  const auto file = findByName("friction", "resources/friction", nameOrFile);
  if (!file) return file.error();
  auto reader = TomlReader::open(*file);
  if (!reader) return reader.error();

  FrictionPreset preset;
  reader->text("title");
  TomlReader coefficients = tableOf(*reader, "coefficients");
  preset.staticCoefficient = coefficients.number("static", frictionRange);
  if (reader->has("by_speed")) {
    TomlReader table = tableOf(*reader, "by_speed");
    preset.speed_mm_s = table.numbers("speed_mm_s", frictionSpeed_mm_s, 1);
    preset.coefficient = table.numbers("coefficient", frictionRange, 1);
    preset.kineticCoefficient =
        *std::min_element(preset.coefficient.begin(), preset.coefficient.end());
  } else {
    preset.kineticCoefficient = coefficients.number("dynamic", frictionRange);
  }
  TomlReader stoppingCoefficient = tableOf(*reader, "stopping");
  preset.stoppingCoefficient = stoppingCoefficient.number("coefficient", frictionRange);
  if (reader->has("stribeck")) {
    TomlReader stribeck = tableOf(*reader, "stribeck");
    preset.stribeck_mm_s = stribeck.number("speed_mm_s", stribeckRange_mm_s);
  }
  if (const auto done = reader->finish(); !done) return done.error();
  return preset;
}

}  // namespace perilymph::session
