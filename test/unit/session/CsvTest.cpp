// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/session/Csv.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <limits>
#include <sstream>
#include <vector>

namespace perilymph::session {
namespace {

std::vector<std::string> split(const std::string& row)
{
  std::vector<std::string> cells;
  std::istringstream stream(row);
  for (std::string cell; std::getline(stream, cell, ',');) cells.push_back(cell);
  return cells;
}

TEST(CsvHeader, IsTheContract)
{
  EXPECT_EQ(csvHeader(),
            "time_s,travel_mm,depth_mm,speed_mm_s,tip_angle_deg,force_axial_N,force_x_N,"
            "force_y_N,force_z_N,tip_x_mm,tip_y_mm,tip_z_mm,device_x_mm,device_y_mm,device_z_mm,"
            "proxy_x_mm,proxy_y_mm,proxy_z_mm,contacts,wall_force_max_N,membrane_force_N,"
            "partition_force_N,plastic_work_uJ\n");
}

TEST(CsvRow, SpeaksTheUnitsOfItsHeader)
{
  haptics::TickRecord record;
  record.output.time = 0.25;
  record.output.travel = 0.0005;
  record.output.depth = 0.0025;
  record.output.speed = 0.002;
  record.output.angularDepth = pi / 2;
  record.output.axialForce = 0.125;
  record.output.force_W = {0.5, -0.25, 0.0625};
  record.output.tip_W = {0.001, 0.002, 0.004};
  record.output.device_W = {0.008, 0.016, 0.032};
  record.output.proxy_W = {0.064, 0.128, 0.256};
  record.output.contacts = 17;
  record.output.wallForceMax = 0.75;
  record.output.membraneForce = 0.375;
  record.output.partitionForce = 1.5;
  const std::string upToMembrane =
      "0.25,0.5,2.5,2,90,0.125,0.5,-0.25,0.0625,1,2,4,8,16,32,64,128,256,17,0.75,0.375,";
  EXPECT_EQ(csvRow(record), upToMembrane + "1.5,0\n");  // elastic
  record.output.plasticWork = 0.5e-6;
  EXPECT_EQ(csvRow(record), upToMembrane + "1.5,0.5\n");
  // an earlier version did not record it
  record.output.partitionForce = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(csvRow(record), upToMembrane + ",0.5\n");
}

TEST(CsvRow, KeepsEveryBit)
{
  haptics::TickRecord record;
  record.output.axialForce = 0.1 + 0.2;  // not 0.3
  record.output.wallForceMax = std::numeric_limits<double>::denorm_min();
  const std::vector<std::string> cells = split(csvRow(record));
  ASSERT_EQ(cells.size(), static_cast<std::size_t>(columnCount));
  EXPECT_EQ(std::strtod(cells[5].c_str(), nullptr), 0.1 + 0.2);
  EXPECT_EQ(std::strtod(cells[19].c_str(), nullptr), std::numeric_limits<double>::denorm_min());
}

TEST(CsvPeriod, KeepsOneRowAPeriodThoughTimesAreRounded)
{
  CsvPeriod everyFiveMilliseconds(0.005);
  int kept = 0;
  double time = 0.0;
  for (int tick = 0; tick < 1000; ++tick) {
    if (everyFiveMilliseconds.keeps(time)) {
      EXPECT_EQ(tick % 5, 0) << tick;
      ++kept;
    }
    time += 0.001;  // accumulates rounding errors
  }
  EXPECT_EQ(kept, 200);
}

TEST(CsvPeriod, KeepsEveryTickWhenItIsZeroOrShorterThanATick)
{
  for (const double period : {0.0, 0.0004}) {
    CsvPeriod rows(period);
    for (int tick = 0; tick < 100; ++tick)
      EXPECT_TRUE(rows.keeps(1e-3 * tick)) << period << " s, tick " << tick;
  }
}

}  // namespace
}  // namespace perilymph::session
