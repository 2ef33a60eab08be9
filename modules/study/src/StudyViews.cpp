// SPDX-License-Identifier: BSD-3-Clause
#include "StudyViews.h"

namespace perilymph::study {

std::vector<std::string> studyViews()
{
  return {
      // Which values does each insertion have? One row per insertion and key.
      "CREATE VIEW setting AS SELECT insertion.number AS number, json_each.key AS key, "
      "json_each.value AS value FROM insertion, json_each(insertion.settings)",
      // How do insertions end, by value of each setting?
      "CREATE VIEW ending_by_setting AS SELECT key, value, count(*) AS insertions, "
      "sum(ending = 'finished') AS finished, sum(ending = 'out_of_opening') AS out_of_opening, "
      "sum(ending = 'buckled') AS buckled, sum(ending = 'fault') AS fault, "
      "sum(ending = 'refused') AS refused, "
      "100.0 * sum(ending = 'finished') / count(*) AS finished_percent "
      "FROM setting JOIN insertion USING (number) GROUP BY key, value",
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
