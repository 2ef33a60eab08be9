#pragma once

// What lies beside a recording: SQLite reads these files, too, and believes what they say.

#include <filesystem>

#include "perilymph/foundation/Result.h"

namespace perilymph::session {

/// The files that a recording which was not closed leaves beside itself.
struct Companions {
  bool hasLog = false;     ///< A `-wal` file with something in it.
  bool areToRead = false;  ///< There is something to recover: SQLite must be allowed to write.
};

/// Looks at them before SQLite does. Refused is what no recording ever has: companions that are
/// links to something else, and a `-journal` that names a further file, which SQLite would take for
/// the journal of several databases and, once done with it, delete, whatever it is (its file
/// format, section 3, and `pager_delsuper`).
Result<Companions> companionsOf(const std::filesystem::path& recording);

}  // namespace perilymph::session
