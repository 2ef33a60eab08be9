// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Ticks of an insertion as NumPy columns, those of the CSV files.

#include <array>
#include <vector>

#include "PythonErrors.h"
#include "perilymph/session/Csv.h"

namespace perilymph::python {

/// Collects the columns tick by tick.
class RecordColumns {
public:
  /// @param period  Between rows [s]; 0 keeps every tick.
  explicit RecordColumns(double period) : period_(period) {}

  /// Without the interpreter's lock.
  void add(const haptics::TickRecord& tick);

  /// The columns by name, which it gives away.
  py::dict result();

private:
  session::CsvPeriod period_;
  std::array<std::vector<double>, session::columnCount> columns_;
};

}  // namespace perilymph::python
