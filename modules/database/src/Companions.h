#pragma once

// What lies beside a database: SQLite reads these files, too, and believes what they say.

#include <filesystem>

#include "perilymph/foundation/Result.h"

namespace perilymph::database {

/// The files that a database which was not closed leaves beside itself.
struct Companions {
  bool hasLog = false;     ///< A `-wal` file with something in it.
  bool areToRead = false;  ///< There is something to recover: SQLite must be allowed to write.
};

/// Looks at them before SQLite does. Refused is what no database of ours ever has: companions that
/// are links or no regular files, and a `-journal` that names a further file (see OwnFilesOnly.h).
Result<Companions> companionsOf(const std::filesystem::path& database);

}  // namespace perilymph::database
