// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The data of an open database.

#include <sqlite3.h>

#include <filesystem>
#include <memory>
#include <stop_token>
#include <string>

#include "perilymph/database/Database.h"

namespace perilymph::database {

/// Bounds the work of one query; called by SQLite at regular numbers of instructions.
struct Watch {
  std::stop_token stop;
  std::int64_t maxInstructions = 0;  ///< 0: unbounded.
  std::int64_t instructions = 0;     ///< Executed so far in this query.
  bool wasStopped = false;
  bool isExhausted = false;
};

struct Database::Content {
  struct Close {
    void operator()(sqlite3* opened) const noexcept { sqlite3_close_v2(opened); }
  };

  std::filesystem::path file;
  Sentence remedy;  ///< FileKind::remedy.
  std::string note;
  bool isShared = false;
  std::int64_t version = 0;
  std::unique_ptr<Watch> watch = std::make_unique<Watch>();  ///< SQLite keeps its address.
  std::unique_ptr<sqlite3, Close> database;

  enum class Access {
    write,      ///< Adds to the file.
    recovery,   ///< Reads it with its `-wal` file, which the last connection merges into it.
    trial,      ///< The same for this connection alone, and nothing is written.
    immutable,  ///< Reads the file alone, without locks or other files.
  };
  Result<void> open(const std::filesystem::path& place, Access access);
  /// Refuses a schema that differs from the kind's.
  Result<void> check(const FileKind& kind);
  /// Database::checkPages().
  Result<void> checkPages() const;
  /// Database::lastError().
  std::string lastError() const;
  Error error(const Sentence& reason) const;
};

}  // namespace perilymph::database
