#pragma once

// SQLite behind values that close themselves.

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>

#include "perilymph/foundation/Result.h"

struct sqlite3;
struct sqlite3_stmt;

namespace perilymph::session {

/// A prepared statement. Columns and parameters count from 0.
class Statement {
public:
  enum class Step { row, done, failed };

  void bind(int parameter, double value);
  void bind(int parameter, std::int64_t value);
  void bind(int parameter, const std::string& text);
  void bind(int parameter, std::span<const unsigned char> bytes);

  Step step();
  /// Ready to be bound and stepped anew.
  void reset();

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

/// An open database file.
class Database {
public:
  enum class Access {
    readWrite,  ///< Recovers what a crash left in the `-wal` file.
    immutable,  ///< Reads the file alone, as if nobody could change it; needs no other file.
  };

  static Result<Database> open(const std::filesystem::path& file, Access access);

  /// Runs statements that give no rows.
  Result<Done> run(const std::string& sql);
  Result<Statement> prepare(const std::string& sql) const;
  /// The first column of the first row, as a number; 0 without one.
  std::int64_t number(const std::string& sql) const;

  /// What went wrong last, in SQLite's words.
  std::string trouble() const;
  /// What went wrong last is that the file is none of SQLite's, or damaged.
  bool isDamaged() const;

private:
  struct Close {
    void operator()(sqlite3* database) const noexcept;
  };
  std::unique_ptr<sqlite3, Close> database_;
};

}  // namespace perilymph::session
