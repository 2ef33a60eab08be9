// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/imaging/MarkupFiles.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <map>
#include <string_view>

#include "MarkupsJson.h"
#include "perilymph/ct/Marks.h"
#include "perilymph/foundation/CsvField.h"
#include "perilymph/foundation/Normal.h"
#include "perilymph/foundation/Utf8.h"
#include "perilymph/foundation/Version.h"

namespace perilymph::imaging {

namespace {

using Json = nlohmann::json;
using ct::MarkupKind;

constexpr int decimals = 4;  // of a coordinate in a table [0.1 micrometers]
constexpr std::string_view pointLabel = "note";

bool isStructure(MarkupKind kind) { return ct::pointCountOf(kind).most == ct::maxMarkupPoints; }

std::string decimal(double value)
{
  std::array<char, 64> digits{};
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value,
                                 std::chars_format::fixed, decimals)
                       .ptr;
  return {digits.data(), end};
}

Json measurementJson(MarkupKind kind, const ct::MarkupValue& value)
{
  return {{"name", kind == MarkupKind::angle ? "angle" : "length"},
          {"enabled", true},
          {"value", value.value},
          {"units", unitOf(kind)},
          {"description",
           "standard deviation of placing its points " + decimal(value.sd) + " " + unitOf(kind)},
          {"printFormat", kind == MarkupKind::angle ? "%.1f %s" : "%.2f %s"}};
}

const char* typeOf(const ct::Markup& markup)
{
  if (markup.kind == MarkupKind::distance || markup.kind == MarkupKind::approach) return "Line";
  if (markup.kind == MarkupKind::angle) return "Angle";
  return markup.points_P.size() > 1 ? "Curve" : "Fiducial";
}

/// The kind of structure that a point's label names, with or without a number; empty for others.
std::optional<MarkupKind> structureNamed(std::string_view label)
{
  if (const auto end = label.find_last_not_of("0123456789 -"); end != std::string_view::npos)
    label = label.substr(0, end + 1);
  const auto kind = valueIn(ct::markupKinds, label);
  return kind && isStructure(*kind) ? kind : std::nullopt;
}

/// A text of another program as one that can be kept.
std::string keptText(const std::string& text)
{
  std::string kept = onOneLine(text);
  std::size_t end = std::min(kept.size(), ct::maxMarkupText);
  // not within a character of several bytes
  while (end < kept.size() && (static_cast<unsigned char>(kept[end]) & 0xC0U) == 0x80U) --end;
  kept.resize(end);
  return kept;
}

/// Adds what one list holds; false where it cannot be read.
bool addMarkups(const Json& list, std::vector<ct::Markup>& markups)
{
  if (!list.is_object()) return false;
  const auto controls = list.find("controlPoints");
  const auto coordinates = coordinatesOf(list);
  if (!coordinates || controls == list.end() || !controls->is_array()) return false;
  static constexpr std::array measured{Choice<MarkupKind>{MarkupKind::distance, "Line"},
                                       Choice<MarkupKind>{MarkupKind::angle, "Angle"}};
  const std::string type = textOf(list, "type"), name = keptText(textOf(list, "name"));
  auto kind = valueIn(measured, type);
  if (kind == MarkupKind::distance && name == nameIn(ct::markupKinds, MarkupKind::approach))
    kind = MarkupKind::approach;
  if (!kind && type != "Fiducial" && type != "Curve") return true;  // planes, regions of interest
  ct::Markup whole{kind.value_or(MarkupKind::note), {}, name};
  std::map<MarkupKind, ct::Markup> structures;
  for (const Json& control : *controls) {
    if (!control.is_object()) return false;
    if (!isDefined(control)) continue;
    const auto point = controlPointOf(control, *coordinates);
    if (!point) return false;
    const std::string label = keptText(textOf(control, "label"));
    if (kind) {
      whole.points_P.push_back(*point);
    } else if (const auto structure = structureNamed(label)) {
      ct::Markup& each = structures.try_emplace(*structure, ct::Markup{*structure}).first->second;
      each.points_P.push_back(*point);
      each.text = name == nameIn(ct::markupKinds, *structure) ? std::string() : name;
    } else if (!ct::markNamed(label)) {
      markups.push_back(
          {MarkupKind::note, {*point}, label.empty() ? std::string(pointLabel) : label});
    }
  }
  if (kind) {
    if (name == nameIn(ct::markupKinds, *kind)) whole.text.clear();
    markups.push_back(std::move(whole));
  }
  for (auto& [structure, each] : structures) markups.push_back(std::move(each));
  return true;
}

struct Column {
  const char *name, *unit, *meaning;
};
constexpr Column columns[] = {
    {"number", "", "number of the markup in its CT, from 1"},
    {"kind", "", "distance, angle, note, facial_nerve, chorda_tympani, canal_wall or approach"},
    {"text", "", "words of the person who placed it"},
    {"value", "of unit", "length of a distance, size of an angle; empty for other kinds"},
    {"sd", "of unit", "standard deviation of placing each point to its voxel"},
    {"unit", "", "mm or deg"},
    {"point", "", "number of the point in its markup; the second one of an angle is its vertex"},
    {"x_lps_mm", "mm", "place in the CT, to the patient's left"},
    {"y_lps_mm", "mm", "to the back"},
    {"z_lps_mm", "mm", "to the head"},
    {"series_sha256", "", "SHA-256 of the CT series"}};

}  // namespace

