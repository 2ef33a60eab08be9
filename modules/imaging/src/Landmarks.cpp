// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/imaging/Landmarks.h"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <vector>

#include "SeriesNote.h"
#include "perilymph/foundation/AtomicFile.h"
#include "perilymph/foundation/Choice.h"
#include "perilymph/foundation/Utf8.h"

namespace perilymph::imaging {

namespace {

using Json = nlohmann::json;

constexpr double samePlace_mm = 0.01;  // as programs round
constexpr std::size_t maxName = 40;    // of a text in a message

/// How a list gives its coordinates.
struct Coordinates {
  bool isRas = false;
  double mm = 1.0;  ///< Length of one unit.
};

std::optional<Eigen::Vector3d> pointOf(const Json& control, const Coordinates& coordinates)
{
  const auto place = control.find("position");
  if (place == control.end() || !place->is_array() || place->size() != 3) return std::nullopt;
  Eigen::Vector3d point;
  for (std::size_t i = 0; i < 3; ++i) {
    if (!(*place)[i].is_number()) return std::nullopt;
    point[static_cast<Eigen::Index>(i)] = (*place)[i].get<double>();
  }
  if (!point.allFinite()) return std::nullopt;
  point *= coordinates.mm;
  if (coordinates.isRas) point.head<2>() = -point.head<2>();
  return point;
}

std::string textOf(const Json& object, const char* key)
{
  const auto found = object.find(key);
  return found != object.end() && found->is_string() ? found->get<std::string>() : std::string();
}

struct Unit {
  const char* name;
  double mm;
};
constexpr Unit units[] = {{"mm", 1.0}, {"um", 1e-3}, {"cm", 10.0}, {"m", 1000.0}};

/// Millimeters of the unit of a list; none where it is another one. By the schema it is millimeters if it is absent, and
/// a name or a code, [value, scheme, meaning].
std::optional<double> unitOf(const Json& markup)
{
  const auto stated = markup.find("coordinateUnits");
  if (stated == markup.end()) return 1.0;
  const Json* name = &*stated;
  if (name->is_array() && !name->empty()) name = &(*name)[0];
  if (!name->is_string()) return std::nullopt;
  for (const Unit& unit : units)
    if (name->get<std::string>() == unit.name) return unit.mm;
  return std::nullopt;
}

/// Whether a list of points names a coordinate system that is known; by the schema it is LPS if it is absent.
std::optional<Coordinates> coordinatesOf(const Json& markup)
{
  Coordinates coordinates;
  const auto mm = unitOf(markup);
  if (!mm) return std::nullopt;
  coordinates.mm = *mm;
  if (!markup.contains("coordinateSystem")) return coordinates;
  static constexpr std::array systems{Choice<bool>{true, "RAS"}, Choice<bool>{true, "0"},
                                      Choice<bool>{false, "LPS"}, Choice<bool>{false, "1"}};
  const auto isRas = valueIn(systems, textOf(markup, "coordinateSystem"));
  if (!isRas) return std::nullopt;
  coordinates.isRas = *isRas;
  return coordinates;
}

/// A JSON text; discarded where it is none.
/// @param twice  The name that an object gives two values, of which a parser takes the last; empty where there is none.
Json parsedJson(const std::string& text, std::string& twice)
{
  std::vector<std::set<std::string>> keys;  // of the objects that are open
  const Json::parser_callback_t note = [&](int, Json::parse_event_t event, const Json& parsed) {
    if (event == Json::parse_event_t::object_start) keys.emplace_back();
    if (event == Json::parse_event_t::object_end) keys.pop_back();
    if (event == Json::parse_event_t::key && twice.empty())
      if (std::string key = parsed.get<std::string>(); !keys.back().insert(key).second)
        twice = std::move(key);
    return true;
  };
  return Json::parse(text, note, false);
}

/// Adds the points of one list; false where it is not one that can be read. A name at two places is kept in `twice`.
bool addPoints(const Json& markup, ct::Marks& marks, std::optional<ct::Mark>& twice)
{
  if (!markup.is_object()) return false;
  const auto points = markup.find("controlPoints");
  const auto coordinates = coordinatesOf(markup);
  if (!coordinates || points == markup.end() || !points->is_array()) return false;
  for (const Json& control : *points) {
    if (!control.is_object()) return false;
    const std::optional<ct::Mark> mark = ct::markNamed(textOf(control, "label"));
    const std::string status = textOf(control, "positionStatus");
    if (!mark || (!status.empty() && status != "defined")) continue;
    const auto point = pointOf(control, *coordinates);
    if (!point) return false;
    if (marks[*mark] && (*point - *marks[*mark]).norm() > samePlace_mm) twice = *mark;
    marks[*mark] = point;
  }
  return true;
}

/// Whether a point was placed by this program in another series.
bool isOfAnotherSeries(const Json& markup, const std::string& seriesKey)
{
  if (!markup.is_object() || !markup.contains("controlPoints")) return false;
  const Json& points = markup["controlPoints"];
  return std::any_of(points.begin(), points.end(), [&seriesKey](const Json& point) {
    const std::string note = point.is_object() ? textOf(point, "description") : std::string();
    return note.starts_with(seriesNote) && note.substr(seriesNote.size()) != seriesKey;
  });
}

}  // namespace

Result<ct::Marks> readLandmarks(const std::filesystem::path& file, const std::string& seriesKey)
{
  const auto content = readWhole(file);
  if (!content) return content.error();
  const Error other{file.string() +
                    " is no Slicer markups file with points named RW, C or A in LPS or RAS. Save "
                    "the points in Slicer as Markups JSON (.mrk.json)."};
  std::string named;
  const Json json = parsedJson(*content, named);
  if (!named.empty())
    return Error{"%1 states \"%2\" twice in one object. Save the points in Slicer again.", file,
                 onOneLine(validUtf8(named.substr(0, maxName)))};
  if (!json.is_object()) return other;
  const auto markups = json.find("markups");
  if (markups == json.end() || !markups->is_array()) return other;
  for (const Json& markup : *markups)
    if (markup.is_object() && !unitOf(markup))
      return Error{
          "%1 gives its points in another unit (coordinateUnits) than mm, um, cm or m. Save the "
          "points in millimeters.",
          file};
  for (const Json& markup : *markups)
    if (isOfAnotherSeries(markup, seriesKey))
      return Error{
          "%1 has landmarks of another CT series than the one that is open. Open that CT, or place "
          "the landmarks in this one.",
          file};
  ct::Marks marks;
  std::optional<ct::Mark> twice;
  for (const Json& markup : *markups)
    if (!addPoints(markup, marks, twice)) return other;
  if (twice)
    return Error{"%1 places the landmark %2 at two points. Keep one of them.", file,
                 nameOf(*twice)};
  if (!marks[ct::Mark::roundWindow] && !marks[ct::Mark::modiolus] && !marks[ct::Mark::apex])
    return other;
  return marks;
}

}  // namespace perilymph::imaging
