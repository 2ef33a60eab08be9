// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// An open recording, shared by the files that read it.

#include <filesystem>
#include <functional>
#include <optional>
#include <span>

#include "perilymph/database/Database.h"
#include "perilymph/session/RecordedInsertion.h"
#include "recording/RecordedFacts.h"

namespace perilymph::session {

struct RecordedInsertion::Content {
  Content(std::filesystem::path place, database::Database opened)
      : file(std::move(place)), database(std::move(opened))
  {
  }

  std::filesystem::path file;
  database::Database database;
  MetaRows meta;
  RecordingFacts facts;
  bool wasClosed = false;
  std::uint64_t lostRecords = 0;
  std::string note;
  std::optional<Highlights> highlights;   ///< As stored in the file.
  std::optional<std::uint64_t> lastTick;  ///< Those after it are left out.

  Error damaged(const Sentence& reason) const { return database.readingError(reason); }

  Result<void> readMeta();
  Result<void> readFacts();
  /// Calls `each` for the rows of a query whose first column is an increasing key, until it returns
  /// false. A damaged tree could return the same rows forever.
  Result<void> forEachRising(
      const std::string& sql, std::int64_t firstKey,
      const std::function<Result<bool>(const database::Statement&)>& each) const;

  /// Ticks are in the table `block`; else, in earlier formats, each is a row of the table `tick`.
  bool hasBlocks() const { return database.version() >= firstVersionWithBlocks; }
  /// Calls `each` with the ticks of every row from that which holds `firstTick`, in order, until it
  /// returns false. Columns of the row: tick, ticks, packed; or tick, record and recordedNames.
  Result<void> forEachBlock(
      std::uint64_t firstTick,
      const std::function<Result<bool>(std::span<const haptics::TickRecord>,
                                       const database::Statement& row)>& each) const;
};

}  // namespace perilymph::session
