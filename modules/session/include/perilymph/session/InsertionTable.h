// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Many insertions in a SQLite file: rows, identity, seal, blocks, and how a run continues. Plans and
// studies say which tables they have; everything else about their files is here.

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <variant>
#include <vector>

#include "perilymph/database/Database.h"
#include "perilymph/foundation/AtomicFile.h"
#include "perilymph/foundation/Result.h"
#include "perilymph/foundation/Seal.h"

namespace perilymph::session {

/// A value of a row.
using Cell = std::variant<std::int64_t, double, std::string>;
using Row = std::vector<Cell>;

/// One insertion: its row, and its rows in each of the other tables, which begin with its number.
struct InsertionRows {
  Row row;
  std::vector<std::vector<Row>> others = {};
};

/// A kind of file with insertions.
struct InsertionTableKind {
  /// Types of a table's columns: 'i' whole number, 'r' number, 't' text; the key comes first.
  struct Table {
    std::string name, columns;
    std::size_t keys = 1;  ///< Columns of the key.
  };

  database::FileKind file;    ///< Its first table is `meta`.
  std::int64_t sealedFrom;    ///< First version with a seal.
  std::vector<Table> tables;  ///< That of the insertions first.
  Sentence foreign;           ///< Follows the file's name: "belongs to another plan, ...".
  Sentence results;           ///< "draws", for messages.
  Audience audience = Audience::everyone;  ///< Who may read a new file.
};

/// Names of the facts that every file has.
inline constexpr const char* fingerprintFact = "fingerprint";
inline constexpr const char* programFact = "program";

/// FileKind::lasting of such a file: its facts but the seal, and the rows of a table by its key.
std::vector<std::string> lastingRows(const std::string& table, const std::string& key);

/// An open file. Its seal covers all facts and all rows and is renewed with every block.
class InsertionTable {
public:
  /// Opens a file to continue, or creates it with these facts. Refuses a file with other facts, one
  /// that was changed after it was written, and one that another program works on.
  static Result<InsertionTable> openToContinue(const std::filesystem::path& file,
                                               const InsertionTableKind& kind,
                                               const SealedFacts& facts);
  /// Begins a file again whose content is computed from other files: what it has is removed. Refuses links
  /// and folders, a file that may not be written, and one that another program works on.
  static Result<InsertionTable> beginAgain(const std::filesystem::path& file,
                                           const InsertionTableKind& kind,
                                           const SealedFacts& facts);
  /// Opens a file for reading, and checks every row: seal() then holds for what read() gives.
  static Result<InsertionTable> open(const std::filesystem::path& file,
                                     const InsertionTableKind& kind);
  /// The facts of a file and how many insertions it has, without a look at their values.
  struct Outline {
    SealedFacts facts;
    std::size_t count = 0;
  };
  static Result<Outline> outlineOf(const std::filesystem::path& file,
                                   const InsertionTableKind& kind);

  /// The facts, without the seal.
  const SealedFacts& facts() const noexcept { return facts_; }
  Seal seal() const noexcept { return seal_; }
  /// Number of insertions.
  std::size_t size() const noexcept { return count_; }

  /// Calls `each` with every insertion, in the order of the keys. Refuses keys that do not increase,
  /// values of another type, and rows that belong to no insertion.
  Result<void> read(const std::function<Result<void>(const InsertionRows&)>& each) const;

  /// Adds a block in one transaction: all of it is in the file afterwards, or nothing. A commit
  /// survives the end of the process and of the machine.
  Result<void> append(const std::vector<InsertionRows>& block);
  /// Ends writing: the file is then one file, without companions.
  Result<void> close();

  /// "FILE is damaged (REASON). ..."
  Error damaged(const Sentence& reason) const { return database_.readingError(reason); }

private:
  InsertionTable(database::Database database, std::filesystem::path file,
                 const InsertionTableKind& kind)
      : database_(std::move(database)), file_(std::move(file)), kind_(&kind)
  {
  }
  Result<void> readFacts();
  Result<void> checkRows();
  Result<void> expect(const SealedFacts& facts) const;

  database::Database database_;
  std::filesystem::path file_;
  const InsertionTableKind* kind_;  ///< A constant of the program.
  SealedFacts facts_;
  Sha256 rows_;
  std::size_t count_ = 0;
  Seal seal_ = Seal::intact;
};

}  // namespace perilymph::session
