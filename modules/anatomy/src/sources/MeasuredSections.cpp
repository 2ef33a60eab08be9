// SPDX-License-Identifier: BSD-3-Clause

// Reads the mean scala tympani's cross-sections.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <string>
#include <tuple>

#include "perilymph/anatomy/MeanScala.h"
#include "perilymph/foundation/Math.h"
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

/// Measures of an outline that the file also states.
struct OutlineMeasures {
  double innerRadius = infinity, outerRadius = -infinity;  // [m]
  double height = 0.0, area = 0.0;                         // [m], [m^2]
  double middle = 0.0;  ///< Height of the middle between floor and roof [m].

private:
  static constexpr double infinity = std::numeric_limits<double>::infinity();
};

OutlineMeasures measuresOf(const MeasuredSection& section)
{
  constexpr int points = 360;
  OutlineMeasures measures;
  double floor = 0.0, roof = 0.0, rBefore = 0.0, zBefore = 0.0;
  for (int i = 0; i <= points; ++i) {
    double r = 0.0, z = 0.0;
    for (int k = 0; k <= 2 * MeasuredSection::harmonics; ++k) {
      const auto index = static_cast<std::size_t>(k);
      const SineCosine turn = sineCosine((k - MeasuredSection::harmonics) * 2.0 * pi * i / points);
      r += section.real[index] * turn.cosine - section.imaginary[index] * turn.sine;
      z += section.real[index] * turn.sine + section.imaginary[index] * turn.cosine;
    }
    measures.innerRadius = std::min(measures.innerRadius, r);
    measures.outerRadius = std::max(measures.outerRadius, r);
    floor = i == 0 ? z : std::min(floor, z);
    roof = i == 0 ? z : std::max(roof, z);
    if (i > 0) measures.area += 0.5 * (rBefore * z - zBefore * r);
    rBefore = r;
    zBefore = z;
  }
  measures.height = roof - floor;
  measures.middle = 0.5 * (roof + floor);
  return measures;
}

// The outlines are within 24 um of the measured ones (the file's header), and their areas within
// 0.3 %. Their middles are within 0.12 mm of the mean of their neighbors'.
constexpr Length maxOutlineError = millimeters(0.03);
constexpr double maxAreaError = 0.01;
constexpr Length maxBend = millimeters(0.16);

/// Refuses coefficients whose outline is not the one that was measured.
void checkOutline(TomlReader& table, const MeasuredSection& section, const OutlineMeasures& found)
{
  const auto refuse = [&](const char* key, double given, double outline, const char* unit) {
    char text[160];
    std::snprintf(text, sizeof text,
                  "%s is %.3f%s, but real_mm and imaginary_mm describe an outline of %.3f%s: the "
                  "section is damaged. Install the program again.",
                  key, given, unit, outline, unit);
    table.refuse(key, text);
  };
  for (const auto& [key, given, outline] :
       {std::tuple{"inner_mm", section.innerRadius, found.innerRadius},
        std::tuple{"outer_mm", section.outerRadius, found.outerRadius},
        std::tuple{"height_mm", section.height, found.height}})
    if (!(std::fabs(given - outline) <= maxOutlineError.si()))
      return refuse(key, 1e3 * given, 1e3 * outline, " mm");
  if (!(std::fabs(found.area - section.area) <= maxAreaError * section.area))
    return refuse("area_mm2", 1e6 * section.area, 1e6 * found.area, " mm2");
}

}  // namespace

Result<std::vector<MeasuredSection>> loadMeasuredSections()
{
  auto reader = TomlReader::open(resource("resources/anatomy/mean-scala-tympani.toml"));
  if (!reader) return reader.error();
  reader->text("label");
  reader->text("source");
  std::vector<MeasuredSection> sections;
  std::vector<double> middles;  // height of each section [m]
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
    const OutlineMeasures found = measuresOf(section);
    checkOutline(table, section, found);
    middles.push_back(found.middle);
    sections.push_back(section);
    // the reader of the whole file keeps the error, which is reported below
    if (!table.finish()) break;
  }
  if (const auto done = reader->finish(); !done) return done.error();
  // a spline needs four knots, the trend a whole turn
  if (sections.size() < 8 || sections.back().angle - sections.front().angle < 2.0 * pi)
    return Error{
        "%1: there are %2 sections; at least 8 over a full turn are needed. Install the program "
        "again.",
        reader->name(), sections.size()};
  for (std::size_t i = 1; i + 1 < middles.size(); ++i)
    if (!(std::fabs(middles[i] - 0.5 * (middles[i - 1] + middles[i + 1])) <= maxBend.si()))
      return Error{
          "%1: imaginary_mm of section %2 sets it more than 0.16 mm above or below its neighbors: "
          "the file is damaged. Install the program again.",
          reader->name(), i + 1};
  return sections;
}

}  // namespace perilymph::anatomy
