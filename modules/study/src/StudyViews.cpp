// SPDX-License-Identifier: BSD-3-Clause
#include "StudyViews.h"

#include <cstdint>
#include <span>
#include <string_view>
#include <utility>

#include "perilymph/haptics/InsertionEnd.h"
#include "perilymph/study/StudySummary.h"

namespace perilymph::study {

namespace {

constexpr ColumnMeaning columnMeanings[] = {
    {"insertion", "number", "",
     "Number of the insertion, from 0; the study, its seed and this number give it again"},
    {"insertion", "cochlea", "", "'mean', 'virtual 17' or the file of the patient"},
    {"insertion", "settings", "",
     "JSON object of the values that replace those of the scenario, each as text"},
    {"insertion", "ending", "",
     "How it ended: 'finished', 'stopped_by_resistance', 'buckled', 'out_of_opening', "
     "'folded_tip', 'jammed', 'fault', 'refused', or 'none': not ended within twice its time"},
    {"insertion", "reason", "", "Why it is 'fault' or 'refused'; else empty"},
    {"insertion", "A_mm", "mm",
     "Diameter A of the basal turn, as a patient states it or else of the cochlea as built; 0 if "
     "none was built"},
    {"insertion", "B_mm", "mm",
     "Diameter B of the basal turn, as a patient states it or else of the cochlea as built; 0 if "
     "none was built"},
    {"insertion", "st_length_mm", "mm", "Length of the scala tympani along the organ of Corti"},
    {"insertion", "depth_mm", "mm",
     "Insertion depth at the end: length of the array past the opening"},
    {"insertion", "max_depth_mm", "mm", "Largest insertion depth"},
    {"insertion", "angle_deg", "deg",
     "Angular insertion depth: angle of the most apical contact from the round window; 0 if none "
     "is inserted"},
    {"insertion", "coverage_percent", "%",
     "Part of the organ of Corti basal to the most apical contact"},
    {"insertion", "peak_mN", "mN", "Peak insertion force: largest axial force on the hand"},
    {"insertion", "peak_depth_mm", "mm", "Insertion depth at the peak insertion force"},
    {"insertion", "end_mN", "mN",
     "Axial force where the hand stops: end of the line through the last half second of motion"},
    {"insertion", "partition_mN", "mN",
     "Largest force on the cochlear partition within one contact"},
    {"insertion", "ticks", "", "Time steps"},
    {"insertion", "ticks_not_converged", "", "Time steps without equilibrium within the tolerance"},
    {"profile", "number", "", "Number of the insertion"},
    {"profile", "depth_mm", "mm", "Insertion depth"},
    {"profile", "force_mN", "mN", "Axial force where the tip first passed that depth"},
    {"contact", "number", "", "Number of the insertion"},
    {"contact", "contact", "", "Number of the electrode contact, 1 at the tip"},
    {"contact", "is_inserted", "", "1 if it is past the opening, else 0"},
    {"contact", "angle_deg", "deg", "Angle from the round window; 0 of one outside"},
    {"contact", "depth_mm", "mm", "Length along the array past the opening; negative outside"},
    {"contact", "to_modiolus_mm", "mm",
     "Distance from the center line of the array to the inner wall; negative where no wall is in "
     "that direction"},
    {"contact", "frequency_Hz", "Hz", "Frequency by Greenwood of its place"},
    {"meta", "key", "",
     "'title', 'study' (its file), 'fingerprint', 'program', 'cases', 'first', 'end', 'notes', "
     "'files' (what files say that settings name, as JSON; see file_value), 'content_sha256' (the "
     "seal)"},
    {"meta", "value", "", "Text of the fact"},
    // the views
    {"file_value", "key", "", "Key of the scenario that names a file: 'friction'"},
    {"file_value", "value", "", "Its value: a shipped name, or a path beside the study"},
    {"file_value", "name", "", "'array_name', 'friction_static' or 'friction_dynamic'"},
    {"file_value", "content", "", "What the file says; a number where it is one"},
    {"setting", "number", "", "Number of the insertion"},
    {"setting", "key", "",
     "Key of the scenario: 'array'; of the file that it names also 'array_name', "
     "'friction_static', "
     "'friction_dynamic'"},
    {"setting", "value", "", "Its value in this insertion; a number where it is one"},
    {"ending_by_setting", "key", "", "Key of the scenario with 12 values or fewer"},
    {"ending_by_setting", "value", "", "Its value"},
    {"ending_by_setting", "insertions", "", "Insertions with it"},
    {"ending_by_setting", "none", "", "Of them not ended within twice their time"},
    {"ending_by_setting", "finished", "", "Of them complete: to their stop travel"},
    {"ending_by_setting", "stopped_by_resistance", "", "Of them stopped by the force limit"},
    {"ending_by_setting", "buckled", "", "Of them buckled in front of the opening"},
    {"ending_by_setting", "out_of_opening", "", "Of them slipped out of the opening"},
    {"ending_by_setting", "folded_tip", "", "Of them with a tip that folded over"},
    {"ending_by_setting", "jammed", "", "Of them jammed"},
    {"ending_by_setting", "fault", "", "Of them ended by a fault of the calculation"},
    {"ending_by_setting", "refused", "", "Of them not prepared: they did not run"},
    {"ending_by_setting", "finished_percent", "%", "Complete ones of all of them"},
    {"distribution_by_setting", "selection", "",
     "'all that ran', or 'complete': those to their stop travel"},
    {"distribution_by_setting", "key", "", "Key of the scenario with 12 values or fewer"},
    {"distribution_by_setting", "value", "", "Its value"},
    {"distribution_by_setting", "quantity", "", "Column of the insertions, with its unit"},
    {"distribution_by_setting", "n", "", "Insertions of the selection with the value"},
    {"distribution_by_setting", "mean", "", "Mean, in the unit of the quantity"},
    {"distribution_by_setting", "median", "", "Median, in the unit of the quantity"},
    {"distribution_by_setting", "quartile25", "", "Lower quartile, in the unit of the quantity"},
    {"distribution_by_setting", "quartile75", "", "Upper quartile, in the unit of the quantity"},
    {"outcome_by_setting", "key", "", "Key of the scenario with 12 values or fewer"},
    {"outcome_by_setting", "value", "", "Its value"},
    {"outcome_by_setting", "finished", "", "Complete insertions with it"},
    {"outcome_by_setting", "mean_angle_deg", "deg", "Mean angular insertion depth, complete"},
    {"outcome_by_setting", "min_angle_deg", "deg", "Smallest angular insertion depth, complete"},
    {"outcome_by_setting", "max_angle_deg", "deg", "Largest angular insertion depth, complete"},
    {"outcome_by_setting", "mean_coverage_percent", "%", "Mean cochlear coverage, complete"},
    {"outcome_by_setting", "mean_peak_mN", "mN", "Mean peak insertion force, complete"},
    {"outcome_by_setting", "max_peak_mN", "mN", "Largest peak insertion force, complete"},
    {"outcome_by_setting", "mean_partition_mN", "mN", "Mean partition force, complete"},
    {"outcome_by_setting", "max_partition_mN", "mN", "Largest partition force, complete"},
    {"outcome_by_setting", "insertions", "", "All insertions with the value"},
    {"outcome_by_setting", "stopped", "", "Of them stopped before their stop travel"},
    {"outcome_by_setting", "mean_stopped_angle_deg", "deg",
     "Mean angular insertion depth of the stopped ones"},
    {"outcome_by_setting", "mean_stopped_peak_mN", "mN",
     "Mean peak insertion force of the stopped ones"},
    {"outcome_by_size", "A_from_mm", "mm", "Lower bound of A; the class is 0.5 mm wide"},
    {"outcome_by_size", "insertions", "", "Insertions in such cochleae"},
    {"outcome_by_size", "finished", "", "Of them complete"},
    {"outcome_by_size", "mean_angle_deg", "deg", "Mean angular insertion depth, complete"},
    {"outcome_by_size", "mean_coverage_percent", "%", "Mean cochlear coverage, complete"},
    {"outcome_by_size", "mean_peak_mN", "mN", "Mean peak insertion force, complete"},
    {"outcome_by_size", "stopped", "", "Of them stopped before their stop travel"},
    {"outcome_by_size", "mean_stopped_angle_deg", "deg",
     "Mean angular insertion depth of the stopped ones"},
    {"outcome_by_size", "mean_stopped_peak_mN", "mN",
     "Mean peak insertion force of the stopped ones"},
    {"extreme", "number", "", "Number of the insertion"},
    {"extreme", "ending", "", "How it ended"},
    {"extreme", "peak_mN", "mN", "Its peak insertion force"},
    {"extreme", "partition_mN", "mN", "Its largest force on the cochlear partition"},
    {"extreme", "angle_deg", "deg", "Its angular insertion depth"},
    {"extreme", "has_max_peak", "", "1 if no peak insertion force is larger, else 0"},
    {"extreme", "has_max_partition", "", "1 if no partition force is larger, else 0"},
    {"extreme", "has_max_angle", "", "1 if none is deeper, else 0"},
    {"extreme", "has_min_finished_angle", "", "1 if no complete one is less deep, else 0"},
    {"dictionary", "table_name", "", "Table or view"},
    {"dictionary", "column_name", "", "Its column"},
    {"dictionary", "unit", "", "Unit of the column; empty without one"},
    {"dictionary", "meaning", "", "What it is"},
};
/// How many of them are of the tables, which alone the first version of the dictionary had.
constexpr std::size_t tableColumns = 30;
static_assert(std::string_view(columnMeanings[tableColumns - 1].table) == "meta" &&
              std::string_view(columnMeanings[tableColumns].table) == "file_value");

/// The view `dictionary`: one row per column.
std::string dictionaryView(std::span<const ColumnMeaning> meanings)
{
  const auto quoted = [](const std::string& text) {
    std::string result = "'";
    for (const char each : text) result += each == '\'' ? std::string("''") : std::string(1, each);
    return result + "'";
  };
  std::string rows;
  for (const ColumnMeaning& each : meanings)
    rows += (rows.empty() ? "(" : ", (") + quoted(each.table) + ", " + quoted(each.column) + ", " +
            quoted(each.unit) + ", " + quoted(each.meaning) + ")";
  return "CREATE VIEW dictionary(table_name, column_name, unit, meaning) AS VALUES " + rows;
}

/// A text with one part replaced, which it has.
std::string with(std::string text, const std::string& part, const std::string& other)
{
  return text.replace(text.find(part), part.size(), other);
}

/// A dictionary with the meanings that A, B and the angle of a contact had in earlier versions.
std::string withFormerMeanings(std::string view)
{
  for (const char* name : {"A", "B"})
    view = with(std::move(view),
                std::string("Diameter ") + name +
                    " of the basal turn, as a patient states it or else of the cochlea as built; 0 "
                    "if none was built",
                std::string("Diameter ") + name +
                    " of the basal turn of the cochlea as built; 0 if it was not");
  return with(std::move(view), "Angle from the round window; 0 of one outside",
              "Angle from the round window");
}

/// The dictionaries of earlier versions: with other meanings, before that without what files say, and before
/// that without views and the ending 'none'.
std::vector<std::string> formerDictionaryViews()
{
  const auto ofVersion4 = [](std::span<const ColumnMeaning> meanings) {
    std::vector<ColumnMeaning> rows;
    for (const ColumnMeaning& each : meanings)
      if (std::string_view(each.table) != "file_value") rows.push_back(each);
    return with(withFormerMeanings(dictionaryView(rows)),
                "''files'' (what files say that settings name, as JSON; see file_value), ", "");
  };
  return {withFormerMeanings(dictionaryView(columnMeanings)),
          with(ofVersion4(columnMeanings),
               "; of the file that it names also ''array_name'', ''friction_static'', "
               "''friction_dynamic''",
               ""),
          with(ofVersion4(std::span(columnMeanings).first(tableColumns)),
               "''fault'', ''refused'', or ''none'': not ended within twice its time",
               "''fault'' or ''refused''")};
}

/// A text as a number where it is one.
std::string asNumber(const std::string& text)
{
  return "CASE WHEN json_valid(" + text + ") THEN CASE WHEN json_type(" + text +
         ") IN ('integer', 'real') THEN json_extract(" + text + ", '$') ELSE " + text +
         " END ELSE " + text + " END";
}

/// The view `setting` as version 4 had it: of the settings alone.
std::string settingView()
{
  return "CREATE VIEW setting AS SELECT insertion.number AS number, json_each.key AS key, " +
         asNumber("json_each.value") + " AS value FROM insertion, json_each(insertion.settings)";
}

/// No view has a row for each value of a range that was drawn.
constexpr const char* ofFewValues =
    "key IN (SELECT key FROM setting GROUP BY key HAVING count(DISTINCT value) <= 12)";

/// "sum(ending = 'finished') AS finished, ": a column for each haptics::InsertionEnd, none to refused.
std::string endingCounts()
{
  std::string columns;
  for (auto end = std::uint32_t{0}; end <= std::uint32_t(haptics::InsertionEnd::refused); ++end) {
    const std::string name = haptics::nameOf(static_cast<haptics::InsertionEnd>(end));
    columns += "sum(ending = '" + name + "') AS " + name + ", ";
  }
  return columns;
}

/// A row for each selection, setting, value and quantity of the summary. The quantile p of n sorted values
/// x_i is the sum of x_i max(0, 1 - |i - p (n - 1)|), linear between two of them as in the summary.
std::string distributionView()
{
  std::string keys, values;
  for (const SummarizedQuantity& each : summarizedQuantities) {
    keys += std::string(keys.empty() ? "\"" : ", \"") + each.key + "\"";
    values += std::string(" WHEN '") + each.key + "' THEN " + each.key;
  }
  const std::string ran = nameOf(StudySelection::ran), complete = nameOf(StudySelection::complete);
  const auto quantileAt = [](const char* fraction, const char* name) {
    return std::string("sum(x * max(0.0, 1.0 - abs(i - ") + fraction + " * (n - 1)))) AS " + name;
  };
  return "CREATE VIEW distribution_by_setting AS WITH chosen AS (SELECT s.value AS selection, "
         "setting.key AS key, setting.value AS value, q.value AS quantity, CASE q.value" +
         values + " END AS x FROM insertion JOIN setting USING (number), json_each('[" + keys +
         "]') AS q, json_each('[\"" + ran + "\", \"" + complete + "\"]') AS s WHERE setting." +
         ofFewValues + " AND (ending = 'finished' OR (s.value = '" + ran +
         "' AND ending <> 'refused'))), ranked AS (SELECT *, "
         "row_number() OVER (PARTITION BY selection, key, value, quantity ORDER BY x) - 1 AS i, "
         "count(*) OVER (PARTITION BY selection, key, value, quantity) AS n FROM chosen) "
         "SELECT selection, key, value, quantity, n, avg(x) AS mean, " +
         quantileAt("0.5", "median") + ", " + quantileAt("0.25", "quartile25") + ", " +
         quantileAt("0.75", "quartile75") +
         " FROM ranked GROUP BY selection, key, value, quantity, n";
}

/// Columns of the insertions that stopped before their stop travel.
std::string ofStopped()
{
  const std::string stopped = "ending NOT IN ('finished', 'fault', 'refused', 'none')";
  return "sum(" + stopped + ") AS stopped, avg(CASE WHEN " + stopped +
         " THEN angle_deg END) AS mean_stopped_angle_deg, avg(CASE WHEN " + stopped +
         " THEN peak_mN END) AS mean_stopped_peak_mN";
}

}  // namespace

std::span<const ColumnMeaning> studyColumnMeanings() { return columnMeanings; }

std::vector<std::string> studyViews()
{
  return {
      // What do the files say that settings name?
      std::string(
          "CREATE VIEW file_value AS WITH file AS MATERIALIZED (SELECT json_extract(row.value, "
          "'$[0]') "
          "AS key, json_extract(row.value, '$[1]') AS value, json_extract(row.value, '$[2]') AS "
          "name, "
          "json_extract(row.value, '$[3]') AS content FROM meta, json_each(meta.value) AS row "
          "WHERE meta.key = 'files') SELECT key, value, name, ") +
          "CASE name WHEN 'array_name' THEN content ELSE " + asNumber("content") +
          " END AS content FROM file",
      // Which values does each insertion have? One row per insertion and key; numbers are numbers.
      settingView() +
          " UNION ALL SELECT insertion.number, file.name, file.content FROM insertion, "
          "json_each(insertion.settings) AS named JOIN (SELECT * FROM file_value) AS file ON "
          "file.key = named.key AND file.value = named.value",
      // How do insertions end, by value of each setting that has few?
      "CREATE VIEW ending_by_setting AS SELECT key, value, count(*) AS insertions, " +
          endingCounts() +
          "100.0 * sum(ending = 'finished') / count(*) AS finished_percent "
          "FROM setting JOIN insertion USING (number) WHERE " +
          ofFewValues + " GROUP BY key, value",
      // Which angles, depths and forces do insertions reach, by value of each setting that has few?
      distributionView(),
      // How deep do insertions go, and with which forces, by value of each setting that has few?
      // Means without another word are of finished ones; a stopped one ended before its stop travel.
      "CREATE VIEW outcome_by_setting AS SELECT key, value, sum(ending = 'finished') AS finished, "
      "avg(CASE WHEN ending = 'finished' THEN angle_deg END) AS mean_angle_deg, "
      "min(CASE WHEN ending = 'finished' THEN angle_deg END) AS min_angle_deg, "
      "max(CASE WHEN ending = 'finished' THEN angle_deg END) AS max_angle_deg, "
      "avg(CASE WHEN ending = 'finished' THEN coverage_percent END) AS mean_coverage_percent, "
      "avg(CASE WHEN ending = 'finished' THEN peak_mN END) AS mean_peak_mN, "
      "max(CASE WHEN ending = 'finished' THEN peak_mN END) AS max_peak_mN, "
      "avg(CASE WHEN ending = 'finished' THEN partition_mN END) AS mean_partition_mN, "
      "max(CASE WHEN ending = 'finished' THEN partition_mN END) AS max_partition_mN, "
      "count(*) AS insertions, " +
          ofStopped() + " FROM setting JOIN insertion USING (number) WHERE " + ofFewValues +
          " GROUP BY key, value",
      // How do depth and force depend on the size of the cochlea? Classes of 0.5 mm of A.
      "CREATE VIEW outcome_by_size AS SELECT 0.5 * CAST(A_mm / 0.5 AS INTEGER) AS A_from_mm, "
      "count(*) AS insertions, sum(ending = 'finished') AS finished, "
      "avg(CASE WHEN ending = 'finished' THEN angle_deg END) AS mean_angle_deg, "
      "avg(CASE WHEN ending = 'finished' THEN coverage_percent END) AS mean_coverage_percent, "
      "avg(CASE WHEN ending = 'finished' THEN peak_mN END) AS mean_peak_mN, " +
          ofStopped() + " FROM insertion GROUP BY A_from_mm",
      // Which insertions are the extreme ones?
      "CREATE VIEW extreme AS SELECT number, ending, peak_mN, partition_mN, angle_deg, "
      "peak_mN = (SELECT max(peak_mN) FROM insertion) AS has_max_peak, "
      "partition_mN = (SELECT max(partition_mN) FROM insertion) AS has_max_partition, "
      "angle_deg = (SELECT max(angle_deg) FROM insertion) AS has_max_angle, "
      "ending = 'finished' AND angle_deg = (SELECT min(angle_deg) FROM insertion "
      "WHERE ending = 'finished') AS has_min_finished_angle FROM insertion "
      "WHERE has_max_peak OR has_max_partition OR has_max_angle OR has_min_finished_angle",
      // What is in each column of tables and views, and in which unit?
      dictionaryView(columnMeanings),
  };
}

std::vector<std::string> formerStudyViews()
{
  std::vector<std::string> views = formerDictionaryViews();
  views.push_back(settingView());
  views.insert(
      views.end(),
      {
          // every value was text, and outcomes were of finished insertions alone
          "CREATE VIEW setting AS SELECT insertion.number AS number, json_each.key AS key, "
          "json_each.value AS value FROM insertion, json_each(insertion.settings)",
          "CREATE VIEW ending_by_setting AS SELECT key, value, count(*) AS insertions, "
          "sum(ending = 'finished') AS finished, sum(ending = 'out_of_opening') AS out_of_opening, "
          "sum(ending = 'buckled') AS buckled, sum(ending = 'fault') AS fault, "
          "sum(ending = 'refused') AS refused, "
          "100.0 * sum(ending = 'finished') / count(*) AS finished_percent "
          "FROM setting JOIN insertion USING (number) GROUP BY key, value",
          "CREATE VIEW outcome_by_setting AS SELECT key, value, count(*) AS finished, "
          "avg(angle_deg) AS mean_angle_deg, min(angle_deg) AS min_angle_deg, "
          "max(angle_deg) AS max_angle_deg, avg(coverage_percent) AS mean_coverage_percent, "
          "avg(peak_mN) AS mean_peak_mN, max(peak_mN) AS max_peak_mN, "
          "avg(partition_mN) AS mean_partition_mN, max(partition_mN) AS max_partition_mN "
          "FROM setting JOIN insertion USING (number) WHERE ending = 'finished' GROUP BY key, "
          "value",
          "CREATE VIEW outcome_by_size AS SELECT 0.5 * CAST(A_mm / 0.5 AS INTEGER) AS A_from_mm, "
          "count(*) AS insertions, sum(ending = 'finished') AS finished, "
          "avg(CASE WHEN ending = 'finished' THEN angle_deg END) AS mean_angle_deg, "
          "avg(CASE WHEN ending = 'finished' THEN coverage_percent END) AS mean_coverage_percent, "
          "avg(CASE WHEN ending = 'finished' THEN peak_mN END) AS mean_peak_mN "
          "FROM insertion GROUP BY A_from_mm",
      });
  return views;
}

}  // namespace perilymph::study
