// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The files beside a database, which SQLite takes for its own.

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "perilymph/foundation/Result.h"

namespace perilymph::database {

/// Content of the beginning of a database file.
struct FileHeader {
  bool isDatabase = false;
  bool isWhole = true;    ///< The file has the length its header states.
  bool usesLog = false;   ///< Its newest content may be in a `-wal` file: it was not closed.
  std::string firstPage;  ///< As far as the file has it.
};

/// Reads it through SQLite: to open and close the file beside SQLite would take the locks away that
/// another connection of this process holds on it (SQLite, "How To Corrupt", section 2.2).
FileHeader readHeader(const std::filesystem::path& file);

/// What lies beside a database.
struct Companions {
  bool isLogThere = false;         ///< There is a `-wal` file.
  bool hasLog = false;             ///< It is not empty.
  bool hasForeignLog = false;      ///< Not that of this file, whatever it holds.
  bool hasForeignJournal = false;  ///< There is a `-journal` file of another file.
};

/// Inspects the companion files before SQLite opens them. Refuses what no database of this program
/// has: companions that are links or no regular files, and a `-journal` that names a further file
/// (see OwnFilesOnly.h).
///
/// A `-wal` file belongs to no file that was closed, and not to one of another page size. A `-journal`
/// is left beside a file of this program only where its log begins or ends: it holds the first page alone,
/// which differs in no row.
Result<Companions> companionsOf(const std::filesystem::path& database, const FileHeader& header);

/// Where a log is damaged: the first byte of the frame that fails its checksum though a whole transaction of the
/// same log comes after it (SQLite file format, section 4). None for a log that ends within a transaction, as
/// a crash leaves it. SQLite reads what is before it, and then deletes the log.
std::optional<std::uint64_t> damageOf(const std::filesystem::path& log);

}  // namespace perilymph::database
