// SPDX-License-Identifier: BSD-3-Clause
#include "RandomScenario.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <stdexcept>

#include "perilymph/analysis/RandomStream.h"
#include "perilymph/electrode/ArrayDesign.h"
#include "perilymph/foundation/Resources.h"
#include "perilymph/session/Csv.h"

namespace perilymph::test {

namespace {

/// Digits that a person would type.
std::string rounded(double value, double digit)
{
  return session::shortestDecimal(std::round(value / digit) * digit);
}

}  // namespace

std::vector<std::string> shippedArrays()
{
  std::vector<std::string> names;
  const std::filesystem::path folder = resource("plugins/electrodes");
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
    if (entry.path().extension() == ".toml") names.push_back(entry.path().stem().string());
  std::sort(names.begin(), names.end());
  return names;
}

double maxStopTravel_mm(const std::string& array, double startInside_mm)
{
  const auto file = findByName("array", "plugins/electrodes", array);
  if (!file) throw std::runtime_error(file.error().message);
  const auto design = electrode::loadArray(*file);
  if (!design) throw std::runtime_error(design.error().message);
  return std::floor((inMillimeters(design->insertable) - startInside_mm) * 1e3) / 1e3;
}

session::Overrides randomScenario(std::uint64_t seed, std::uint64_t number)
{
  analysis::RandomStream random(seed, number, 0);
  const auto one = [&random](const auto& names) {
    const auto count = static_cast<double>(names.size());
    const auto index = static_cast<std::size_t>(random.uniform() * count);
    return std::string(names[std::min(index, names.size() - 1)]);
  };
  static const std::vector<std::string> arrays = shippedArrays();
  const std::array anatomies = {"published", "mean", "clark"};
  const std::array openings = {"none", "round-window", "cochleostomy"};
  const std::array frictions = {"paper", "soap-10", "soap-50", "soap-90", "tissue"};
  const std::array membranes = {"rigid", "soft"};
  session::Overrides keys;
  const std::string array = one(arrays);
  const double start_mm = std::round(random.between(0.0, 30.0)) / 10.0;
  keys.emplace_back("array", array);
  keys.emplace_back("anatomy", one(anatomies));
  keys.emplace_back("opening", one(openings));
  keys.emplace_back("cochleostomy_diameter_mm", rounded(random.between(1.0, 2.0), 0.1));
  keys.emplace_back("friction", one(frictions));
  keys.emplace_back("membrane", one(membranes));
  keys.emplace_back("approach_tilt_deg", rounded(random.between(-30.0, 30.0), 1.0));
  keys.emplace_back("approach_turn_deg", rounded(random.between(-30.0, 30.0), 1.0));
  keys.emplace_back("speed_mm_s", rounded(std::pow(10.0, random.between(0.0, 1.7)), 0.1));
  keys.emplace_back("nodes", rounded(std::pow(10.0, random.between(1.6, 2.3)), 1.0));
  keys.emplace_back("start_inside_mm", session::shortestDecimal(start_mm));
  keys.emplace_back("stop_travel_mm", session::shortestDecimal(maxStopTravel_mm(array, start_mm)));
  keys.emplace_back("withdraw", random.uniform() < 0.3 ? "true" : "false");
  return keys;
}

}  // namespace perilymph::test
