// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// A patient's record as JSON. Format 1 had tags, notes and scans alone; 2 has the rest; 3 has markups, too. A
// record without markups is written as format 2, which older programs read.

#include <string>

#include "perilymph/session/PatientRecord.h"

namespace perilymph::session {

inline constexpr int recordFormat = 3;

/// The record with its seal. Measures stand beside each version's text, with their
/// intervals, and values beside the points of a markup.
std::string textOf(const PatientRecord& record);

/// The record in a text; `name` is that of the file, for messages.
Result<PatientRecord> recordIn(const std::string& text, const std::string& name);

}  // namespace perilymph::session
