// SPDX-License-Identifier: BSD-3-Clause

// Opens a database; checks the file before SQLite reads it.

#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <fstream>
#include <stop_token>
#include <string_view>

#include "Companions.h"
#include "Content.h"
#include "perilymph/foundation/AtomicFile.h"

namespace perilymph::database {

namespace {

namespace fs = std::filesystem;

/// Content of the header of a file.
struct FileHeader {
  bool isDatabase = false;
  bool isWhole = true;  ///< The file has the length its header states.
};

std::uint64_t bigEndian(const std::array<unsigned char, 100>& bytes, std::size_t first,
                        std::size_t count)
{
  std::uint64_t value = 0;
  for (std::size_t i = 0; i < count; ++i) value = value << 8 | bytes[first + i];
  return value;
}

/// Reads SQLite's header of 100 bytes (SQLite file format, section 1.3).
FileHeader readHeader(const fs::path& file)
{
  std::array<unsigned char, 100> bytes{};
  std::ifstream stream(file, std::ios::binary);
  stream.read(reinterpret_cast<char*>(bytes.data()), bytes.size());
  constexpr std::string_view magic("SQLite format 3\0", 16);
  FileHeader header;
  const auto got = static_cast<std::size_t>(stream.gcount());
  header.isDatabase =
      got >= magic.size() &&
      std::string_view(reinterpret_cast<const char*>(bytes.data()), magic.size()) == magic;
  if (!header.isDatabase) return header;
  if (got < bytes.size()) {
    header.isWhole = false;
    return header;
  }
  const std::uint64_t pageField = bigEndian(bytes, 16, 2);
  const std::uint64_t pageSize = pageField == 1 ? 65536 : pageField;
  const std::uint64_t pages = bigEndian(bytes, 28, 4);
  std::error_code ignored;
  header.isWhole = fs::file_size(file, ignored) >= pages * pageSize;
  return header;
}

/// Checks with the effective user and group, not the real ones.
bool mayAccess(const fs::path& place, int mode)
{
  return ::faccessat(AT_FDCWD, place.c_str(), mode, AT_EACCESS) == 0;
}

bool mayWrite(const fs::path& file)
{
  const fs::path folder = file.has_parent_path() ? file.parent_path() : fs::path(".");
  return mayAccess(file, W_OK) && mayAccess(folder, W_OK);
}

/// Upper bound of the SQLite instructions that a query over a file of this size needs: a row of
/// about twenty bytes, the smallest of this program, takes ten. A cycle of pages could run forever.
std::int64_t maxInstructionsFor(const fs::path& file)
{
  std::error_code ignored;
  const auto bytes = static_cast<std::int64_t>(fs::file_size(file, ignored));
  return 1'000'000 + 4 * (ignored ? 0 : bytes);
}

/// What is known of a file before SQLite reads it.
struct Inspected {
  fs::path place;  ///< Companion files lie beside the file itself, not beside a link to it.
  FileHeader header;
  Companions companions;
};

Result<Inspected> inspect(const fs::path& file, const FileKind& kind)
{
  const std::string name = file.string();
  std::error_code problem;
  if (fs::is_directory(file, problem)) return Error{"%1 is a folder. %2", name, kind.choice};
  if (!fs::exists(file, problem)) return Error{"%1 does not exist. Check the name.", name};
  if (!mayAccess(file, R_OK)) return Error{"%1 may not be read. Check its permissions.", name};

  Inspected inspected;
  inspected.place = fs::canonical(file, problem);
  if (problem) return Error{"%1 cannot be found: %2.", name, problem.message()};
  if (fs::is_regular_file(inspected.place, problem)) inspected.header = readHeader(inspected.place);
  if (!inspected.header.isDatabase) return Error{"%1 is not %2. %3", name, kind.name, kind.choice};
  const auto companions = companionsOf(inspected.place);
  if (!companions) return companions.error();
  inspected.companions = *companions;
  return inspected;
}

}  // namespace

Result<void> checkNoCompanions(const fs::path& file)
{
  for (const char* ending : {"-wal", "-journal"}) {
    const fs::path companion = file.string() + ending;
    std::error_code ignored;
    if (fs::exists(fs::symlink_status(companion, ignored)))
      return Error{
          "%1 belongs to a file that had the name %2 before, and would spoil a new one. Move it "
          "away, "
          "or choose another name.",
          companion, file.filename()};
  }
  return {};
}

Result<Database> Database::openNew(const fs::path& file)
{
  auto content = std::make_unique<Content>();
  content->file = file;
  std::error_code problem;
  const fs::path place = fs::canonical(file, problem);
  if (problem) return Error{problem.message()};
  if (const auto done = content->open(place, Content::Access::readWrite); !done)
    return done.error();
  return Database(std::move(content));
}

Result<Database> Database::openToAppend(const fs::path& file, const FileKind& kind)
{
  std::error_code ignored;
  if (fs::is_symlink(fs::symlink_status(file, ignored)))
    if (const auto refused = checkWritable(file, Links::refused); !refused) return refused.error();
  const auto inspected = inspect(file, kind);
  if (!inspected) return inspected.error();
  const std::string name = file.string();
  if (!mayWrite(inspected->place))
    return Error{"%1 may not be written. Check its permissions and those of its folder.", name};
  auto content = std::make_unique<Content>();
  content->file = file;
  content->remedy = kind.remedy;
  if (!inspected->header.isWhole && !inspected->companions.hasLog)
    return content->error(Sentence{"it is cut short"});
  if (const auto done = content->open(inspected->place, Content::Access::readWrite); !done)
    return content->error(done.error().message);
  Database database(std::move(content));
  // Taken at once, so that a second writer is refused before it has done any work.
  if (!database.run("PRAGMA locking_mode=EXCLUSIVE; BEGIN IMMEDIATE; COMMIT"))
    return Error{
        "%1 is in use: another program works on it, or it cannot be locked (%2). Wait until that "
        "program has ended.",
        name, database.lastError()};
  if (const auto done = database.content_->check(kind); !done) return done.error();
  return database;
}

Result<Database> Database::open(const fs::path& file, const FileKind& kind, std::stop_token stop)
{
  auto inspected = inspect(file, kind);
  if (!inspected) return inspected.error();
  const auto& [place, header, companions] = *inspected;
  const std::string name = file.string();

  auto content = std::make_unique<Content>();
  content->file = file;
  content->remedy = kind.remedy;
  content->watch->stop = std::move(stop);
  content->watch->maxInstructions = maxInstructionsFor(place);
  if (!header.isWhole && !companions.hasLog) return content->error(Sentence{"it is cut short"});

  const bool isWritable = mayWrite(place);
  if (companions.hasLog && !isWritable)
    content->note = name +
                    " was not closed and lies where nothing may be written, so the ticks in its "
                    "-wal file are not read. Copy both files to a folder you may write to.";
  const auto read = [&, &target = place](Content::Access access) -> Result<void> {
    content->watch->instructions = 0;
    if (const auto done = content->open(target, access); !done)
      return content->error(done.error().message);
    return content->check(kind);
  };
  // Without recovery nothing is written, not even a lock.
  const bool recovers = isWritable && companions.areToRead;
  auto done = read(recovers ? Content::Access::readWrite : Content::Access::immutable);
  // If the disk is too full for recovery, checkpointed content can still be read.
  if (!done && recovers && header.isWhole && !content->watch->wasStopped) {
    if (const auto again = read(Content::Access::immutable); again) {
      done = again;
      content->note =
          name +
          " was not closed and cannot be recovered here, so the ticks in its -wal file are "
          "not read. Make space on the disk, or copy both files to another one.";
    }
  }
  if (!done) return done.error();
  return Database(std::move(content));
}

}  // namespace perilymph::database
