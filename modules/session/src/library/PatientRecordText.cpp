// SPDX-License-Identifier: BSD-3-Clause
#include "library/PatientRecordText.h"

#include <nlohmann/json.hpp>
#include <utility>

#include "perilymph/foundation/Normal.h"
#include "perilymph/foundation/Sha256.h"

namespace perilymph::session {

namespace {

using Json = nlohmann::ordered_json;

constexpr int formatWithoutMarkups = 2;

Json measureJson(Length value, std::optional<Length> error)
{
  const double value_mm = inMillimeters(value);
  Json json = {{"value", value_mm}};
  if (!error) return json;
  const double sd_mm = inMillimeters(*error);
  json["sd"] = sd_mm;
  json["ci95"] = {value_mm - halfWidth95 * sd_mm, value_mm + halfWidth95 * sd_mm};
  return json;
}

/// The measures of a version, for other programs: they follow from its text.
Json measuresJson(const anatomy::Patient& patient)
{
  if (!patient.basalTurn)
    return {{"st_length_mm", measureJson(patient.scalaTympaniLength, {})},
            {"rw_width_mm", measureJson(patient.roundWindowWidth, {})},
            {"rw_height_mm", measureJson(patient.roundWindowHeight, {})}};
  const auto& errors = patient.errors;
  const auto errorOf = [&errors](Length anatomy::BasalTurnErrors::*error) {
    return errors ? std::optional((*errors).*error) : std::nullopt;
  };
  Json json = {{"A_mm", measureJson(patient.basalTurn->a, errorOf(&anatomy::BasalTurnErrors::a))},
               {"B_mm", measureJson(patient.basalTurn->b, errorOf(&anatomy::BasalTurnErrors::b))}};
  if (patient.basalTurn->h)
    json["H_mm"] = measureJson(*patient.basalTurn->h, errors ? errors->h : std::nullopt);
  return json;
}

Json versionJson(const PatientVersion& version)
{
  Json json = {{"saved_utc", version.savedUtc},
               {"program", version.program},
               {"patient_toml", version.patient}};
  if (const auto patient = anatomy::patientIn(version.patient, "version")) {
    json["measures"] = measuresJson(*patient);
    json["series_sha256"] = statedSeries(*patient);
  }
  json["landmarks"] = Json::array();
  for (const PatientLandmark& each : version.landmarks)
    json["landmarks"].push_back(
        {{"name", each.name}, {"lps_mm", each.lps_mm}, {"by_hand", each.isByHand}});
  json["warnings"] = version.warnings;
  return json;
}

Json entriesJson(const std::vector<PatientEntry>& entries)
{
  Json json = Json::array();
  for (const PatientEntry& each : entries)
    json.push_back({{"utc", each.utc}, {"name", each.name}, {"what", each.what}});
  return json;
}

std::vector<PatientEntry> entriesIn(const Json& json)
{
  std::vector<PatientEntry> entries;
  for (const auto& each : json)
    entries.push_back({each.at("utc").get<std::string>(), each.at("name").get<std::string>(),
                       each.at("what").get<std::string>()});
  return entries;
}

PatientVersion versionIn(const Json& json)
{
  PatientVersion version{json.at("saved_utc").get<std::string>(),
                         json.at("program").get<std::string>(),
                         json.at("patient_toml").get<std::string>()};
  for (const auto& each : json.at("landmarks"))
    version.landmarks.push_back({each.at("name").get<std::string>(),
                                 each.at("lps_mm").get<std::array<double, 3>>(),
                                 each.at("by_hand").get<bool>()});
  const auto warnings = json.at("warnings").get<std::vector<std::string>>();
  version.warnings.assign(warnings.begin(), warnings.end());
  return version;
}

Json placeJson(const Eigen::Vector3d& place) { return {place.x(), place.y(), place.z()}; }

Eigen::Vector3d placeIn(const Json& json)
{
  const auto place = json.get<std::array<double, 3>>();
  return {place[0], place[1], place[2]};
}

Json markupsJson(const ct::CtMarkups& markups)
{
  Json json = {{"series_sha256", markups.seriesKey},
               {"coordinate_system", "LPS"},
               {"voxel_edges_mm", Json::array()},
               {"items", Json::array()}};
  for (int axis = 0; axis < 3; ++axis)
    json["voxel_edges_mm"].push_back(placeJson(markups.voxelEdges_P.col(axis)));
  for (const ct::Markup& each : markups.markups) {
    Json item = {{"kind", nameIn(ct::markupKinds, each.kind)}, {"lps_mm", Json::array()}};
    for (const Eigen::Vector3d& point : each.points_P) item["lps_mm"].push_back(placeJson(point));
    item["text"] = each.text;
    if (const auto value = ct::valueOf(each, markups.voxelEdges_P)) {
      item["value"] = value->value;
      item["sd"] = value->sd;
      item["unit"] = unitOf(each.kind);
    }
    json["items"].push_back(std::move(item));
  }
  return json;
}

/// What a key of a markup states is none of what this program knows.
struct UnknownWord {
  const char* key;
};

/// Values are not read: they follow from the points.
ct::CtMarkups markupsIn(const Json& json)
{
  // what a later format may place in another system would be placed wrongly
  if (json.at("coordinate_system").get<std::string>() != "LPS")
    throw UnknownWord{"coordinate_system"};
  ct::CtMarkups markups{json.at("series_sha256").get<std::string>()};
  const auto edges = json.at("voxel_edges_mm").get<std::array<Json, 3>>();
  for (int axis = 0; axis < 3; ++axis)
    markups.voxelEdges_P.col(axis) = placeIn(edges[static_cast<std::size_t>(axis)]);
  for (const Json& item : json.at("items").get<std::vector<Json>>()) {
    const auto kind = valueIn(ct::markupKinds, item.at("kind").get<std::string>());
    if (!kind) throw UnknownWord{"kind"};
    ct::Markup markup{*kind, {}, item.at("text").get<std::string>()};
    for (const Json& place : item.at("lps_mm").get<std::vector<Json>>())
      markup.points_P.push_back(placeIn(place));
    markups.markups.push_back(std::move(markup));
  }
  return markups;
}

/// What format 2 has beyond format 1.
void readFormat2(const Json& json, PatientRecord& record)
{
  record.isChangedByHand = json.at("changed_by_hand").get<bool>();
  for (const auto& each : json.at("versions")) record.versions.push_back(versionIn(each));
  record.plans = entriesIn(json.at("plans"));
  record.insertions = entriesIn(json.at("insertions"));
  for (const auto& each : json.at("outcomes"))
    record.outcomes.push_back({each.at("utc").get<std::string>(),
                               each.at("series_sha256").get<std::string>(),
                               each.at("content").get<std::string>()});
}

}  // namespace

std::string textOf(const PatientRecord& record)
{
  Json json = {{"format", record.markups.empty() ? formatWithoutMarkups : recordFormat},
               {"tags", record.tags},
               {"notes", record.notes},
               {"archived", record.isArchived},
               {"changed_by_hand", record.isChangedByHand},
               {"scans", Json::array()},
               {"versions", Json::array()},
               {"plans", entriesJson(record.plans)},
               {"insertions", entriesJson(record.insertions)},
               {"outcomes", Json::array()}};
  for (const PatientScan& scan : record.scans)
    json["scans"].push_back({{"series_sha256", scan.series}, {"saved_utc", scan.savedUtc}});
  for (const PatientVersion& each : record.versions) json["versions"].push_back(versionJson(each));
  for (const PatientOutcome& each : record.outcomes)
    json["outcomes"].push_back(
        {{"utc", each.utc}, {"series_sha256", each.series}, {"content", each.content}});
  if (!record.markups.empty()) {
    json["markups"] = Json::array();
    for (const ct::CtMarkups& each : record.markups) json["markups"].push_back(markupsJson(each));
  }
  json[sealKey] = sealToBe();
  return sealed(json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
}

Result<PatientRecord> recordIn(const std::string& text, const std::string& name)
{
  PatientRecord record;
  try {
    const auto json = Json::parse(text);
    // A number beyond an int is of no program: as a double it is still greater.
    const auto format = json.at("format").get<double>();
    if (format > recordFormat)
      return Error{"%1 is of a newer program. Open it with that one.", name};
    // Format 1 had no versions, whatever the line of the format says.
    const bool isSealed = format >= formatWithoutMarkups || json.contains("versions");
    record.tags = json.at("tags").get<std::vector<std::string>>();
    record.notes = json.at("notes").get<std::string>();
    record.isArchived = json.at("archived").get<bool>();
    for (const auto& scan : json.value("scans", Json::array()))
      record.scans.push_back(
          {scan.at("series_sha256").get<std::string>(), scan.at("saved_utc").get<std::string>()});
    if (isSealed) readFormat2(json, record);
    for (const Json& each : json.value("markups", Json::array()).get<std::vector<Json>>())
      record.markups.push_back(markupsIn(each));
    record.seal = sealIn(text, isSealed);
    record.isChangedByHand = record.isChangedByHand || record.seal == Seal::changed;
  } catch (const nlohmann::json::exception&) {
    return Error{
        "%1 is not the record of a patient: it needs format, tags, notes and archived. Restore it "
        "from a backup, or remove it.",
        name};
  } catch (const UnknownWord& unknown) {
    return Error{
        "%1 states in \"%2\" of a markup what this program does not know. Restore it from a "
        "backup, "
        "or remove the markup.",
        name, unknown.key};
  }
  if (const auto possible = checkRecord(record); !possible)
    return Error{"%1: %2", name, possible.error().message};
  Sha256 hash;
  hash.add(std::string_view(text));
  record.base = hash.hex();
  return record;
}

}  // namespace perilymph::session
