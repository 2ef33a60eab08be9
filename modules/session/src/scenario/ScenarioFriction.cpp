// SPDX-License-Identifier: BSD-3-Clause
#include "scenario/ScenarioFriction.h"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <tuple>
#include <vector>

#include "perilymph/foundation/Resources.h"
#include "perilymph/foundation/TomlReader.h"

namespace perilymph::session {

namespace {

// Measured on tissue-like lining: 0.24 to 0.59 (Dohr 2021); 1 leaves a margin and keeps the solver
// stable.
constexpr Range frictionRange{0.0, 1.0};
// Hands reach up to 200 mm/s when they slip.
constexpr Range frictionSpeed_mm_s{0.0, 200.0};
constexpr Range stribeckRange_mm_s{0.001, 100.0};
constexpr Range spreadRange{0.0, 1.0};

/// Coefficients of friction in the units of their file. In `resources/friction/`, each with source
/// and confidence.
struct FrictionPreset {
  double staticCoefficient = 0.0;
  double kineticCoefficient = 0.0;  ///< With a table by speed: its minimum.
  double stoppingCoefficient = 0.0;
  double stribeck_mm_s = 0.1;  ///< Choice: below the speeds of hands and of the published test rig.
  std::vector<double> speed_mm_s;
  std::vector<double> coefficient;  ///< At each speed.
  FrictionSpread spread;
};

/// A table with the source of its values.
TomlReader tableOf(TomlReader& file, const char* name)
{
  TomlReader table = file.table(name);
  table.text("source");
  table.choice("confidence", {"high", "medium", "low"});
  return table;
}

/// Reads a preset by a shipped name or a path.
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
  if (reader->has("spread")) {
    TomlReader spread = tableOf(*reader, "spread");
    preset.spread.shared = spread.number("shared_sd_log", spreadRange);
    preset.spread.ear = spread.number("ear_sd_log", spreadRange);
    if (!preset.spread.isKnown())
      spread.refuse("ear_sd_log",
                    "shared_sd_log and ear_sd_log are 0: no spread. Give one of them, or leave the "
                    "table out; then a factor with a standard deviation of 25 % is drawn.");
  }
  if (const auto done = reader->finish(); !done) return done.error();
  return preset;
}

void refuseDisorder(TomlReader& reader, const mechanics::FrictionLaw& law)
{
  if (law.kineticCoefficient > law.staticCoefficient)
    reader.refuse("friction_dynamic", "friction_dynamic is " + tomlNumber(law.kineticCoefficient) +
                                          "; it must not be above friction_static, which is " +
                                          tomlNumber(law.staticCoefficient) + ".");
  if (law.stoppingCoefficient > law.kineticCoefficient)
    reader.refuse("friction_stopping", "friction_stopping is " +
                                           tomlNumber(law.stoppingCoefficient) +
                                           "; it must not be above friction_dynamic, which is " +
                                           tomlNumber(law.kineticCoefficient) + ".");
}

mechanics::FrictionBySpeed bySpeed(TomlReader& reader, const std::vector<double>& speeds_mm_s,
                                   const std::vector<double>& coefficients)
{
  if (speeds_mm_s.empty() && coefficients.empty()) return {};
  std::vector<Speed> speeds;
  speeds.reserve(speeds_mm_s.size());
  for (const double speed : speeds_mm_s) speeds.push_back(millimetersPerSecond(speed));
  try {
    return {speeds, coefficients};
  } catch (const std::invalid_argument& error) {
    reader.refuse("friction_speed_mm_s", error.what());
    return {};
  }
}

}  // namespace

void readFriction(TomlReader& reader, ScenarioKeys& keys,
                  const std::function<bool(const std::string&)>& isOverridden,
                  mechanics::FrictionLaw& law, FrictionSpread& spread)
{
  const std::string name = keys.text("friction", "paper");
  const bool isNamedAnew = isOverridden("friction");
  const auto isGiven = [&](const char* key) {
    return reader.has(key) && (!isNamedAnew || isOverridden(key));
  };

  // A text with all the numbers needs no preset: a recording does not depend on the file.
  FrictionPreset preset;
  if (!isGiven("friction_static") || !isGiven("friction_dynamic") ||
      !isGiven("friction_stopping")) {
    const auto loaded = loadFriction(name);
    if (loaded)
      preset = *loaded;
    else
      reader.refuse("friction", loaded.error().message +
                                    " Or give friction_static, friction_dynamic and "
                                    "friction_stopping.");
  }
  // A coefficient given without a table means friction by the coefficients alone.
  if (isGiven("friction_dynamic")) {
    preset.speed_mm_s.clear();
    preset.coefficient.clear();
  }

  const auto number = [&](const char* key, Range allowed, double usual) {
    const double read = reader.number(key, allowed, usual);
    const double value = isGiven(key) ? read : usual;
    keys.note(key, tomlNumber(value));
    return value;
  };
  const auto numbers = [&](const char* key, Range allowed, const std::vector<double>& usual) {
    const std::vector<double> read =
        reader.has(key) ? reader.numbers(key, allowed, 1) : std::vector<double>();
    const std::vector<double>& values = isGiven(key) ? read : usual;
    if (!values.empty()) keys.note(key, tomlNumbers(values));
    return values;
  };
  const auto speeds_mm_s = numbers("friction_speed_mm_s", frictionSpeed_mm_s, preset.speed_mm_s);
  const auto coefficients = numbers("friction_coefficient", frictionRange, preset.coefficient);
  law.bySpeed = bySpeed(reader, speeds_mm_s, coefficients);
  if (!law.bySpeed.isEmpty()) preset.kineticCoefficient = law.bySpeed.minimum();

  law.staticCoefficient = number("friction_static", frictionRange, preset.staticCoefficient);
  law.kineticCoefficient = number("friction_dynamic", frictionRange, preset.kineticCoefficient);
  law.stoppingCoefficient = number("friction_stopping", frictionRange, preset.stoppingCoefficient);
  law.stribeck = millimetersPerSecond(
      number("friction_stribeck_mm_s", stribeckRange_mm_s, preset.stribeck_mm_s));
  for (const auto& [key, value, usual] :
       {std::tuple{"friction_shared_sd_log", &spread.shared, preset.spread.shared},
        std::tuple{"friction_ear_sd_log", &spread.ear, preset.spread.ear}}) {
    const double read = reader.number(key, spreadRange, usual);
    *value = isGiven(key) ? read : usual;
    if (*value > 0.0) keys.note(key, tomlNumber(*value));
  }
  refuseDisorder(reader, law);
}

}  // namespace perilymph::session
