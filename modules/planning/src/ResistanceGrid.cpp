// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/planning/ResistanceGrid.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <numbers>
#include <numeric>

#include "PlanNumbers.h"
#include "perilymph/analysis/PhysicalRanges.h"
#include "perilymph/foundation/AtomicFile.h"
#include "perilymph/foundation/Math.h"
#include "perilymph/foundation/Sha256.h"
#include "perilymph/foundation/Version.h"

namespace perilymph::planning {

namespace {

/// Standard deviations of the prior that the grid reaches on both sides (choice, high: 99.7 %).
constexpr double reach = 3.0;
constexpr std::uint64_t resistanceFormat = 1;
constexpr const char* resistanceKind = "resistance in a clinic";
constexpr double infinity = std::numeric_limits<double>::infinity();

double shiftAt(std::size_t place, std::size_t places, double sd)
{
  return reach * sd * (2.0 * static_cast<double>(place) / static_cast<double>(places - 1) - 1.0);
}

/// exp(-x^2 / 2 s^2): a normal density without its factor.
double bell(double x, double sd) { return exponential(-0.5 * (x / sd) * (x / sd)); }

/// Thrown within this file only: why a text is no clinic's resistance.
struct InvalidFile {
  std::string reason;
};

const nlohmann::json& at(const nlohmann::json& json, const char* key)
{
  const auto found = json.find(key);
  if (found == json.end()) throw InvalidFile{std::string(key) + " is missing"};
  return *found;
}

double numberAt(const nlohmann::json& json, const char* key, Range range)
{
  const nlohmann::json& value = at(json, key);
  if (!value.is_number()) throw InvalidFile{std::string(key) + " is not a number"};
  const auto number = value.get<double>();
  if (auto reason = analysis::impossibility(key, "", number, range); !reason.empty())
    throw InvalidFile{std::move(reason)};
  return number;
}

std::size_t countAt(const nlohmann::json& json, const char* key)
{
  constexpr double maxOutcomes = 1e6;
  const nlohmann::json& value = at(json, key);
  if (!value.is_number_unsigned()) throw InvalidFile{std::string(key) + " is not a whole number"};
  return static_cast<std::size_t>(numberAt(json, key, {0.0, maxOutcomes}));
}

ResistanceCells cellsIn(const nlohmann::json& rows)
{
  const auto fail = [] {
    throw InvalidFile{"probability is not " + std::to_string(frictionShifts) + " lists of " +
                      std::to_string(stopShifts) + " numbers from 0 to 1"};
  };
  ResistanceCells cells{};
  if (!rows.is_array() || rows.size() != frictionShifts) fail();
  double sum = 0.0;
  for (std::size_t f = 0; f < frictionShifts; ++f) {
    if (!rows[f].is_array() || rows[f].size() != stopShifts) fail();
    for (std::size_t g = 0; g < stopShifts; ++g) {
      if (!rows[f][g].is_number()) fail();
      const auto p = rows[f][g].get<double>();
      if (!(p >= 0.0 && p <= 1.0)) fail();
      cells[f * stopShifts + g] = p;
      sum += p;
    }
  }
  constexpr double rounding = 1e-3;
  if (std::fabs(sum - 1.0) > rounding) throw InvalidFile{"its probabilities do not add up to 1"};
  for (double& cell : cells) cell /= sum;
  return cells;
}

}  // namespace

double frictionShift(std::size_t place) { return shiftAt(place, frictionShifts, frictionShiftSd); }
double stopShift(std::size_t place) { return shiftAt(place, stopShifts, stopShiftSd); }

double normalBelow(double deviate) { return 0.5 * std::erfc(-deviate / std::numbers::sqrt2); }

ResistanceCells resistancePrior()
{
  ResistanceCells cells{};
  double sum = 0.0;
  for (std::size_t f = 0; f < frictionShifts; ++f)
    for (std::size_t g = 0; g < stopShifts; ++g)
      sum += cells[f * stopShifts + g] =
          bell(frictionShift(f), frictionShiftSd) * bell(stopShift(g), stopShiftSd);
  for (double& cell : cells) cell /= sum;
  return cells;
}

double StopDraw::depth_mm(std::size_t place) const
{
  return std::min({intended_mm, stop_mm[place], isFull ? infinity : end_mm});
}

StopDraw stopDrawOf(const UnstoppedDraw& draw)
{
  using haptics::InsertionEnd;
  StopDraw result;
  result.logFriction = logarithm(draw.friction);
  result.intended_mm = inMillimeters(draw.intended);
  result.end_mm = inMillimeters(draw.curve.depth);
  // at the highest force it was followed no further, and no limit of the grid is as high
  result.isFull = draw.curve.end == InsertionEnd::finished ||
                  draw.curve.end == InsertionEnd::stoppedByResistance;
  for (std::size_t g = 0; g < stopShifts; ++g) {
    const auto length = draw.curve.lengthAt(exponential(stopShift(g)) * draw.stop);
    result.stop_mm[g] = length ? inMillimeters(*length) : infinity;
  }
  return result;
}

std::vector<double> frictionWeights(const StopDraws& draws, std::size_t place)
{
  const double wantedSd = std::sqrt(earFrictionSd * earFrictionSd + kernelSd * kernelSd);
  const double f = frictionShift(place);
  std::vector<double> weights;
  weights.reserve(draws.draws.size());
  for (const StopDraw& each : draws.draws)
    weights.push_back(bell(each.logFriction - f, wantedSd) /
                      bell(each.logFriction, draws.logFrictionSd));
  const double sum = std::accumulate(weights.begin(), weights.end(), 0.0);
  for (double& weight : weights) weight /= sum;
  return weights;
}

WeightedDepths depthsIn(const ResistanceCells& cells, const StopDraws& draws)
{
  const std::size_t count = draws.draws.size();
  std::vector<std::array<double, stopShifts>> weights(count);
  for (std::size_t f = 0; f < frictionShifts; ++f) {
    const std::vector<double> own = frictionWeights(draws, f);
    for (std::size_t k = 0; k < count; ++k)
      for (std::size_t g = 0; g < stopShifts; ++g)
        weights[k][g] += cells[f * stopShifts + g] * own[k];
  }
  WeightedDepths result;
  double squares = 0.0;
  for (std::size_t k = 0; k < count; ++k) {
    double ofDraw = 0.0;
    for (std::size_t g = 0; g < stopShifts; ++g) {
      result.depths_mm.emplace_back(draws.draws[k].depth_mm(g), weights[k][g]);
      ofDraw += weights[k][g];
    }
    squares += ofDraw * ofDraw;
  }
  std::sort(result.depths_mm.begin(), result.depths_mm.end());
  result.effective = squares > 0.0 ? 1.0 / squares : 0.0;
  return result;
}

double WeightedDepths::percentile(double depth_mm, double sd_mm) const
{
  double below = 0.0;
  for (const auto& [depth, weight] : depths_mm) {
    const double off = depth_mm - depth;
    const double isBelow = off > 0.0 ? 1.0 : off < 0.0 ? 0.0 : 0.5;
    below += weight * (sd_mm > 0.0 ? normalBelow(off / sd_mm) : isBelow);
  }
  return (effective * below + 0.5) / (effective + 1.0);
}

Band WeightedDepths::band() const
{
  const auto quantile = [this](double fraction) {
    double below = 0.0, place = 0.0, depth = 0.0;
    for (const auto& [next, weight] : depths_mm) {
      const double nextPlace = (effective * (below + 0.5 * weight) + 0.5) / (effective + 1.0);
      if (nextPlace >= fraction)
        return place > 0.0 ? depth + (next - depth) * (fraction - place) / (nextPlace - place)
                           : next;
      below += weight;
      place = nextPlace;
      depth = next;
    }
    return depth;
  };
  return {quantile(0.05), quantile(0.25), quantile(0.5), quantile(0.75), quantile(0.95)};
}

std::string clinicResistanceText(const ClinicResistance& clinic)
{
  using nlohmann::ordered_json;
  ordered_json json = {{"format", resistanceFormat},
                       {"kind", resistanceKind},
                       {"program", "Perilymph " + version()},
                       {"friction", rounded(clinic.friction)},
                       {"stopped_by_resistance", clinic.resisted},
                       {"censored", clinic.censored},
                       {"not_informative", clinic.uninformative},
                       {"log_score", rounded(clinic.logScore)},
                       {"first_year", clinic.firstYear},
                       {"last_year", clinic.lastYear},
                       {"probability", ordered_json::array()}};
  for (std::size_t f = 0; f < frictionShifts; ++f) {
    ordered_json row = ordered_json::array();
    for (std::size_t g = 0; g < stopShifts; ++g)
      row.push_back(rounded(clinic.cells[f * stopShifts + g]));
    json["probability"].push_back(std::move(row));
  }
  json[sealKey] = sealToBe();
  return sealed(json.dump(1) + "\n");
}

Result<ClinicResistance> clinicResistanceIn(const std::string& text, const std::string& name)
{
  const auto refused = [&name](const std::string& reason) {
    return Error{
        "%1 is not the resistance of a clinic: %2. Give a file that 'perilymph-cli outcomes "
        "--resistance' wrote.",
        name, reason};
  };
  try {
    const auto json = nlohmann::json::parse(text);
    if (!json.is_object()) return refused("it is not JSON with keys");
    const std::size_t format = countAt(json, "format");
    if (format > resistanceFormat)
      return Error{"%1 is of a newer program (format %2). Use it with that one.", name, format};
    if (at(json, "kind") != resistanceKind) return refused("kind is another one");
    if (sealIn(text, true) != Seal::intact)
      return Error{
          "%1 was changed after the program wrote it, so that it is not used. Write it again with "
          "'perilymph-cli outcomes --resistance'.",
          name};
    ClinicResistance clinic;
    clinic.friction = numberAt(json, "friction", {0.001, 2.0});
    clinic.resisted = countAt(json, "stopped_by_resistance");
    clinic.censored = countAt(json, "censored");
    clinic.uninformative = countAt(json, "not_informative");
    constexpr double maxScore = 1e6;
    clinic.logScore = numberAt(json, "log_score", {-maxScore, maxScore});
    constexpr Range years{1900.0, 9999.0};
    clinic.firstYear = static_cast<int>(numberAt(json, "first_year", years));
    clinic.lastYear = static_cast<int>(
        numberAt(json, "last_year", {static_cast<double>(clinic.firstYear), years.high}));
    clinic.cells = cellsIn(at(json, "probability"));
    Sha256 hash;
    hash.add(text);
    clinic.number = hash.hex();
    return clinic;
  } catch (const InvalidFile& invalid) {
    return refused(invalid.reason);
  } catch (const nlohmann::json::exception&) {
    return refused("it is not JSON");
  }
}

Result<ClinicResistance> loadClinicResistance(const std::filesystem::path& file)
{
  const auto text = readWhole(file);
  if (!text) return text.error();
  return clinicResistanceIn(*text, file.string());
}

}  // namespace perilymph::planning
