#pragma once

// The one door to SQLite: files are checked before and while they are read, because they may come
// from anybody.

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <span>
#include <string>

#include "perilymph/database/FileKind.h"
#include "perilymph/foundation/Result.h"

struct sqlite3;
struct sqlite3_stmt;

namespace perilymph::database {

/// Asked some fifty times a second while a file is read; true ends the reading.
using ShouldStop = std::function<bool()>;

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
  /// Makes the statement ready to be bound and stepped again.
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

/// An open file. One thread at a time.
class Database {
public:
  /// Opens an empty file of the caller's for writing.
  static Result<Database> openNew(const std::filesystem::path& file);

  /// Opens a file of a kind to read it. Refused, in one sentence each: what is no regular file, no
  /// file of that kind or of a newer version; a file cut short; companion files that are links or
  /// that name further files; tables that are not exactly the kind's. A file that was not closed is
  /// recovered with its `-wal` file; where it cannot be written, only what was folded into it is
  /// read, and note() says so. Any other file is read without a byte being written.
  ///
  /// No query runs longer than a file of that size can need; `shouldStop` ends it earlier.
  static Result<Database> open(const std::filesystem::path& file, const FileKind& kind,
                               ShouldStop shouldStop = {});

  Database(Database&&) noexcept;
  Database& operator=(Database&&) noexcept;
  ~Database();

  /// A sentence about what could not be read, or empty.
  const std::string& note() const noexcept;
  /// The version of its kind that the file says it has.
  std::int64_t version() const noexcept;

  /// Runs statements that give no rows.
  Result<Done> run(const std::string& sql);
  Result<Statement> prepare(const std::string& sql) const;

  /// Walks through every page, row and index of the file; an error where they contradict one
  /// another.
  Result<Done> checkPages() const;

  /// Closes a file that is not at its place any more: folds its log into it, and touches no file by
  /// name, where somebody else's may be by now.
  void abandon();

  /// The reason of the last failure, in SQLite's words or ours.
  std::string lastError() const;
  /// True once `shouldStop` ended a query.
  bool wasStopped() const noexcept;
  /// The sentence for a file whose reading failed: damaged, for that reason, or stopped.
  Error readingError(const std::string& reason) const;

private:
  struct Content;
  explicit Database(std::unique_ptr<Content> content);
  std::unique_ptr<Content> content_;
};

}  // namespace perilymph::database
