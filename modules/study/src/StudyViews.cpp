// SPDX-License-Identifier: BSD-3-Clause
#include "StudyViews.h"

#include <cstdint>
#include <utility>

#include "perilymph/haptics/InsertionEnd.h"
#include "perilymph/study/StudySummary.h"

namespace perilymph::study {

namespace {

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
         "]') AS q, json_each('[\"" + ran + "\", \"" + complete +
         "\"]') AS s WHERE ending = 'finished' OR (s.value = '" + ran +
         "' AND ending <> 'refused')), ranked AS (SELECT *, "
         "row_number() OVER (PARTITION BY selection, key, value, quantity ORDER BY x) - 1 AS i, "
         "count(*) OVER (PARTITION BY selection, key, value, quantity) AS n FROM chosen) "
         "SELECT selection, key, value, quantity, n, avg(x) AS mean, " +
         quantileAt("0.5", "median") + ", " + quantileAt("0.25", "quartile25") + ", " +
         quantileAt("0.75", "quartile75") +
         " FROM ranked GROUP BY selection, key, value, quantity, n";
}

}  // namespace

std::vector<std::string> formerStudyViews()
{
  return {
      "CREATE VIEW ending_by_setting AS SELECT key, value, count(*) AS insertions, "
      "sum(ending = 'finished') AS finished, sum(ending = 'out_of_opening') AS out_of_opening, "
      "sum(ending = 'buckled') AS buckled, sum(ending = 'fault') AS fault, "
      "sum(ending = 'refused') AS refused, "
      "100.0 * sum(ending = 'finished') / count(*) AS finished_percent "
      "FROM setting JOIN insertion USING (number) GROUP BY key, value"};
}

std::vector<std::string> studyViews()
{
  return {
      // Which values does each insertion have? One row per insertion and key.
      "CREATE VIEW setting AS SELECT insertion.number AS number, json_each.key AS key, "
      "json_each.value AS value FROM insertion, json_each(insertion.settings)",
      // How do insertions end, by value of each setting?
      "CREATE VIEW ending_by_setting AS SELECT key, value, count(*) AS insertions, " +
          endingCounts() +
          "100.0 * sum(ending = 'finished') / count(*) AS finished_percent "
          "FROM setting JOIN insertion USING (number) GROUP BY key, value",
      // Which angles, depths and forces do insertions reach, by value of each setting?
      distributionView(),
      // How deep do finished insertions go, and with which forces, by value of each setting?
      "CREATE VIEW outcome_by_setting AS SELECT key, value, count(*) AS finished, "
      "avg(angle_deg) AS mean_angle_deg, min(angle_deg) AS min_angle_deg, "
      "max(angle_deg) AS max_angle_deg, avg(coverage_percent) AS mean_coverage_percent, "
      "avg(peak_mN) AS mean_peak_mN, max(peak_mN) AS max_peak_mN, "
      "avg(partition_mN) AS mean_partition_mN, max(partition_mN) AS max_partition_mN "
      "FROM setting JOIN insertion USING (number) WHERE ending = 'finished' GROUP BY key, value",
      // How do depth and force depend on the size of the cochlea? Classes of 0.5 mm of A.
      "CREATE VIEW outcome_by_size AS SELECT 0.5 * CAST(A_mm / 0.5 AS INTEGER) AS A_from_mm, "
      "count(*) AS insertions, sum(ending = 'finished') AS finished, "
      "avg(CASE WHEN ending = 'finished' THEN angle_deg END) AS mean_angle_deg, "
      "avg(CASE WHEN ending = 'finished' THEN coverage_percent END) AS mean_coverage_percent, "
      "avg(CASE WHEN ending = 'finished' THEN peak_mN END) AS mean_peak_mN "
      "FROM insertion GROUP BY A_from_mm",
      // Which insertions are the extreme ones?
      "CREATE VIEW extreme AS SELECT number, ending, peak_mN, partition_mN, angle_deg, "
      "peak_mN = (SELECT max(peak_mN) FROM insertion) AS has_max_peak, "
      "partition_mN = (SELECT max(partition_mN) FROM insertion) AS has_max_partition, "
      "angle_deg = (SELECT max(angle_deg) FROM insertion) AS has_max_angle, "
      "ending = 'finished' AND angle_deg = (SELECT min(angle_deg) FROM insertion "
      "WHERE ending = 'finished') AS has_min_finished_angle FROM insertion "
      "WHERE has_max_peak OR has_max_partition OR has_max_angle OR has_min_finished_angle",
  };
}

}  // namespace perilymph::study
