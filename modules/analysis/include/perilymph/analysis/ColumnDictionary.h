// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The dictionary of a table: what its columns are.

#include <string>

#include "perilymph/foundation/CsvField.h"
#include "perilymph/foundation/FieldMeaning.h"

namespace perilymph::analysis {

/// `column, unit, meaning`: a row for each column, in their order.
inline std::string dictionaryCsv(const FieldMeanings& columns)
{
  std::string csv = "column,unit,meaning\n";
  for (const FieldMeaning& each : columns)
    csv += each.name + "," + each.unit + "," + csvField(each.meaning) + "\n";
  return csv;
}

}  // namespace perilymph::analysis
