// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The readable columns of an insertion, in CSV files and, but for the last two, in recordings.

#include <array>
#include <string>

#include "perilymph/foundation/FieldMeaning.h"
#include "perilymph/haptics/Snapshot.h"

namespace perilymph::session {

inline constexpr int columnCount = 23;
/// Those at the beginning that a recording has as columns of its table; its records hold all.
inline constexpr int recordedColumnCount = 21;

/// Column names with units, in order.
extern const std::array<const char*, columnCount> columnNames;
/// The same in the table of a recording, which keeps the names of its first version: the tip angle is
/// `angular_depth_deg` there.
extern const std::array<const char*, recordedColumnCount> recordedNames;

/// What they mean, in the same order.
const FieldMeanings& tickColumns();

/// The values of one tick in the units of columnNames. x, y, z are in W (right ear); the axial
/// force is that on the hand, positive while pushing in. The force on the partition is NaN where a
/// recording of an earlier version has none, the work of yielding where nothing can yield.
std::array<double, columnCount> columnValues(const haptics::TickRecord& record);

/// The shortest decimal that reads back as the same number, with a decimal point in any locale.
std::string shortestDecimal(double value);

/// "time_s,travel_mm,...\n".
std::string csvHeader();

/// One row of shortest decimals with its line end.
std::string csvRow(const haptics::TickRecord& record);

/// Selects the ticks for a file with a fixed row period: the first at or after each multiple of the
/// period.
class CsvPeriod {
public:
  /// @param period  Between rows [s]; 0 keeps every tick.
  explicit CsvPeriod(double period) : period_(period) {}

  /// True if the tick at this time [s] is selected. Times must not decrease.
  bool keeps(double time);

private:
  double period_;
  double next_ = 0.0;
  long count_ = 0;
};

}  // namespace perilymph::session
