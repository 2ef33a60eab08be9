// SPDX-License-Identifier: BSD-3-Clause
#include "Companions.h"

#include <array>
#include <fstream>
#include <string>

namespace perilymph::database {

namespace {

namespace fs = std::filesystem;

/// Last bytes of a journal that names a further file.
constexpr std::array<unsigned char, 8> journalMagic = {0xd9, 0xd5, 0x05, 0xf9,
                                                       0x20, 0xa1, 0x63, 0xd7};

bool namesFurtherFile(const fs::path& journal)
{
  std::ifstream stream(journal, std::ios::binary);
  stream.seekg(-static_cast<std::streamoff>(journalMagic.size()), std::ios::end);
  std::array<unsigned char, journalMagic.size()> last{};
  stream.read(reinterpret_cast<char*>(last.data()), last.size());
  // A journal with only a header ends in zeros: SQLite pads it to a sector.
  return stream.gcount() == static_cast<std::streamsize>(last.size()) && last == journalMagic;
}

}  // namespace

Result<Companions> companionsOf(const fs::path& database)
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
    if (ending == "-journal" && namesFurtherFile(companion))
      return refused("names a further file, which no file of Perilymph does");
    if (ending == "-wal") found.hasLog = fs::file_size(companion, ignored) > 0;
    if (ending != "-shm") found.areToRead = true;
  }
  return found;
}

}  // namespace perilymph::database
