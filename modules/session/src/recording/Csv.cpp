// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/session/Csv.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "perilymph/foundation/Units.h"

namespace perilymph::session {

const std::array<const char*, columnCount> columnNames = {
    "time_s",           "travel_mm",         "depth_mm",       "speed_mm_s",  "tip_angle_deg",
    "force_axial_N",    "force_x_N",         "force_y_N",      "force_z_N",   "tip_x_mm",
    "tip_y_mm",         "tip_z_mm",          "device_x_mm",    "device_y_mm", "device_z_mm",
    "proxy_x_mm",       "proxy_y_mm",        "proxy_z_mm",     "contacts",    "wall_force_max_N",
    "membrane_force_N", "partition_force_N", "plastic_work_uJ"};

const std::array<const char*, recordedColumnCount> recordedNames = [] {
  std::array<const char*, recordedColumnCount> names{};
  std::copy_n(columnNames.begin(), names.size(), names.begin());
  names[4] = "angular_depth_deg";
  return names;
}();

const FieldMeanings& tickColumns()
{
  static const FieldMeanings columns = {
      {columnNames[0], "s", "Time since the first motion, pauses included."},
      {columnNames[1], "mm", "Travel: insertion depth less that at the start."},
      {columnNames[2], "mm", "Insertion depth: length of the array past the opening."},
      {columnNames[3], "mm/s", "Speed of the base along the axis of the opening."},
      {columnNames[4], "deg", "Tip angle: angle of the tip from the round window; 0 before it."},
      {columnNames[5], "N", "Insertion force: axial force on the hand, positive while pushing in."},
      {columnNames[6], "N", "Force of the array on the hand, x in the world frame."},
      {columnNames[7], "N", "The same, y."},
      {columnNames[8], "N", "The same, z."},
      {columnNames[9], "mm", "Position of the tip, x in the world frame."},
      {columnNames[10], "mm", "The same, y."},
      {columnNames[11], "mm", "The same, z."},
      {columnNames[12], "mm", "Position of the base that the hand commands, x in the world frame."},
      {columnNames[13], "mm", "The same, y."},
      {columnNames[14], "mm", "The same, z."},
      {columnNames[15], "mm", "Position of the base, x in the world frame."},
      {columnNames[16], "mm", "The same, y."},
      {columnNames[17], "mm", "The same, z."},
      {columnNames[18], "", "Number of nodes that touch the wall."},
      {columnNames[19], "N", "Largest normal force of the wall on one node."},
      {columnNames[20], "N", "Sum of the normal forces on the basilar membrane."},
      {columnNames[21], "N",
       "Largest force on the cochlear partition within one contact; empty in older recordings."},
      {columnNames[22], "uJ",
       "Work that wires and stylet took by yielding, since the start; 0 of elastic arrays."}};
  return columns;
}

std::array<double, columnCount> columnValues(const haptics::TickRecord& record)
{
  const haptics::TickOutput& now = record.output;
  const auto mm = [](double length) { return inMillimeters(meters(length)); };
  return {now.time, mm(now.travel), mm(now.depth),
          inMillimetersPerSecond(metersPerSecond(now.speed)), inDegrees(radians(now.angularDepth)),
          now.axialForce, now.force_W[0], now.force_W[1], now.force_W[2], mm(now.tip_W[0]),
          mm(now.tip_W[1]), mm(now.tip_W[2]), mm(now.device_W[0]), mm(now.device_W[1]),
          mm(now.device_W[2]), mm(now.proxy_W[0]), mm(now.proxy_W[1]), mm(now.proxy_W[2]),
          static_cast<double>(now.contacts), now.wallForceMax, now.membraneForce,
          now.partitionForce,
          // an elastic array states none, and dissipates nothing
          std::isnan(now.plasticWork) ? 0.0 : 1e6 * now.plasticWork};
}

std::string shortestDecimal(double value)
{
  char digits[32];
  return {digits, std::to_chars(digits, digits + sizeof digits, value).ptr};
}

std::string csvHeader()
{
  std::string header;
  for (const char* name : columnNames) header += (header.empty() ? "" : ",") + std::string(name);
  return header + '\n';
}

std::string csvRow(const haptics::TickRecord& record)
{
  std::string row;
  row.reserve(400);
  bool isFirst = true;
  for (const double value : columnValues(record)) {
    if (!isFirst) row += ',';
    isFirst = false;
    if (!std::isnan(value)) row += shortestDecimal(value);
  }
  return row + '\n';
}

bool CsvPeriod::keeps(double time)
{
  // Times are multiples of the step with rounding errors, which a millionth of the period exceeds.
  if (time < next_ - 1e-6 * period_) return false;
  while (period_ > 0.0 && next_ <= time + 1e-6 * period_)
    next_ = static_cast<double>(++count_) * period_;
  return true;
}

}  // namespace perilymph::session
