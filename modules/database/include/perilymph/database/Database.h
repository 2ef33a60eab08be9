// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The only access to SQLite files. Files are untrusted: they are checked before and while they are
// read.

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <stop_token>
#include <string>

#include "perilymph/database/FileKind.h"
#include "perilymph/foundation/Result.h"

struct sqlite3;
struct sqlite3_stmt;

namespace perilymph::database {

/// A prepared statement. Columns and parameters count from 0.
class Statement {
public:
  enum class Step { row, done, failed };
  enum class Type { integer, real, text, blob, null };

  void bind(int parameter, double value);
  void bind(int parameter, std::int64_t value);
  void bind(int parameter, const std::string& text);
  void bind(int parameter, std::span<const unsigned char> bytes);

  Step step();
  /// Resets the statement for new bindings and steps.
  void reset();

  Type type(int column) const;
  std::string text(int column) const;
  std::int64_t integer(int column) const;
  double real(int column) const;
  /// Valid until the next step.
  std::span<const unsigned char> blob(int column) const;

private:
  friend class Database;
  struct Finalize {
    void operator()(sqlite3_stmt* statement) const noexcept;
  };
  std::unique_ptr<sqlite3_stmt, Finalize> statement_;
};

/// Refuses a name beside which the log or the journal of a database lies that had it before: SQLite would
/// take it for that of the new file, and spoil it.
Result<void> checkNoCompanions(const std::filesystem::path& file);

/// An open file. One thread at a time.
class Database {
public:
  /// An empty database in memory, for SQLite's full-text search.
  static Result<Database> inMemory();

  /// Opens an empty file, created by the caller, for writing.
  static Result<Database> openNew(const std::filesystem::path& file);

  /// Opens a file of a given kind for reading. Returns an error for anything but a
  /// regular file; files of another kind or a newer version; truncated files; companion files that
  /// are links or name further files; tables that differ from those of the kind. A file that was
  /// not closed is recovered with its `-wal` file; if the file is not writable, only checkpointed
  /// content is read, which note() states. Any other file is opened without writing to it. A `-wal` or
  /// `-journal` file of another file is neither read nor changed; note() names it.
  ///
  /// All that is read is of one state of the file, even while another program writes it.
  ///
  /// The work per query is bounded by the size of the file; `stop` ends it earlier.
  static Result<Database> open(const std::filesystem::path& file, const FileKind& kind,
                               std::stop_token stop = {});

  /// Opens a file of a given kind to add to it, with the same checks. Refuses a file that may not be
  /// written, one that another process writes, and one beside which another file's log lies.
  static Result<Database> openToAppend(const std::filesystem::path& file, const FileKind& kind);

  Database(Database&&) noexcept;
  Database& operator=(Database&&) noexcept;
  ~Database();

  /// A sentence about content that could not be read, or empty.
  const std::string& note() const noexcept;
  /// Others had the file open when it was opened: most likely a program that writes it.
  bool isShared() const noexcept;
  /// The version of its kind that the file states.
  std::int64_t version() const noexcept;

  /// Runs statements that return no rows.
  Result<void> run(const std::string& sql);
  Result<Statement> prepare(const std::string& sql) const;

  /// Checks every page, row and index of the file; an error if they are inconsistent.
  Result<void> checkPages() const;

  /// Closes a file that was moved or replaced: checkpoints its log and accesses no file by name,
  /// since the name may belong to another file by now.
  void abandon();

  /// The cause of the last failure, from SQLite or from this module.
  std::string lastError() const;
  /// The last failure was that others use the file.
  bool isBusy() const noexcept;
  /// True once the stop token ended a query.
  bool wasStopped() const noexcept;
  /// Looks at the stop token between the rows of a query, for rows that take long to read.
  bool hasToStop() const noexcept;
  /// Message for a file that could not be read: damaged, with the reason, or stopped.
  Error readingError(const Sentence& reason) const;

  struct Content;  ///< In `src`.

private:
  explicit Database(std::unique_ptr<Content> content);
  std::unique_ptr<Content> content_;
};

}  // namespace perilymph::database
