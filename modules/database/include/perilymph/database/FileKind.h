// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Identification of one kind of SQLite file of this program.

#include <cstdint>
#include <string>
#include <vector>

#include "perilymph/foundation/Sentence.h"

namespace perilymph::database {

/// A kind of file and its exact schema. A file with anything else (other views, triggers, indices,
/// generated columns, further tables) is refused.
struct FileKind {
  Sentence name;                    ///< Name with article, for messages: "a recording of
                                    ///< Perilymph".
  Sentence choice;                  ///< What to open instead: "Choose an .insertion file."
  Sentence remedy;                  ///< For a damaged one: "Use another copy of the recording."
  std::int64_t applicationId = 0;   ///< SQLite's application_id.
  std::int64_t newestVersion = 1;   ///< Versions 1 to this one are accepted (SQLite's
                                    ///< user_version).
  std::vector<std::string> tables;  ///< `CREATE TABLE` statements of new files.
  /// `CREATE VIEW` statements for other programs; earlier versions may lack them.
  std::vector<std::string> views = {};
  /// The same of views in files of earlier versions, which new files do not have.
  std::vector<std::string> formerViews = {};
  std::int64_t tablesSince = 1;                ///< First version with `tables`.
  std::vector<std::string> formerTables = {};  ///< The same of files of versions before it.
  /// Queries for rows that are never changed or removed once they are written: the log of a file has
  /// them all. Those of tables that a version does not have are not used.
  std::vector<std::string> lasting = {};
  /// `applicationId` of former versions; 0 if it was the same.
  std::int64_t formerApplicationId = 0;
};

/// SQL statements that mark an empty file as the newest version of its kind, begin a transaction
/// and create the tables and views.
std::string creationOf(const FileKind& kind);

}  // namespace perilymph::database
