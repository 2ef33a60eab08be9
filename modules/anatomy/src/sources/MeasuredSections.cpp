// SPDX-License-Identifier: BSD-3-Clause

// Reads the mean scala tympani's cross-sections.

#include <algorithm>
#include <string>

#include "perilymph/anatomy/MeanScala.h"
#include "perilymph/foundation/Resources.h"
#include "perilymph/foundation/TomlReader.h"

namespace perilymph::anatomy {
namespace {

void readCoefficients(TomlReader& reader, const char* key,
                      std::array<double, 2 * MeasuredSection::harmonics + 1>& coefficients)
{
  const std::vector<double> given_mm = reader.numbers(key, {-20.0, 20.0}, coefficients.size());
  if (given_mm.size() > coefficients.size())
    reader.refuse(key, std::string(key) + " has " + std::to_string(given_mm.size()) +
                           " numbers; it must have 9, for the harmonics -4 to 4.");
  if (given_mm.size() != coefficients.size()) return;
  std::transform(given_mm.begin(), given_mm.end(), coefficients.begin(),
                 [](double value_mm) { return millimeters(value_mm).si(); });
}

}  // namespace

Result<std::vector<MeasuredSection>> loadMeasuredSections()
{
  auto reader = TomlReader::open(resource("resources/anatomy/mean-scala-tympani.toml"));
  if (!reader) return reader.error();
  reader->text("label");
  reader->text("source");
  std::vector<MeasuredSection> sections;
  for (TomlReader& table : reader->tables("section")) {
    const auto length = [&table](const char* key) {
      return millimeters(table.number(key, {0.0, 20.0})).si();
    };
    MeasuredSection section;
    section.angle = degrees(table.number("angle_deg", {0.0, 1200.0})).si();
    section.innerRadius = length("inner_mm");
    section.outerRadius = length("outer_mm");
    section.height = length("height_mm");
    section.area = table.number("area_mm2", {0.0, 20.0}) / 1e6;
    section.inscribed = length("inscribed_mm");
    readCoefficients(table, "real_mm", section.real);
    readCoefficients(table, "imaginary_mm", section.imaginary);
    if (!sections.empty() && section.angle <= sections.back().angle)
      table.refuse("angle_deg", "angle_deg must grow from section to section.");
    sections.push_back(section);
    // the reader of the whole file keeps the error, which is reported below
    if (!table.finish()) break;
  }
  if (const auto done = reader->finish(); !done) return done.error();
  // a spline needs four knots, the trend a whole turn
  if (sections.size() < 8 || sections.back().angle - sections.front().angle < 2.0 * pi)
    return Error{reader->name() + ": there are " + std::to_string(sections.size()) +
                 " sections; at least 8 over a full turn are needed. Install the program again."};
  return sections;
}

}  // namespace perilymph::anatomy
