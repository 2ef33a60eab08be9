// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <string>
#include <vector>

namespace perilymph::study {

/// What a column of a table is.
struct ColumnMeaning {
  const char* table;
  const char* column;
  const char* unit;  ///< Empty without one.
  const char* meaning;
};
/// Every column of every table, in their order.
std::span<const ColumnMeaning> studyColumnMeanings();

/// The views of a study's file: `CREATE VIEW` statements, one per question.
std::vector<std::string> studyViews();
/// Those of version 3 of the file that are others now.
std::vector<std::string> formerStudyViews();

/// The same of files that earlier versions wrote, where they differ.
std::vector<std::string> formerStudyViews();

}  // namespace perilymph::study
