// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/planning/ContactsCsv.h"

#include <array>
#include <numeric>
#include <optional>

#include "DictionaryCsv.h"
#include "FrequencyAllocation.h"
#include "PlanNumbers.h"
#include "perilymph/analysis/Tonotopy.h"
#include "perilymph/foundation/CsvField.h"
#include "perilymph/session/Csv.h"

namespace perilymph::planning {

namespace {

constexpr const char* anglesFrom =
    "simulation; consensus panel, Verbist et al. 2010, for the angle";
constexpr const char* fromGreenwood =
    "Greenwood 1990: 165.4 (10^(2.1 x) - 0.88) Hz, x from the apex";
constexpr const char* fromStakhovskaya = "Stakhovskaya et al. 2007, by the angle";
constexpr const char* fromFilters = "resources/planning/frequency-allocation.toml";

constexpr DictionaryRow contactColumns[] = {
    {"array", "", "file name of the array", ""},
    {"contact", "", "number of the contact; 1 is the most apical one. Makers number otherwise", ""},
    {"draws", "", "simulations in which the contact is inserted; 1 or 0 of one insertion", ""},
    {"angle_deg", "degrees", "from the center of the round window, median", anglesFrom},
    {"angle_p5_deg", "degrees",
     "5 % quantile of those simulations, the lowest of fewer than 19; empty of one", anglesFrom},
    {"angle_p95_deg", "degrees", "95 % quantile, the highest of fewer than 19", anglesFrom},
    {"to_modiolus_mm", "mm", "from the center line of the array to the inner wall, median",
     "simulation"},
    {"to_modiolus_p5_mm", "mm", "5 % quantile", "simulation"},
    {"to_modiolus_p95_mm", "mm", "95 % quantile", "simulation"},
    {"greenwood_Hz", "Hz", "frequency of the place along the organ of Corti, at its median",
     fromGreenwood},
    {"spiral_ganglion_Hz", "Hz", "frequency of the spiral ganglion at the median angle",
     fromStakhovskaya},
    {"filter_Hz", "Hz", "center of the filter that the contact gets by default; 0 if unknown",
     fromFilters},
    {"mismatch_semitones", "semitones",
     "spiral-ganglion frequency above the default filter, median; positive: a lower frequency is "
     "heard than the place has; 0 without a filter",
     "difference of the two columns"},
    {"mismatch_p5_semitones", "semitones", "5 % quantile", "difference of the two columns"},
    {"mismatch_p95_semitones", "semitones", "95 % quantile", "difference of the two columns"},
    {"greenwood_p5_Hz", "Hz", "5 % quantile; the variation between listeners is not in it",
     fromGreenwood},
    {"greenwood_p95_Hz", "Hz", "95 % quantile", fromGreenwood},
    {"spiral_ganglion_p5_Hz", "Hz", "at the 95 % bound of the angle", fromStakhovskaya},
    {"spiral_ganglion_p95_Hz", "Hz", "at the 5 % bound of the angle", fromStakhovskaya}};

/// A row; an empty value is an empty field.
template <std::size_t count>
std::string contactRow(const std::string& array, int number, std::size_t draws,
                       const std::array<std::optional<double>, count>& values)
{
  static_assert(count + 3 == std::size(contactColumns));
  std::string row = csvField(array) + "," + std::to_string(number) + "," + std::to_string(draws);
  for (const std::optional<double>& value : values)
    row += "," + (value ? session::shortestDecimal(rounded(*value)) : std::string());
  return row + "\n";
}

}  // namespace

std::string contactsCsv(const Plan& plan)
{
  std::vector<std::size_t> all(plan.arrays.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  return contactsCsv(plan, all);
}

std::string contactsCsv(const Plan& plan, const std::vector<std::size_t>& arrays)
{
  using Value = std::optional<double>;
  std::string csv = headCsv(contactColumns);
  for (const std::size_t index : arrays)
    for (const ContactBand& each : plan.arrays[index].contacts) {
      const bool isInside = each.draws > 0;
      const auto ganglion = [&](double angle_deg) -> Value {
        if (!isInside) return {};
        return analysis::spiralGanglionFrequency(degrees(angle_deg));
      };
      const bool hasInterval = isInside && each.greenwoodHigh_Hz > 0.0;
      std::array<Value, 16> values = {each.angle_deg.median,
                                      each.angle_deg.low,
                                      each.angle_deg.high,
                                      each.toModiolus_mm.median,
                                      each.toModiolus_mm.low,
                                      each.toModiolus_mm.high,
                                      each.greenwood_Hz,
                                      each.spiralGanglion_Hz,
                                      each.filter_Hz,
                                      each.mismatch_semitones.median,
                                      each.mismatch_semitones.low,
                                      each.mismatch_semitones.high,
                                      hasInterval ? Value(each.greenwoodLow_Hz) : Value(),
                                      hasInterval ? Value(each.greenwoodHigh_Hz) : Value(),
                                      ganglion(each.angle_deg.high),
                                      ganglion(each.angle_deg.low)};
      if (each.draws == 1)  // one simulation has no quantiles
        for (const std::size_t bound : {1u, 2u, 4u, 5u, 10u, 11u, 12u, 13u, 14u, 15u})
          values[bound].reset();
      csv += contactRow(plan.arrays[index].array, each.number, each.draws, values);
    }
  return csv;
}

Result<std::string> insertionContactsCsv(const std::string& name,
                                         const electrode::ArrayDesign& array,
                                         const std::vector<analysis::ContactPosition>& contacts)
{
  using Value = std::optional<double>;
  const auto allocations = shippedAllocations();
  if (!allocations) return allocations.error();
  const std::vector<double> filter_Hz = filtersOf(array, *allocations);
  std::string csv = headCsv(contactColumns);
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    const analysis::ContactPosition& contact = contacts[i];
    const double filter = i < filter_Hz.size() ? filter_Hz[i] : 0.0;
    std::array<Value, 16> values{};
    values[8] = filter;
    if (contact.isInserted) {
      const double ganglion = analysis::spiralGanglionFrequency(contact.angle);
      values[0] = inDegrees(contact.angle);
      if (contact.toModiolus.si() >= 0.0) values[3] = inMillimeters(contact.toModiolus);
      values[6] = contact.frequency_Hz;
      values[7] = ganglion;
      values[9] = filter > 0.0 ? analysis::semitones(filter, ganglion) : 0.0;
    }
    csv += contactRow(name, contact.number, contact.isInserted ? 1 : 0, values);
  }
  return csv;
}

std::string contactsDictionaryCsv() { return dictionaryCsv(contactColumns); }

}  // namespace perilymph::planning
