// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// What keys of files and columns of tables mean. Writers take the header of a table from the same
// list as the reference of the guide (resources/guide/reference.md), so that no column is without
// a meaning.

#include <string>
#include <vector>

namespace perilymph {

/// A key of a text file or a column of a table.
struct FieldMeaning {
  std::string name;
  std::string unit;  ///< Empty for text, counts, flags and pure numbers.
  std::string meaning;
};
using FieldMeanings = std::vector<FieldMeaning>;

/// The names, separated by commas, without a line end: the header of a CSV file.
inline std::string headerOf(const FieldMeanings& columns)
{
  std::string header;
  for (const FieldMeaning& each : columns) header += (header.empty() ? "" : ",") + each.name;
  return header;
}

}  // namespace perilymph
