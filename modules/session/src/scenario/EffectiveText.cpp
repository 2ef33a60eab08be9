// SPDX-License-Identifier: BSD-3-Clause
#include "scenario/EffectiveText.h"

#include <cmath>
#include <limits>

#include "perilymph/foundation/TomlQuoted.h"
#include "perilymph/session/Csv.h"

namespace perilymph::session {

std::string tomlNumber(double value)
{
  std::string text = shortestDecimal(value);
  // TOML regards a number without decimal point and exponent as an integer.
  if (text.find_first_of(".en") == std::string::npos) text += ".0";
  return text;
}

std::string tomlNumbers(const std::vector<double>& values)
{
  std::string text;
  for (const double value : values) text += (text.empty() ? "[" : ", ") + tomlNumber(value);
  return text + ']';
}

std::string joined(const std::vector<std::string>& names)
{
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text;
}

double exactMillimeters(Length length)
{
  // For a length made by millimeters(), its number is within two ulps of the product.
  double number = inMillimeters(length);
  constexpr int steps = 2;
  for (int i = 0; i < steps; ++i) number = std::nextafter(number, -HUGE_VAL);

  double best = inMillimeters(length);
  std::size_t bestLength = std::numeric_limits<std::size_t>::max();
  for (int i = 0; i <= 2 * steps; ++i) {
    const std::size_t letters = shortestDecimal(number).size();
    if (millimeters(number) == length && letters < bestLength) {
      best = number;
      bestLength = letters;
    }
    number = std::nextafter(number, HUGE_VAL);
  }
  return best;
}

double ScenarioKeys::number(const char* key, Range allowed, double fallback)
{
  const double value = reader_.number(key, allowed, fallback);
  note(key, tomlNumber(value));
  return value;
}

long ScenarioKeys::integer(const char* key, long low, long high, long fallback)
{
  const long value = reader_.integer(key, low, high, fallback);
  note(key, std::to_string(value));
  return value;
}

bool ScenarioKeys::flag(const char* key, bool fallback)
{
  const bool value = reader_.flag(key, fallback);
  note(key, value ? "true" : "false");
  return value;
}

std::string ScenarioKeys::text(const char* key, const std::string& fallback)
{
  const std::string value = reader_.text(key, fallback);
  note(key, tomlQuoted(value));
  return value;
}

void ScenarioKeys::refuseChoice(const char* key, const std::string& name,
                                const std::vector<std::string>& allowed)
{
  const std::string sentence =
      allowed.size() == 2 ? allowed[0] + " or " + allowed[1] : "one of " + joined(allowed);
  reader_.refuse(key, std::string(key) + " is '" + name + "'; it must be " + sentence + ".");
}

void ScenarioKeys::notePatient(const anatomy::Patient& patient, anatomy::AnatomySource anatomy)
{
  const auto noteLength = [this](const char* key, Length length) {
    note(std::string("patient_numbers.") + key, tomlNumber(exactMillimeters(length)));
  };
  note("patient_numbers.label", tomlQuoted(patient.label));
  if (patient.seal == Seal::changed) note("patient_numbers.changed_by_hand", "true");
  if (patient.basalTurn) {
    noteLength("a_mm", patient.basalTurn->a);
    noteLength("b_mm", patient.basalTurn->b);
    if (patient.basalTurn->h) noteLength("h_mm", *patient.basalTurn->h);
    if (const auto& errors = patient.errors) {
      noteLength("a_sd_mm", errors->a);
      noteLength("b_sd_mm", errors->b);
      if (errors->h) noteLength("h_sd_mm", *errors->h);
    }
  } else if (isScaledBy(anatomy, patient)) {
    noteLength("st_length_mm", patient.scalaTympaniLength);
    noteLength("rw_width_mm", patient.roundWindowWidth);
    noteLength("rw_height_mm", patient.roundWindowHeight);
  }
}

std::string ScenarioKeys::asToml() const
{
  // First the keys outside tables: keys after a table's header belong to that table.
  std::string own, tables, table;
  for (const auto& [key, value] : values_) {
    const std::size_t dot = key.find('.');
    if (dot == std::string::npos) {
      own += key + " = " + value + '\n';
      continue;
    }
    if (key.substr(0, dot) != table) {
      table = key.substr(0, dot);
      tables += "\n[" + table + "]\n";
    }
    tables += key.substr(dot + 1) + " = " + value + '\n';
  }
  return own + tables;
}

}  // namespace perilymph::session
