// SPDX-License-Identifier: BSD-3-Clause
#include "MarkupsJson.h"

#include <algorithm>
#include <array>
#include <set>

#include "SeriesNote.h"
#include "perilymph/foundation/AtomicFile.h"
#include "perilymph/foundation/Choice.h"
#include "perilymph/foundation/Utf8.h"

namespace perilymph::imaging {

namespace {

using Json = nlohmann::json;

constexpr std::size_t maxName = 40;  // of a text in a message
constexpr const char* schema =
    "https://raw.githubusercontent.com/slicer/slicer/master/Modules/Loadable/Markups/Resources/"
    "Schema/markups-schema-v1.0.3.json#";

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

Json markupJson(const char* type, const std::string& name, const std::string& seriesKey,
                const LabeledPoints& points)
{
  const std::string description = seriesKey.empty() ? "" : seriesNote + seriesKey;
  Json controls = Json::array();
  for (const auto& [label, point] : points)
    controls.push_back({{"id", std::to_string(controls.size() + 1)},
                        {"label", label},
                        {"description", description},
                        {"position", {point.x(), point.y(), point.z()}},
                        {"positionStatus", "defined"}});
  return {{"type", type},
          {"name", name},
          {"coordinateSystem", "LPS"},
          {"coordinateUnits", "mm"},
          {"controlPoints", controls}};
}

std::string markupsText(const Json& markups)
{
  return Json{{"@schema", schema}, {"markups", markups}}.dump(2) + "\n";
}

std::string textOf(const Json& object, const char* key)
{
  const auto found = object.find(key);
  return found != object.end() && found->is_string() ? found->get<std::string>() : std::string();
}

std::optional<MarkupCoordinates> coordinatesOf(const Json& markup)
{
  MarkupCoordinates coordinates;
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

std::optional<Eigen::Vector3d> controlPointOf(const Json& control,
                                              const MarkupCoordinates& coordinates)
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

bool isDefined(const Json& control)
{
  const std::string status = textOf(control, "positionStatus");
  return status.empty() || status == "defined";
}

Result<std::vector<Json>> readMarkupLists(const std::filesystem::path& file,
                                          const std::string& seriesKey, const Error& none)
{
  const auto content = readWhole(file);
  if (!content) return content.error();
  std::string named;
  const Json json = parsedJson(*content, named);
  if (!named.empty())
    return Error{"%1 states \"%2\" twice in one object. Save the points in Slicer again.", file,
                 onOneLine(validUtf8(named.substr(0, maxName)))};
  if (!json.is_object()) return none;
  const auto markups = json.find("markups");
  if (markups == json.end() || !markups->is_array()) return none;
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
  return std::vector<Json>(markups->begin(), markups->end());
}

}  // namespace perilymph::imaging
