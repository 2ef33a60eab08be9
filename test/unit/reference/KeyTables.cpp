// SPDX-License-Identifier: BSD-3-Clause
#include "KeyTables.h"

#include <algorithm>
#include <set>

#include "ArrayKeys.h"
#include "patient/PatientKeys.h"
#include "perilymph/anatomy/Patient.h"
#include "perilymph/electrode/ArrayText.h"
#include "perilymph/session/Scenario.h"
#include "scenario/ScenarioKeyTable.h"

namespace perilymph::test {

namespace {

using Example = std::vector<std::pair<std::string, std::string>>;

/// Far from every key, so that the message lists all of them.
constexpr const char* unknownKey = "qqqqqqqqqqqqqqqqqqqqqqqqqqqqqq";

std::string tableOf(const std::string& key)
{
  const std::size_t dot = key.find('.');
  return dot == std::string::npos ? std::string() : key.substr(0, dot);
}

/// The example as a file, with one key changed, added or, for an empty value, left out.
std::string textWith(const Example& example, const std::string& changed, const std::string& value)
{
  std::vector<std::string> tables = {""};
  for (const auto& [key, given] : example)
    if (std::ranges::find(tables, tableOf(key)) == tables.end()) tables.push_back(tableOf(key));
  std::string text;
  for (const std::string& table : tables) {
    if (!table.empty()) text += "[" + table + "]\n";
    const auto add = [&](const std::string& key, const std::string& given) {
      if (tableOf(key) == table && !given.empty())
        text += (table.empty() ? key : key.substr(table.size() + 1)) + " = " + given + "\n";
    };
    for (const auto& [key, given] : example)
      if (key != changed) add(key, given);
    add(changed, value);
  }
  return text;
}

bool has(const Example& example, const std::string& key)
{
  return std::ranges::any_of(example, [&key](const auto& entry) { return entry.first == key; });
}

/// What follows a mark in a text, up to its last point.
std::string after(const std::string& text, const std::string& mark)
{
  const std::size_t at = text.find(mark);
  if (at == std::string::npos) return {};
  const std::string rest = text.substr(at + mark.size());
  return rest.substr(0, rest.rfind('.'));
}

}  // namespace

KeyedFile scenarioFile()
{
  const Example example = {{"title", "\"t\""},
                           {"patient", "\"\""},
                           {"side", "\"right\""},
                           {"anatomy", "\"mean\""},
                           {"lead_in_mm", "1.0"},
                           {"array", "\"contour\""},
                           {"array_fingerprint", "\"\""},
                           {"calibration", "\"\""},
                           {"stiffness_scale", "1.0"},
                           {"residual_curvature_fraction", "0.0"},
                           {"wire_packing", "0.5"},
                           {"taper_fraction", "0.5"},
                           {"wire_yield_MPa", "300.0"},
                           {"stylet_yield_MPa", "300.0"},
                           {"relaxation_fraction", "[0.1]"},
                           {"relaxation_time_s", "[1.0]"},
                           {"film_relaxation_fraction", "0.1"},
                           {"film_relaxation_time_s", "1.0"},
                           {"technique", "\"standard\""},
                           {"speed_mm_s", "1.0"},
                           {"start_inside_mm", "1.0"},
                           {"stop_travel_mm", "10.0"},
                           {"withdraw", "false"},
                           {"stylet_pull_mm_s", "5.0"},
                           {"approach_tilt_deg", "0.0"},
                           {"approach_turn_deg", "0.0"},
                           {"free_length_mm", "4.0"},
                           {"friction", "\"paper\""},
                           {"friction_static", "0.3"},
                           {"friction_dynamic", "0.2"},
                           {"friction_stopping", "0.1"},
                           {"friction_stribeck_mm_s", "0.1"},
                           {"friction_speed_mm_s", "[1.0, 2.0]"},
                           {"friction_coefficient", "[0.2, 0.2]"},
                           {"friction_shared_sd_log", "0.1"},
                           {"friction_ear_sd_log", "0.1"},
                           {"opening", "\"cochleostomy\""},
                           {"cochleostomy_diameter_mm", "1.0"},
                           {"opening_outward_mm", "0.0"},
                           {"opening_vertical_mm", "0.0"},
                           {"passage_mm", "0.5"},
                           {"passage_modulus_MPa", "1.0"},
                           {"passage_friction", "0.2"},
                           {"rib_exit_loss", "0.0"},
                           {"rim_stiffness_N_m", "441.0"},
                           {"wall_stiffness_N_m", "441.0"},
                           {"wall_lining_mm", "0.1"},
                           {"wall_tangential_stiffness_N_m", "200.0"},
                           {"wall_section_delay_ms", "5.0"},
                           {"wall_edge_mm", "1.0"},
                           {"membrane", "\"soft\""},
                           {"membrane_stiffness_N_m", "2.3"},
                           {"partition_strength_N", "0.1"},
                           {"coupling", "\"rigid\""},
                           {"coupling_stiffness_N_m", "441.0"},
                           {"coupling_damping_N_s_m", "1.0"},
                           {"force_scale", "1.0"},
                           {"stop_force_N", "0.1"},
                           {"model", "\"rod\""},
                           {"nodes", "100"},
                           {"dt_ms", "1.0"},
                           {"seed", "1"}};
  return {&session::scenarioKeyTable(), {example}, [](const std::string& text) {
            const auto read = session::parseScenario(text, "x", {});
            return read ? std::string() : std::string(read.error().message);
          }};
}

KeyedFile patientFile()
{
  const Example lengths = {{"label", "\"P-1\""},     {"side", "\"right\""},
                           {"st_length_mm", "35.0"}, {"rw_width_mm", "1.9"},
                           {"rw_height_mm", "1.8"},  {"content_sha256", "\"changed by hand\""}};
  const Example measures = {{"label", "\"P-1\""},
                            {"side", "\"right\""},
                            {"a_mm", "9.2"},
                            {"b_mm", "6.8"},
                            {"h_mm", "4.0"},
                            {"a_sd_mm", "0.1"},
                            {"b_sd_mm", "0.1"},
                            {"h_sd_mm", "0.1"},
                            {"ab_correlation", "0.1"},
                            {"ah_correlation", "0.1"},
                            {"bh_correlation", "0.1"},
                            {"measured_with", "\"x\""},
                            {"series_sha256", "\"x\""},
                            {"landmarks_by_hand", "\"RW\""},
                            {"landmarks_proposed", "\"A\""},
                            {"content_sha256", "\"changed by hand\""}};
  return {&anatomy::patientKeyTable(), {measures, lengths}, [](const std::string& text) {
            const auto read = anatomy::patientIn(text, "x");
            return read ? std::string() : std::string(read.error().message);
          }};
}

KeyedFile arrayFile()
{
  Example example = {{"name", "\"A\""},
                     {"maker", "\"M\""},
                     {"note", "\"N\""},
                     {"length.value_mm", "30.0"},
                     {"insertable.value_mm", "28.0"},
                     {"diameter.from_tip_mm", "[0.0, 30.0]"},
                     {"diameter.diameter_mm", "[0.5, 1.0]"},
                     {"diameter.thickness_mm", "[0.5, 1.0]"},
                     {"tip.radius_mm", "0.2"},
                     {"tip.taper_mm", "1.0"},
                     {"bending.from_tip_mm", "[0.0, 30.0]"},
                     {"bending.bending_N_m2", "[1e-6, 2e-6]"},
                     {"bending.bending_across_N_m2", "[1e-6, 2e-6]"},
                     {"bending.twisting_N_m2", "[1e-6, 2e-6]"},
                     {"rest_curvature.from_tip_mm", "[0.0, 30.0]"},
                     {"rest_curvature.curvature_per_mm", "[0.0, 0.0]"},
                     {"contacts.from_tip_mm", "[1.0, 20.0]"},
                     {"contacts.contact_length_mm", "0.5"},
                     {"contacts.plates", "\"pair\""},
                     {"contacts.single_plates", "1"},
                     {"contacts.maker_numbering", "\"from_tip\""},
                     {"taper.last_contact_mm", "[0.6, 0.9]"},
                     {"taper.carrier_MPa", "0.2"},
                     {"ribs.from_tip_mm", "[22.0]"},
                     {"ribs.height_mm", "0.1"},
                     {"ribs.length_mm", "0.5"},
                     {"wires.from_tip_mm", "[0.0, 30.0]"},
                     {"wires.number", "[1, 2]"},
                     {"wires.diameter_um", "20.0"},
                     {"wires.modulus_GPa", "100.0"},
                     {"wires.coupling", "0.1"},
                     {"wires.yield_range_MPa", "[100.0, 300.0]"},
                     {"wires.yield_MPa", "200.0"},
                     {"stylet.from_tip_mm", "1.0"},
                     {"stylet.bending_N_m2", "1e-6"},
                     {"stylet.residual_curvature_fraction", "0.0"},
                     {"stylet.hold_depth_mm", "8.0"},
                     {"stylet.diameter_mm", "0.1"},
                     {"stylet.yield_range_MPa", "[100.0, 300.0]"},
                     {"stylet.yield_MPa", "200.0"}};
  std::set<std::string> tables;
  for (const auto& [key, value] : example) tables.insert(tableOf(key));
  for (const std::string& table : tables) {
    if (table.empty()) continue;
    example.emplace_back(table + ".source", "\"s\"");
    example.emplace_back(table + ".confidence", "\"low\"");
  }
  return {&electrode::arrayKeyTable(), {example}, [](const std::string& text) {
            const auto read = electrode::parseArray(text, "x");
            return read ? std::string() : std::string(read.error().message);
          }};
}

std::vector<std::string> knownKeys(const KeyedFile& file)
{
  std::set<std::string> known;
  for (const Example& example : file.examples) {
    std::set<std::string> tables;
    for (const auto& [key, value] : example) tables.insert(tableOf(key));
    for (const std::string& table : tables) {
      const std::string prefix = table.empty() ? "" : table + ".";
      std::string list =
          after(file.problemOf(textWith(example, prefix + unknownKey, "1")), "known are ");
      for (std::size_t begin = 0; begin < list.size();) {
        const std::size_t end = std::min(list.find(", ", begin), list.size());
        const std::string key = list.substr(begin, end - begin);
        if (key != "source" && key != "confidence" && !(table.empty() && tables.contains(key)))
          known.insert(prefix + key);
        begin = end + 2;
      }
    }
  }
  return {known.begin(), known.end()};
}

std::string allowedOf(const KeyedFile& file, const std::string& key)
{
  for (const Example& example : file.examples) {
    // a table has keys of its own and stands in no example
    if (!has(example, key) && file.examples.size() > 1) continue;
    for (const char* const wrong : {"true", "1", "\"?\""}) {
      const std::string problem = file.problemOf(textWith(example, key, wrong));
      if (problem.find(key + " is ") == std::string::npos) continue;
      const std::string allowed = after(problem, "must be ");
      if (!allowed.empty() && allowed != "text in quotation marks") return allowed;
    }
  }
  return "text";
}

bool isRequired(const KeyedFile& file, const std::string& key)
{
  for (const Example& example : file.examples)
    if (has(example, key) &&
        file.problemOf(textWith(example, key, "")).find("'" + key + "' is missing") !=
            std::string::npos)
      return true;
  return false;
}

std::string scenarioDefault(const std::string& key)
{
  if (key == "array_fingerprint") return {};  // it is computed
  const auto scenario = session::parseScenario("", "x", {});
  if (!scenario) return scenario.error().message;
  for (const auto& [name, value] : scenario->values())
    if (name == key) return value;
  return {};
}

}  // namespace perilymph::test
