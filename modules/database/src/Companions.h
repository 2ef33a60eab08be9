// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The files beside a database, which SQLite reads and trusts.

#include <filesystem>

#include "perilymph/foundation/Result.h"

namespace perilymph::database {

/// The files left beside a database that was not closed.
struct Companions {
  bool hasLog = false;     ///< There is a nonempty `-wal` file.
  bool areToRead = false;  ///< Recovery is needed: SQLite must be allowed to write.
};

/// Inspects the companion files before SQLite opens them. Refuses what no database of this program
/// has: companions that are links or no regular files, and a `-journal` that names a further file
/// (see OwnFilesOnly.h).
Result<Companions> companionsOf(const std::filesystem::path& database);

}  // namespace perilymph::database