std::string slicerMarkups(const ct::CtMarkups& markups)
{
  Json lists = Json::array();
  for (const ct::Markup& each : markups.markups) {
    const std::string kind = nameIn(ct::markupKinds, each.kind);
    LabeledPoints points;
    for (const Eigen::Vector3d& point : each.points_P)
      points.emplace_back(each.kind == MarkupKind::note
                              ? each.text
                              : kind + "-" + std::to_string(points.size() + 1),
                          point);
    const std::string& name = each.text.empty() ? kind : each.text;
    Json list = markupJson(typeOf(each), each.kind == MarkupKind::note ? kind : name,
                           markups.seriesKey, points);
    if (const auto value = ct::valueOf(each, markups.voxelEdges_P))
      list["measurements"] = Json::array({measurementJson(each.kind, *value)});
    lists.push_back(std::move(list));
  }
  return markupsText(lists);
}

std::string markupsJson(const ct::CtMarkups& markups)
{
  using Ordered = nlohmann::ordered_json;
  const auto place = [](const Eigen::Vector3d& point) {
    return Ordered{point.x(), point.y(), point.z()};
  };
  Ordered json = {{"version", buildId()},
                  {"series_sha256", markups.seriesKey},
                  {"coordinate_system", "LPS"},
                  {"voxel_edges_mm", Ordered::array()},
                  {"markups", Ordered::array()}};
  for (int axis = 0; axis < 3; ++axis)
    json["voxel_edges_mm"].push_back(place(markups.voxelEdges_P.col(axis)));
  for (const ct::Markup& each : markups.markups) {
    Ordered item = {{"kind", nameIn(ct::markupKinds, each.kind)},
                    {"text", each.text},
                    {"lps_mm", Ordered::array()}};
    for (const Eigen::Vector3d& point : each.points_P) item["lps_mm"].push_back(place(point));
    if (const auto found = ct::valueOf(each, markups.voxelEdges_P)) {
      item["value"] = found->value;
      item["sd"] = found->sd;
      item["ci95"] = {found->value - halfWidth95 * found->sd,
                      found->value + halfWidth95 * found->sd};
      item["unit"] = unitOf(each.kind);
    }
    json["markups"].push_back(std::move(item));
  }
  return json.dump(2) + "\n";
}

std::string markupsCsv(const ct::CtMarkups& markups)
{
  std::string csv;
  for (const Column& each : columns) csv += (csv.empty() ? "" : ",") + std::string(each.name);
  csv += "\n";
  std::size_t number = 0;
  for (const ct::Markup& each : markups.markups) {
    const auto value = ct::valueOf(each, markups.voxelEdges_P);
    const std::string head =
        std::to_string(++number) + "," + nameIn(ct::markupKinds, each.kind) + "," +
        csvQuoted(each.text) + "," +
        (value ? decimal(value->value) + "," + decimal(value->sd) + "," + unitOf(each.kind)
               : std::string(",,"));
    std::size_t point = 0;
    for (const Eigen::Vector3d& at : each.points_P)
      csv += head + "," + std::to_string(++point) + "," + decimal(at.x()) + "," + decimal(at.y()) +
             "," + decimal(at.z()) + "," + markups.seriesKey + "\n";
  }
  return csv;
}

std::string markupsDictionaryCsv()
{
  std::string csv = "column,unit,meaning\n";
  for (const Column& each : columns)
    csv += std::string(each.name) + "," + each.unit + "," + csvField(each.meaning) + "\n";
  return csv;
}

Result<std::vector<ct::Markup>> readMarkups(const std::filesystem::path& file,
                                            const std::string& seriesKey)
{
  const Error none{
      "%1 is no Slicer markups file with lines, angles, points or curves in LPS or RAS. Save them "
      "in Slicer as Markups JSON (.mrk.json).",
      file};
  const auto lists = readMarkupLists(file, seriesKey, none);
  if (!lists) return lists.error();
  std::vector<ct::Markup> markups;
  for (const Json& list : *lists)
    if (!addMarkups(list, markups)) return none;
  if (markups.empty()) return none;
  for (const ct::Markup& each : markups)
    if (const auto possible = ct::checkMarkup(each); !possible)
      return Error{"%1: %2", file, possible.error().message};
  return markups;
}

}  // namespace perilymph::imaging
