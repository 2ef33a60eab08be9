// SPDX-License-Identifier: BSD-3-Clause

// Renames, trashes and restores recordings, with the log of an unclosed one.

#include <string_view>
#include <system_error>

#include "perilymph/session/SessionLibrary.h"

namespace perilymph::session {

namespace {

namespace fs = std::filesystem;

constexpr const char* ending = ".insertion";

Result<void> moveTo(const fs::path& from, const fs::path& to)
{
  std::error_code failure;
  if (fs::exists(to, failure))
    return Error{"%1 exists already in %2. Choose another name.", to.filename(), to.parent_path()};
  // The log first: alone it is useless, but a recording without it loses ticks.
  for (const char* tail : {"-wal", "-shm", ""}) {
    const fs::path part = from.string() + tail;
    if (*tail != '\0' && !fs::exists(part, failure)) continue;
    fs::rename(part, to.string() + tail, failure);
    if (failure)
      return Error{"%1 cannot be moved to %2: %3. Check that you may write into both folders.",
                   from, to, failure.message()};
  }
  return {};
}

/// "20260131T154502Z-P-017": a time of this form, then the scenario's name.
constexpr std::string_view timePattern = "00000000T000000Z-";

bool beginsWithTime(const std::string& name)
{
  if (name.size() <= timePattern.size()) return false;
  for (std::size_t i = 0; i < timePattern.size(); ++i) {
    const bool isDigit = name[i] >= '0' && name[i] <= '9';
    if (timePattern[i] == '0' ? !isDigit : name[i] != timePattern[i]) return false;
  }
  return true;
}

}  // namespace

std::string displayNameOf(const fs::path& file)
{
  const std::string name = file.stem().string();
  return beginsWithTime(name) ? name.substr(timePattern.size()) : name;
}

std::string startedUtcOf(const fs::path& file)
{
  const std::string name = file.stem().string();
  if (!beginsWithTime(name)) return {};
  const auto part = [&name](std::size_t from, std::size_t count) {
    return name.substr(from, count);
  };
  return part(0, 4) + '-' + part(4, 2) + '-' + part(6, 2) + 'T' + part(9, 2) + ':' + part(11, 2) +
         ':' + part(13, 2) + 'Z';
}

Result<fs::path> renameSession(const fs::path& file, const std::string& name)
{
  constexpr std::size_t longest = 120;
  if (name.empty() || name.size() > longest || name.front() == '.' ||
      name.find_first_of("/\\\n\r\t") != std::string::npos || name.find('\0') != std::string::npos)
    return Error{
        "'%1' is not a valid recording name. Use 1–120 characters, no slash, no leading period.",
        name};
  const fs::path renamed = file.parent_path() / (name + ending);
  if (renamed == file) return file;
  if (const auto done = moveTo(file, renamed); !done) return done.error();
  return renamed;
}

Result<fs::path> trashSession(const fs::path& file)
{
  const fs::path trash = file.parent_path() / ".trash";
  std::error_code failure;
  fs::create_directory(trash, failure);
  if (failure)
    return Error{"The folder %1 cannot be made: %2. Nothing was deleted.", trash,
                 failure.message()};
  if (!fs::is_directory(fs::symlink_status(trash, failure)))
    return Error{
        "%1 is not a folder of the library but a link or a file. Nothing was deleted; move it away "
        "first.",
        trash};
  fs::path place = trash / file.filename();
  for (int number = 2; fs::exists(place, failure); ++number)
    place = trash / (file.stem().string() + "-" + std::to_string(number) + ending);
  if (const auto done = moveTo(file, place); !done) return done.error();
  return place;
}

Result<void> restoreSession(const fs::path& trashed, const fs::path& place)
{
  return moveTo(trashed, place);
}

}  // namespace perilymph::session
