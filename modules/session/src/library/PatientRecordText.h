// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// A patient's record as JSON: format 2, and format 1, which had tags, notes and scans alone.

#include <string>

#include "perilymph/session/PatientRecord.h"

namespace perilymph::session {

inline constexpr int recordFormat = 2;

/// The record with its seal. Measures stand beside each version's text, with their intervals.
std::string textOf(const PatientRecord& record);

/// The record in a text; `name` is that of the file, for messages.
Result<PatientRecord> recordIn(const std::string& text, const std::string& name);

}  // namespace perilymph::session
