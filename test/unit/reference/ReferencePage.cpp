// SPDX-License-Identifier: BSD-3-Clause
#include "ReferencePage.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <sstream>

#include "KeyTables.h"
#include "PlanColumns.h"
#include "StudyViews.h"
#include "SummaryColumns.h"
#include "TableColumns.h"
#include "ValidationColumns.h"
#include "perilymph/foundation/AtomicFile.h"
#include "perilymph/outcome/ClinicOutcomes.h"
#include "perilymph/planning/ContactsCsv.h"
#include "perilymph/planning/PlannedShape.h"
#include "perilymph/session/Csv.h"
#include "perilymph/session/Recording.h"
#include "perilymph/test/Places.h"

namespace perilymph::test {

namespace {

using nlohmann::ordered_json;

/// A text in a cell of a table.
std::string cell(const std::string& text)
{
  std::string escaped;
  for (const char letter : text) {
    if (letter == '|') escaped += '\\';
    escaped += letter == '\n' ? ' ' : letter;
  }
  return escaped;
}

std::string code(const std::string& text) { return text.empty() ? "" : "`" + cell(text) + "`"; }

std::string row(const std::vector<std::string>& cells)
{
  std::string line = "|";
  for (const std::string& each : cells) line += each.empty() ? " |" : " " + each + " |";
  return line + "\n";
}

std::string header(const std::vector<std::string>& cells)
{
  std::string line = "|";
  for (std::size_t i = 0; i < cells.size(); ++i) line += "---|";
  return row(cells) + line + "\n";
}

/// "between 0 and 5" of "a number, between 0 and 5".
std::string limitsOf(const std::string& allowed)
{
  const std::string number = "a number, ";
  return allowed.starts_with(number) ? allowed.substr(number.size()) : allowed;
}

std::string keys(const KeyedFile& file, bool hasDefaults)
{
  std::string text = header({"key", "unit", hasDefaults ? "default" : "", "allowed", "meaning"});
  for (const FieldMeaning& each : *file.meanings) {
    const std::string given = hasDefaults                   ? code(scenarioDefault(each.name))
                              : isRequired(file, each.name) ? "required"
                                                            : "";
    text += row({code(each.name), each.unit, given, cell(limitsOf(allowedOf(file, each.name))),
                 cell(each.meaning)});
  }
  return text;
}

std::string columns(const std::string& title, const FieldMeanings& meanings)
{
  std::string text = "### " + title + "\n\n" + header({"column", "unit", "meaning"});
  for (const FieldMeaning& each : meanings)
    text += row({code(each.name), each.unit, cell(each.meaning)});
  return text + "\n";
}

/// The fields of a line of CSV.
std::vector<std::string> fieldsOf(const std::string& line)
{
  std::vector<std::string> fields(1);
  bool isQuoted = false;
  for (const char letter : line)
    if (letter == '"')
      isQuoted = !isQuoted;
    else if (letter == ',' && !isQuoted)
      fields.emplace_back();
    else
      fields.back() += letter;
  return fields;
}

FieldMeanings contactColumns()
{
  FieldMeanings columns;
  std::istringstream lines(planning::contactsDictionaryCsv());
  std::string line;
  std::getline(lines, line);
  while (std::getline(lines, line)) {
    const auto fields = fieldsOf(line);
    columns.push_back(
        {fields[0], fields[1], fields[2] + (fields[3].empty() ? "" : " (" + fields[3] + ")")});
  }
  return columns;
}

std::string studyTables()
{
  std::string text, table;
  for (const study::ColumnMeaning& each : study::studyColumnMeanings()) {
    if (each.table != table) {
      table = each.table;
      text += "\nTable `" + table + "`:\n\n" + header({"column", "unit", "meaning"});
    }
    text += row({code(each.column), each.unit, cell(each.meaning)});
  }
  return text + "\n";
}

/// The insertions table of a study without settings, in the words of its SQL table.
FieldMeanings insertionColumns()
{
  FieldMeanings columns;
  for (const study::ColumnMeaning& each : study::studyColumnMeanings())
    if (std::string(each.table) == "insertion" && std::string(each.column) != "settings")
      columns.push_back({each.column, each.unit, each.meaning});
  columns.push_back({"<key>", "in the name", "A column for each setting that the study varies."});
  return columns;
}

/// The name of the definition that a node stands for; empty if it is its own.
std::string definitionOf(const ordered_json& node)
{
  if (!node.contains("$ref")) return {};
  const std::string place = node["$ref"];
  return place.substr(place.rfind('/') + 1);
}

std::string typeOf(const ordered_json& schema)
{
  if (const std::string name = definitionOf(schema); !name.empty()) return "*" + name + "*";
  std::string text;
  const auto add = [&text](const std::string& type) {
    text += (text.empty() ? "" : " or ") + type;
  };
  if (schema.contains("anyOf")) {
    for (const ordered_json& each : schema["anyOf"]) add(typeOf(each));
    return text;
  }
  if (!schema.contains("type")) return "any";
  const ordered_json& type = schema["type"];
  if (type.is_array())
    for (const ordered_json& each : type) add(each.get<std::string>());
  else
    add(type.get<std::string>());
  if (type == "array" && schema.contains("items")) text += " of " + typeOf(schema["items"]);
  if (!schema.contains("enum")) return text;
  std::string values;
  for (const ordered_json& each : schema["enum"])
    values += (values.empty() ? "" : ", ") + each.dump();
  return text + ": " + values;
}

/// Rows for the keys of an object and of the objects in it; a definition has a table of its own.
void addKeys(std::string& text, const ordered_json& schema, const std::string& path)
{
  if (schema.contains("anyOf"))
    for (const ordered_json& each : schema["anyOf"]) addKeys(text, each, path);
  const std::string before = path.empty() ? "" : path + ".";
  if (schema.contains("properties"))
    for (const auto& [key, inner] : schema["properties"].items()) {
      const ordered_json required = schema.value("required", ordered_json::array());
      const bool isRequired = std::find(required.begin(), required.end(), key) != required.end();
      text += row({code(before + key), cell(typeOf(inner)), isRequired ? "yes" : "",
                   cell(inner.value("description", ""))});
      addKeys(text, inner, before + key);
    }
  if (schema.contains("items")) addKeys(text, schema["items"], path + "[]");
  if (schema.contains("additionalProperties") && schema["additionalProperties"].is_object())
    addKeys(text, schema["additionalProperties"], before + "<name>");
}

std::string keysOf(const ordered_json& schema)
{
  std::string text = header({"key", "type", "always", "meaning"});
  addKeys(text, schema, "");
  return text + "\n";
}

std::string schemaKeys(const std::string& name)
{
  const auto text = readWhole(projectFolder() / "resources/schemas" / (name + ".schema.json"));
  if (!text) return text.error().message;
  const ordered_json schema = ordered_json::parse(*text);
  std::string page = "### " + schema["title"].get<std::string>() + "\n\n[Schema](../schemas/" +
                     name + ".schema.json). Type: " + typeOf(schema) + ".\n\n" + keysOf(schema);
  if (schema.contains("$defs"))
    for (const auto& [definition, inner] : schema["$defs"].items())
      page += "*" + definition + "*: " + inner.value("description", "an object.") + "\n\n" +
              keysOf(inner);
  return page;
}

}  // namespace

std::string referencePage()
{
  std::string page =
      "# Reference: keys, columns, JSON\n\n"
      "Everything that files of Perilymph can hold. `resources/guide/make-reference` writes this "
      "page from the program, and a test\ncompares the two. What the values are worth: "
      "[the method](method.md). Keys with an old name are read with a warning until\nversion "
      "1.0.\n\n"
      "- [Keys of a scenario](#keys-of-a-scenario)\n- [Keys of a patient](#keys-of-a-patient)\n"
      "- [Keys of an array](#keys-of-an-array)\n- [Columns of tables](#columns-of-tables)\n"
      "- [Tables in SQL](#tables-in-sql)\n- [JSON](#json)\n\n"
      "## Keys of a scenario\n\n"
      "A TOML file, or `--set key=value` on the command line. The default is that of an empty "
      "file; without one the key has no\neffect where it is absent.\n\n" +
      keys(scenarioFile(), true) +
      "\n## Keys of a patient\n\n"
      "A TOML file with A and B of the basal turn, or with three lengths of the scala "
      "tympani.\n\n" +
      keys(patientFile(), false) +
      "\n## Keys of an array\n\n"
      "A TOML file ([your own array](plugins.md#an-array)). Every table also has "
      "`source` "
      "and `confidence` (high, medium or\nlow). *Required* is within its table. Limits that depend "
      "on another key are those of an array of 30 mm.\n\n" +
      keys(arrayFile(), false) + "\n## Columns of tables\n\n";
  page += columns("Time series: `simulate --csv`, `replay --csv`", session::tickColumns());
  page += columns("Cross-sections: `anatomy --sections`", analysis::sectionMeanings());
  page += columns("*comparison.csv* of `compare`", analysis::comparisonColumns());
  page += columns("*curves.csv* of `compare`", analysis::curveColumns());
  page += columns("*events.csv* of `compare`", analysis::eventColumns());
  page += columns("*groups.csv* of `compare`", analysis::groupColumns());
  page += columns("*differences.csv* of `compare`", analysis::differenceColumns());
  page += columns("*arrays.csv* of `plan`", planning::planArrayColumns());
  page += columns("*differences.csv* of `plan`", planning::planDifferenceColumns());
  page += columns("*contacts.csv* of `plan`, `replay --contacts`", contactColumns());
  page += columns("*shapes.csv* of `plan`", planning::shapeColumns());
  page += columns("*outcomes.csv* of `outcomes`", outcome::outcomesColumns());
  page += columns("*insertions.csv* of `study`, *points.csv* of its groups", insertionColumns());
  page += columns("*groups.csv* of `study`", study::summaryGroupColumns());
  page += columns("*differences.csv* of `study`", study::summaryDifferenceColumns());
  page += columns("*trends.csv* of `study`", study::summaryTrendColumns());
  page += columns("*profile.csv* and *difference.csv* of `validate` and `calibrate`",
                  validation::forceColumns());
  page += columns("*prior-predictive.csv* of `validate`", validation::priorSummaryColumns());
  page += columns("*prior-predictive-draws.csv* of `validate`", validation::priorColumns());
  page += columns("*friction.csv* of `validate`", validation::benchFrictionColumns());
  page += columns("*predicted.csv* of `validate`", validation::benchPredictedColumns());
  page += columns("*scores.csv* of `validate`", validation::benchScoreColumns());
  page += columns("*prediction.csv* of `predict`", validation::predictionColumns());
  page += columns("*clinical-table.csv* of `predict`", validation::clinicalRowColumns());
  page += columns("*clinical-insertions.csv* of `predict`", validation::clinicalInsertionColumns());
  page +=
      "## Tables in SQL\n\n"
      "A recording (*.insertion*) has the tables `block`, `event` and `meta`. A row of `block` is "
      "up "
      "to " +
      std::to_string(session::blockTicks) +
      " time steps, packed: `tick` is the number of the first,\n`ticks` how many. The time series "
      "as "
      "the table `tick`, a row per time step with the columns of the CSV:\n\n"
      "    perilymph-cli simulate --scenario contour-published --record session.insertion\n"
      "    perilymph-cli replay session.insertion --sqlite series.sqlite\n"
      "    sqlite3 series.sqlite 'SELECT max(force_axial_N) FROM tick WHERE depth_mm > 10'\n\n"
      "Recordings of 0.2 and before have the table `tick` with the first " +
      std::to_string(session::recordedColumnCount) +
      " columns of the time series, a row per time step.\n\n"
      "The result of a study, *study.sqlite*, has these tables, and [views](studies.md) of them:\n";
  page += studyTables();
  page +=
      "## JSON\n\n`[]` follows the name of a list, *always* marks keys that are never absent, and "
      "a type in italics "
      "has a table of its own.\n\n";
  for (const char* name :
       {"simulate", "anatomy", "anatomy-import", "plan", "outcomes", "clinic-resistance",
        "ct-measure", "ct-contacts", "ct-markups", "ct-info", "prediction", "clinical-table",
        "validation", "prior-predictive", "devices", "archive"})
    page += schemaKeys(name);
  page.pop_back();
  return page;
}

}  // namespace perilymph::test
