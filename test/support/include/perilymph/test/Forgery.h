// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Recordings modified by other programs.

#include <gtest/gtest.h>
#include <sqlite3.h>

#include <filesystem>
#include <string>

#include "recording/RecordingFormat.h"

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
  forEachRow("SELECT record FROM tick ORDER BY tick",
             [&](sqlite3_stmt* rows) { records.add(std::string_view(text(rows, 0))); });
  sqlite3_close(database);
  runSql(file, "UPDATE meta SET value = '" + sealOver(meta, records) + "' WHERE key = '" +
                   session::MetaKey::contentHash + "'");
}

}  // namespace perilymph::test
