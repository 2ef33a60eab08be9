// SPDX-License-Identifier: BSD-3-Clause
#include "gui/run/ScenarioDifference.h"

#include <algorithm>
#include <array>
#include <iterator>

namespace perilymph::gui {

namespace {

std::string valueOf(const session::Scenario& scenario, const std::string& wanted)
{
  for (const auto& [key, value] : scenario.values())
    if (key == wanted) return value;
  return {};
}

// Keys that affect neither cochlea nor model. Any other key requires a new model.
constexpr std::array notBuiltFrom{"title",        "speed_mm_s",           "stop_travel_mm",
                                  "stop_force_N", "force_scale",          "side",
                                  "patient",      "patient_numbers.label"};

/// All keys except the title, sorted for comparison.
session::Overrides compared(session::Overrides values)
{
  std::erase_if(values, [](const auto& entry) { return entry.first == "title"; });
  std::sort(values.begin(), values.end());
  return values;
}

}  // namespace

std::vector<std::string> differingKeys(const session::Scenario& one, const session::Scenario& other)
{
  const session::Overrides left = compared(one.values()), right = compared(other.values());
  session::Overrides differing;
  std::set_symmetric_difference(left.begin(), left.end(), right.begin(), right.end(),
                                std::back_inserter(differing));
  std::vector<std::string> keys;
  for (const auto& [key, value] : differing)
    if (keys.empty() || keys.back() != key) keys.push_back(key);
  return keys;
}

bool haveSameCochlea(const session::Scenario& one, const session::Scenario& other)
{
  for (const char* key : {"anatomy", "lead_in_mm", "patient_numbers.st_length_mm",
                          "patient_numbers.rw_width_mm", "patient_numbers.rw_height_mm",
                          "patient_numbers.a_mm", "patient_numbers.b_mm", "patient_numbers.h_mm"})
    if (valueOf(one, key) != valueOf(other, key)) return false;
  return true;
}

bool haveSameModel(const session::Scenario& one, const session::Scenario& other)
{
  const std::vector<std::string> keys = differingKeys(one, other);
  return one.arrayFingerprint() == other.arrayFingerprint() &&
         std::all_of(keys.begin(), keys.end(), [](const std::string& key) {
           return std::find(notBuiltFrom.begin(), notBuiltFrom.end(), key) != notBuiltFrom.end();
         });
}

bool lookAlike(const session::Scenario& one, const session::Scenario& other)
{
  return haveSameCochlea(one, other) && one.arrayName() == other.arrayName() &&
         one.arrayFingerprint() == other.arrayFingerprint() &&
         one.patient().side == other.patient().side;
}

}  // namespace perilymph::gui
