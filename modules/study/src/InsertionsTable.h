// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Insertions of a study as rows of a CSV file.

#include <set>
#include <string>

#include "perilymph/study/StudyFile.h"

namespace perilymph::study {

/// "number,cochlea,<settings>,ending,..." with the study's own settings as columns.
std::string insertionsHeader(const std::set<std::string>& settings);
/// A row of it with its line end.
std::string insertionsRow(const StudyResult& result, const std::set<std::string>& settings);

}  // namespace perilymph::study
