#pragma once

// What tells one kind of our SQLite files from every other file.

#include <cstdint>
#include <string>
#include <vector>

namespace perilymph::database {

/// A kind of file and exactly what is in it. A file that holds anything else (views, triggers,
/// indices, generated columns, further tables) is refused.
struct FileKind {
  std::string name;                 ///< With its article, in sentences: "a recording of Perilymph".
  std::string choice;               ///< What to open instead: "Choose an .insertion file."
  std::string remedy;               ///< For a damaged one: "Use another copy of the recording."
  std::int64_t applicationId = 0;   ///< SQLite's application_id.
  std::int64_t newestVersion = 1;   ///< Versions 1 to this one are opened (SQLite's user_version).
  std::vector<std::string> tables;  ///< `CREATE TABLE` statements, the same in every version.
};

/// Statements that mark an empty file as the newest version of its kind, begin a transaction and
/// create the tables in it.
std::string creationOf(const FileKind& kind);

}  // namespace perilymph::database
