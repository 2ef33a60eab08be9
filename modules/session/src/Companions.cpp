#include "Companions.h"

#include <array>
#include <fstream>
#include <string>

namespace perilymph::session {

namespace {

namespace fs = std::filesystem;

/// Ends a journal that names a further file.
constexpr std::array<unsigned char, 8> journalMagic = {0xd9, 0xd5, 0x05, 0xf9,
                                                       0x20, 0xa1, 0x63, 0xd7};

bool namesFurtherFile(const fs::path& journal)
{
  std::ifstream stream(journal, std::ios::binary);
  stream.seekg(-static_cast<std::streamoff>(journalMagic.size()), std::ios::end);
  std::array<unsigned char, journalMagic.size()> last{};
  stream.read(reinterpret_cast<char*>(last.data()), last.size());
  // A header alone ends in zeros: SQLite pads it to a sector.
  return stream.gcount() == static_cast<std::streamsize>(last.size()) && last == journalMagic;
}

}  // namespace

Result<Companions> companionsOf(const fs::path& recording)
{
  Companions found;
  for (const char* ending : {"-wal", "-journal", "-shm"}) {
    const fs::path companion = recording.string() + ending;
    std::error_code ignored;
    const fs::file_status status = fs::symlink_status(companion, ignored);
    if (status.type() == fs::file_type::not_found || status.type() == fs::file_type::none) continue;
    if (status.type() != fs::file_type::regular)
      return Error{companion.string() + " is not a file but " +
                   (fs::is_symlink(status) ? "a link" : "something else") +
                   ", so the recording beside it is not opened. Copy " +
                   recording.filename().string() + " alone to another folder."};
    found.hasLog =
        found.hasLog || (std::string(ending) == "-wal" && fs::file_size(companion, ignored) > 0);
    found.areToRead = found.areToRead || std::string(ending) != "-shm";
    if (std::string(ending) == "-journal" && namesFurtherFile(companion))
      return Error{companion.string() +
                   " names a further file, which no recording does, so the recording beside it is "
                   "not opened. Copy " +
                   recording.filename().string() + " alone to another folder."};
  }
  return found;
}

}  // namespace perilymph::session
