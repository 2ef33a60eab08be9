// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Recordings modified by other programs.

#include <gtest/gtest.h>
#include <sqlite3.h>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "perilymph/session/RecordedInsertion.h"
#include "recording/RecordingFormat.h"
#include "recording/TickBlock.h"

namespace perilymph::test {

/// Runs SQL on a file, as any program could.
inline void runSql(const std::filesystem::path& file, const std::string& sql)
{
  sqlite3* database = nullptr;
  ASSERT_EQ(sqlite3_open(file.c_str(), &database), SQLITE_OK);
  ASSERT_EQ(sqlite3_exec(database, sql.c_str(), nullptr, nullptr, nullptr), SQLITE_OK)
      << sql << ": " << sqlite3_errmsg(database);
  sqlite3_close(database);
}

/// Packs the ticks of a recording again after a change, as other programs could: neither its hash nor its
/// events or figures follow.
inline void changeTicks(const std::filesystem::path& file,
                        const std::function<void(std::vector<haptics::TickRecord>&)>& change)
{
  std::vector<haptics::TickRecord> records;
  {
    const auto recorded = session::RecordedInsertion::open(file);
    ASSERT_TRUE(recorded) << recorded.error().message;
    ASSERT_TRUE(recorded->forEach([&records](const haptics::TickRecord& record) {
      records.push_back(record);
      return true;
    }));
  }
  change(records);
  runSql(file, "DELETE FROM block");
  sqlite3* database = nullptr;
  ASSERT_EQ(sqlite3_open(file.c_str(), &database), SQLITE_OK);
  sqlite3_stmt* insert = nullptr;
  ASSERT_EQ(sqlite3_prepare_v2(database, "INSERT INTO block VALUES(?,?,?)", -1, &insert, nullptr),
            SQLITE_OK);
  session::BlockPacker packer;
  for (std::span<const haptics::TickRecord> rest(records); !rest.empty();) {
    const auto block = rest.first(std::min(rest.size(), session::blockTicks));
    rest = rest.subspan(block.size());
    const auto packed = packer.pack(block);
    sqlite3_reset(insert);
    sqlite3_bind_int64(insert, 1, static_cast<sqlite3_int64>(block.front().tick));
    sqlite3_bind_int64(insert, 2, static_cast<sqlite3_int64>(block.size()));
    sqlite3_bind_blob(insert, 3, packed.data(), static_cast<int>(packed.size()), SQLITE_TRANSIENT);
    ASSERT_EQ(sqlite3_step(insert), SQLITE_DONE) << sqlite3_errmsg(database);
  }
  sqlite3_finalize(insert);
  sqlite3_close(database);
}

/// A change that removes the ticks `from` to `to`.
inline std::function<void(std::vector<haptics::TickRecord>&)> withoutTicks(std::uint64_t from,
                                                                           std::uint64_t to)
{
  return [from, to](std::vector<haptics::TickRecord>& records) {
    std::erase_if(records, [&](const haptics::TickRecord& record) {
      return record.tick >= from && record.tick <= to;
    });
  };
}

/// Stores in a modified recording the hash of its current content, as a forger would.
inline void rehash(const std::filesystem::path& file)
{
  sqlite3* database = nullptr;
  ASSERT_EQ(sqlite3_open(file.c_str(), &database), SQLITE_OK);
  const auto forEachRow = [database](const char* sql, const auto& each) {
    sqlite3_stmt* rows = nullptr;
    ASSERT_EQ(sqlite3_prepare_v2(database, sql, -1, &rows, nullptr), SQLITE_OK);
    while (sqlite3_step(rows) == SQLITE_ROW) each(rows);
    sqlite3_finalize(rows);
  };
  const auto text = [](sqlite3_stmt* rows, int column) {
    const void* bytes = sqlite3_column_blob(rows, column);
    return std::string(static_cast<const char*>(bytes),
                       static_cast<std::size_t>(sqlite3_column_bytes(rows, column)));
  };
  session::MetaRows meta;
  Sha256 records;
  forEachRow("SELECT key, value FROM meta WHERE value <> ''",
             [&](sqlite3_stmt* rows) { meta[text(rows, 0)] = text(rows, 1); });
  forEachRow("SELECT key FROM meta WHERE value = ''",
             [&](sqlite3_stmt* rows) { meta[text(rows, 0)] = ""; });
  forEachRow("SELECT tick, ticks, packed FROM block ORDER BY tick", [&](sqlite3_stmt* rows) {
    const std::string packed = text(rows, 2);
    session::addBlock(
        records, sqlite3_column_int64(rows, 0), sqlite3_column_int64(rows, 1),
        std::span(reinterpret_cast<const unsigned char*>(packed.data()), packed.size()));
  });
  sqlite3_close(database);
  runSql(file, "UPDATE meta SET value = '" + sealOver(meta, records) + "' WHERE key = '" +
                   session::MetaKey::contentHash + "'");
}

}  // namespace perilymph::test
