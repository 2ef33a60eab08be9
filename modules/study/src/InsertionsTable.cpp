// SPDX-License-Identifier: BSD-3-Clause
#include "InsertionsTable.h"

#include <algorithm>

#include "perilymph/foundation/CsvField.h"
#include "perilymph/session/Csv.h"

namespace perilymph::study {

namespace {

std::string number(double value) { return session::shortestDecimal(value); }

}  // namespace

std::string insertionsHeader(const std::set<std::string>& settings)
{
  std::string header = "number,cochlea,A_mm,B_mm,st_length_mm";
  for (const std::string& key : settings) header += "," + csvField(key);
  return header +
         ",ending,depth_mm,max_depth_mm,angle_deg,coverage_percent,peak_mN,peak_depth_mm,end_mN,"
         "partition_mN,ticks,ticks_not_converged,reason\n";
}

std::string insertionsRow(const StudyResult& result, const std::set<std::string>& settings)
{
  const analysis::InsertionRun& found = result.insertion;
  std::string row = std::to_string(result.number) + "," + csvField(result.cochlea) + "," +
                    number(result.a_mm) + "," + number(result.b_mm) + "," +
                    number(result.scalaLength_mm);
  for (const std::string& key : settings) {
    const auto is = [&key](const auto& each) { return each.first == key; };
    const auto value = std::find_if(result.settings.begin(), result.settings.end(), is);
    row += "," + (value == result.settings.end() ? std::string() : csvField(value->second));
  }
  row += std::string(",") + haptics::nameOf(found.end);
  for (const double value :
       {inMillimeters(found.depth), inMillimeters(found.maxDepth), inDegrees(found.apical),
        100.0 * found.coverage, inMillinewtons(found.peak.force), inMillimeters(found.peak.depth),
        inMillinewtons(found.endForce), inMillinewtons(found.partition)})
    row += "," + number(value);
  return row + "," + std::to_string(found.ticks) + "," + std::to_string(found.ticksNotConverged) +
         "," + csvField(found.reason) + "\n";
}

}  // namespace perilymph::study
