// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The time series of a recording as a table for SQL.

#include <filesystem>

#include "perilymph/foundation/Result.h"
#include "perilymph/session/RecordedInsertion.h"

namespace perilymph::session {

/// Writes an SQLite file with the table `tick`: the number of each tick and the columns of Csv.h. It
/// replaces a file of this name when it is whole.
Result<void> writeTickTable(const RecordedInsertion& recorded, const std::filesystem::path& file);

}  // namespace perilymph::session
