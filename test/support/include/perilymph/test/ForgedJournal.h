// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// A rollback journal that would make SQLite delete another file.

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>

namespace perilymph::test {

/// Writes a journal beside a database that names `victim` as its super-journal (SQLite's file
/// format, section 3: a header padded to a sector, no pages, the name with its length and checksum).
inline void forgeJournal(const std::filesystem::path& database, const std::filesystem::path& victim)
{
  const std::string magic("\xd9\xd5\x05\xf9\x20\xa1\x63\xd7", 8);
  std::string journal = magic;
  const auto put = [&journal](std::uint32_t number) {
    for (int shift = 24; shift >= 0; shift -= 8) journal += static_cast<char>(number >> shift);
  };
  put(0);  // pages kept
  put(1);  // salt
  put(static_cast<std::uint32_t>(std::filesystem::file_size(database) / 4096));
  put(512);   // bytes per sector
  put(4096);  // bytes per page
  journal.resize(512, '\0');
  const std::string name = victim.string();
  put(0x40000000 / 4096 + 1);  // the page number that is never used
  journal += name;
  put(static_cast<std::uint32_t>(name.size()));
  std::uint32_t sum = 0;
  for (const char letter : name) sum += static_cast<std::uint32_t>(letter);
  put(sum);
  journal += magic;
  std::ofstream(database.string() + "-journal", std::ios::binary) << journal;
}

}  // namespace perilymph::test
