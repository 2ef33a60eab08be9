// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// An experiment with one array, coiled and uncoiled: rows of the clinical table.

#include <stop_token>
#include <vector>

#include "perilymph/validation/ClinicalPrediction.h"

namespace perilymph::validation {

/// Number of insertions that the rows need.
inline constexpr std::size_t phantomInsertions = 9;

/// Inserts a FLEX28 by machine into the mean scala tympani at the experiment's speeds.
Result<std::vector<ClinicalRow>> phantomRows(const std::stop_token& stop);

}  // namespace perilymph::validation
