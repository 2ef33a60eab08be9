// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The dictionary of a table: what its columns are.

#include <span>
#include <string>
#include <string_view>

#include "perilymph/foundation/CsvField.h"

namespace perilymph::planning {

/// One column of a table, and what it means.
struct DictionaryRow {
  std::string_view key, unit, meaning, source;
};

/// The first line of the table.
inline std::string headCsv(std::span<const DictionaryRow> columns)
{
  std::string head;
  for (const DictionaryRow& each : columns)
    head += (head.empty() ? "" : ",") + std::string(each.key);
  return head + "\n";
}

/// `column, unit, meaning, source`, a row each.
inline std::string dictionaryCsv(std::span<const DictionaryRow> columns)
{
  std::string csv = "column,unit,meaning,source\n";
  for (const DictionaryRow& each : columns)
    csv += std::string(each.key) + "," + std::string(each.unit) + "," +
           csvField(std::string(each.meaning)) + "," + csvField(std::string(each.source)) + "\n";
  return csv;
}

}  // namespace perilymph::planning
