// SPDX-License-Identifier: BSD-3-Clause
#include "Companions.h"

#include <sqlite3.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <memory>
#include <string_view>

#include "Content.h"

namespace perilymph::database {

namespace {

namespace fs = std::filesystem;

/// Last bytes of a journal that names a further file.
constexpr std::array<unsigned char, 8> journalMagic = {0xd9, 0xd5, 0x05, 0xf9,
                                                       0x20, 0xa1, 0x63, 0xd7};
constexpr std::size_t headerBytes = 100;    // SQLite file format, section 1.3
constexpr std::size_t logHeaderBytes = 32;  // section 4.1

std::uint64_t bigEndian(std::string_view bytes, std::size_t first, std::size_t count)
{
  std::uint64_t value = 0;
  for (std::size_t i = 0; i < count; ++i)
    value = value << 8 | static_cast<unsigned char>(bytes[first + i]);
  return value;
}

std::uint64_t pageSizeIn(std::string_view page)
{
  const std::uint64_t field = bigEndian(page, 16, 2);
  return field == 1 ? 65536 : field;
}

/// The beginning of a companion file.
std::string beginningOf(const fs::path& file, std::size_t bytes)
{
  std::string content(bytes, '\0');
  std::ifstream stream(file, std::ios::binary);
  stream.read(content.data(), static_cast<std::streamsize>(bytes));
  content.resize(static_cast<std::size_t>(stream.gcount()));
  return content;
}

bool namesFurtherFile(const fs::path& journal)
{
  std::ifstream stream(journal, std::ios::binary);
  stream.seekg(-static_cast<std::streamoff>(journalMagic.size()), std::ios::end);
  std::array<unsigned char, journalMagic.size()> last{};
  stream.read(reinterpret_cast<char*>(last.data()), last.size());
  // A journal with only a header ends in zeros: SQLite pads it to a sector.
  return stream.gcount() == static_cast<std::streamsize>(last.size()) && last == journalMagic;
}

/// Whether two first pages differ only where a change of the journal mode writes: the versions of the
/// format, the counter of changes, and the library's version (section 1.3).
bool differInVersionsOnly(std::string_view one, std::string_view other)
{
  if (one.size() != other.size()) return false;
  for (std::size_t i = 0; i < one.size(); ++i) {
    const bool isVersion = (i >= 18 && i < 20) || (i >= 24 && i < 28) || (i >= 92 && i < 100);
    if (!isVersion && one[i] != other[i]) return false;
  }
  return true;
}

/// Whether a journal would change a row of the file, or its length (section 3).
bool isForeignJournal(const fs::path& journal, const FileHeader& header)
{
  const std::string begin = beginningOf(journal, 28);
  // without its first bytes SQLite ignores it
  if (begin.size() < 28 || !std::equal(journalMagic.begin(), journalMagic.end(), begin.begin(),
                                       [](unsigned char magic, char byte) {
                                         return magic == static_cast<unsigned char>(byte);
                                       }))
    return false;
  const std::uint64_t pages = bigEndian(begin, 16, 4), sector = bigEndian(begin, 20, 4),
                      pageSize = bigEndian(begin, 24, 4);
  if (header.firstPage.size() != pageSize || pages != bigEndian(header.firstPage, 28, 4))
    return true;
  std::error_code ignored;
  const std::uint64_t size = fs::file_size(journal, ignored);
  constexpr std::uint64_t numberAndChecksum = 8;
  if (size <= sector) return false;  // no page
  if (size > sector + pageSize + numberAndChecksum) return true;
  const std::string all = beginningOf(journal, size);
  if (all.size() < sector + 4 + pageSize) return false;  // not whole: ignored
  return bigEndian(all, sector, 4) != 1 ||
         !differInVersionsOnly(std::string_view(all).substr(sector + 4, pageSize),
                               header.firstPage);
}

/// Whether a log, by its first bytes, is not that of a file (section 4.1).
bool isForeignLog(const fs::path& log, const FileHeader& header)
{
  if (!header.usesLog) return true;
  const std::string begin = beginningOf(log, logHeaderBytes);
  if (begin.size() < logHeaderBytes) return false;  // SQLite ignores it
  constexpr std::uint64_t logMagic = 0x377f0682;    // its last bit is the order of bytes
  return (bigEndian(begin, 0, 4) & ~std::uint64_t{1}) != logMagic ||
         bigEndian(begin, 8, 4) != pageSizeIn(header.firstPage);
}

}  // namespace

FileHeader readHeader(const fs::path& file)
{
  FileHeader header;
  Database::Content content;
  if (!content.open(file, Database::Content::Access::immutable)) return header;
  sqlite3_file* opened = nullptr;
  sqlite3_int64 size = 0;
  if (sqlite3_file_control(content.database.get(), "main", SQLITE_FCNTL_FILE_POINTER, &opened) !=
          SQLITE_OK ||
      opened->pMethods == nullptr || opened->pMethods->xFileSize(opened, &size) != SQLITE_OK)
    return header;
  const auto read = [&](std::size_t bytes) {
    std::string begin(std::min(bytes, static_cast<std::size_t>(size)), '\0');
    if (opened->pMethods->xRead(opened, begin.data(), static_cast<int>(begin.size()), 0) !=
        SQLITE_OK)
      begin.clear();
    return begin;
  };
  const std::string begin = read(headerBytes);
  constexpr std::string_view magic("SQLite format 3\0", 16);
  header.isDatabase = begin.starts_with(magic);
  if (!header.isDatabase) return header;
  header.isWhole = begin.size() == headerBytes;
  if (!header.isWhole) return header;
  const std::uint64_t pageSize = pageSizeIn(begin);
  header.isWhole = static_cast<std::uint64_t>(size) >= bigEndian(begin, 28, 4) * pageSize;
  constexpr char withLog = 2;
  header.usesLog = begin[18] == withLog || begin[19] == withLog;
  header.firstPage = read(std::max<std::size_t>(pageSize, headerBytes));
  return header;
}

Result<Companions> companionsOf(const fs::path& database, const FileHeader& header)
{
  Companions found;
  for (const std::string ending : {"-wal", "-journal", "-shm"}) {
    const fs::path companion = database.string() + ending;
    const auto refused = [&](const std::string& reason) {
      return Error{"%1 %2, so the file beside it is not opened. Copy %3 alone to another folder.",
                   companion, reason, database.filename()};
    };
    std::error_code ignored;
    const fs::file_status status = fs::symlink_status(companion, ignored);
    if (!fs::exists(status)) continue;
    if (fs::is_symlink(status)) return refused("is not a file but a link");
    if (!fs::is_regular_file(status)) return refused("is not a file but something else");
    if (ending == "-journal") {
      if (namesFurtherFile(companion))
        return refused("names a further file, which no file of Perilymph does");
      found.hasForeignJournal = isForeignJournal(companion, header);
    }
    if (ending == "-wal") {
      found.isLogThere = true;
      found.hasLog = fs::file_size(companion, ignored) > 0;
      found.hasForeignLog = found.hasLog && isForeignLog(companion, header);
    }
  }
  return found;
}

std::optional<std::uint64_t> damageOf(const fs::path& log)
{
  constexpr std::size_t frameHeaderBytes = 24;
  std::ifstream stream(log, std::ios::binary);
  std::string header(logHeaderBytes, '\0');
  if (!stream.read(header.data(), logHeaderBytes)) return std::nullopt;
  const bool isBigEndian = (bigEndian(header, 0, 4) & 1) != 0;
  const std::size_t pageSize = bigEndian(header, 8, 4);
  constexpr std::size_t maxPageSize = 65536;
  if (pageSize == 0 || pageSize > maxPageSize) return std::nullopt;
  std::uint32_t sum = 0, other = 0;
  const auto add = [&](std::string_view bytes) {
    const auto word = [&](std::size_t at) {
      std::uint32_t value = 0;
      for (std::size_t i = 0; i < 4; ++i)
        value |= std::uint32_t{static_cast<unsigned char>(bytes[at + i])}
                 << 8 * (isBigEndian ? 3 - i : i);
      return value;
    };
    for (std::size_t i = 0; i + 8 <= bytes.size(); i += 8) {
      sum += word(i) + other;
      other += word(i + 4) + sum;
    }
  };
  add(std::string_view(header).substr(0, 24));
  const std::string salts = header.substr(16, 8);
  std::optional<std::uint64_t> damage;
  std::string frame(frameHeaderBytes + pageSize, '\0');
  for (std::uint64_t at = logHeaderBytes;
       stream.read(frame.data(), static_cast<std::streamsize>(frame.size())); at += frame.size()) {
    const bool isOfLog = frame.compare(8, 8, salts) == 0;
    if (damage) {
      const bool endsTransaction = bigEndian(frame, 4, 4) != 0;
      if (isOfLog && endsTransaction) return damage;
      continue;
    }
    add(std::string_view(frame).substr(0, 8));
    add(std::string_view(frame).substr(frameHeaderBytes));
    if (!isOfLog || bigEndian(frame, 16, 4) != sum || bigEndian(frame, 20, 4) != other) damage = at;
  }
  return std::nullopt;
}

}  // namespace perilymph::database
