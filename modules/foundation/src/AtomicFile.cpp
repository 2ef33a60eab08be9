// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/foundation/AtomicFile.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdint>
#include <exception>
#include <optional>

#include "Descriptor.h"
#include "UnfinishedName.h"
#include "perilymph/foundation/FileIdentity.h"
#include "perilymph/foundation/Unfinished.h"

namespace perilymph {
namespace {

namespace fs = std::filesystem;

bool writeAll(int descriptor, std::string_view content)
{
  while (!content.empty()) {
    const ssize_t written = ::write(descriptor, content.data(), content.size());
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return false;
    content.remove_prefix(static_cast<std::size_t>(written));
  }
  return true;
}

Error cannotWrite(const fs::path& file, const std::string& why)
{
  return Error{"Cannot write %1: %2", file, why};
}

bool isLink(const fs::path& file)
{
  std::error_code ignored;
  return fs::is_symlink(fs::symlink_status(file, ignored));
}

/// The file to be replaced: the target of a symbolic link that is followed, so that it is kept.
fs::path placeOf(const fs::path& file, Links links)
{
  return links == Links::followed && isLink(file) ? identityOf(file).place : file;
}

/// True for a pipe, a terminal or /dev/null, which are written directly.
bool isStream(const fs::path& place)
{
  std::error_code ignored;
  const fs::file_status status = fs::status(place, ignored);
  return fs::exists(status) && !fs::is_regular_file(status) && !fs::is_directory(status);
}

/// True for an existing file that its owner made read-only, which applies to the superuser too, and
/// for one that this process may not write.
bool isWriteProtected(const fs::path& place)
{
  struct stat status = {};
  if (::stat(place.c_str(), &status) != 0) return false;
  const bool isMarked = (status.st_mode & (S_IWUSR | S_IWGRP | S_IWOTH)) == 0;
  return isMarked || ::faccessat(AT_FDCWD, place.c_str(), W_OK, AT_EACCESS) != 0;
}

/// Why a file cannot be created at a path, as far as it is known before writing.
std::optional<Error> obstacle(const fs::path& file, const fs::path& place)
{
  std::error_code ignored;
  if (isLink(place))
    return cannotWrite(file,
                       "it is a link, which may lead out of its folder. Remove it, or give another "
                       "folder.");
  if (!place.has_filename()) return cannotWrite(file, "this names no file. Give a file name.");
  if (fs::is_directory(place, ignored))
    return cannotWrite(file, "it is a folder. Give the name of a file in it.");
  const fs::path folder = place.has_parent_path() ? place.parent_path() : fs::path(".");
  if (!fs::exists(folder, ignored))
    return cannotWrite(file, "the folder " + folder.string() + " does not exist. Create it first.");
  if (!fs::is_directory(folder, ignored))
    return cannotWrite(file, folder.string() + " is not a folder. Choose another place.");
  if (isWriteProtected(place))
    return cannotWrite(file,
                       "it exists and is read-only. Choose another name, or make it writable.");
  return std::nullopt;
}

/// A new, empty temporary file in the same folder, with the same extension; removed unless it is
/// kept.
class Neighbor {
public:
  Neighbor(const fs::path& place, Audience audience)
  {
    const mode_t mode = audience == Audience::owner ? 0600 : 0666;
    for (int attempt = 0; attempt < 1000; ++attempt) {
      path_ = unfinishedPath(place);
      name_.keep(path_);
      descriptor_ = ::open(path_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, mode);
      if (descriptor_ >= 0 || errno != EEXIST) break;
    }
    errorNumber_ = descriptor_ >= 0 ? 0 : errno;
  }
  ~Neighbor()
  {
    std::error_code ignored;
    if (errorNumber_ == 0 && !isKept_) fs::remove(path_, ignored);
  }
  Neighbor(const Neighbor&) = delete;
  Neighbor& operator=(const Neighbor&) = delete;

  int errorNumber() const { return errorNumber_; }
  const fs::path& path() const { return path_; }

  /// Descriptor of the empty file, closed by the caller.
  int descriptor() const { return descriptor_; }

  /// Renames the file to its final path, with the permissions of an older one unless it is for its
  /// owner; 0 or an error number.
  int moveTo(const fs::path& place, const Writing& how)
  {
    struct stat older = {};
    if (how.audience != Audience::owner && ::lstat(place.c_str(), &older) == 0 &&
        S_ISREG(older.st_mode))
      ::chmod(path_.c_str(), older.st_mode & 07777);
    int failure = 0;
    if (how.existing == Existing::refused)
      failure = giveNewName(path_, place);
    else if (::rename(path_.c_str(), place.c_str()) != 0)
      failure = errno;
    isKept_ = failure == 0;
    return failure;
  }

private:
  fs::path path_;
  UnfinishedName name_;
  int descriptor_ = -1;
  int errorNumber_ = 0;
  bool isKept_ = false;
};

Result<void> writeStream(const fs::path& file, std::string_view content)
{
  Descriptor stream(::open(file.c_str(), O_WRONLY | O_CLOEXEC));
  if (!stream || !writeAll(stream.number(), content) || !stream.close())
    return cannotWrite(file, reason(errno) + ".");
  return {};
}

/// Runs a library's writer; an exception counts as failure and supplies the message.
std::optional<std::string> failureOf(const std::function<bool(const fs::path&)>& write,
                                     const fs::path& path)
{
  try {
    if (write(path)) return std::nullopt;
  } catch (const std::exception& exception) {
    return std::string(exception.what()) + ".";
  } catch (...) {
  }
  return "the content could not be written. Check that the disk has room.";
}

}  // namespace

Result<void> checkWritable(const fs::path& file, Links links)
{
  const fs::path place = placeOf(file, links);
  if (!isLink(place) && isStream(place)) return {};
  if (const auto error = obstacle(file, place)) return *error;
  const fs::path folder = place.has_parent_path() ? place.parent_path() : fs::path(".");
  if (::faccessat(AT_FDCWD, folder.c_str(), W_OK, AT_EACCESS) != 0)
    return cannotWrite(
        file, "nothing may be written into " + folder.string() + ". Choose another folder.");
  return {};
}

Result<void> writeWhole(const fs::path& file, std::string_view content, const Writing& how)
{
  const fs::path place = placeOf(file, how.links);
  if (!isLink(place) && isStream(place)) return writeStream(place, content);
  if (const auto error = obstacle(file, place)) return *error;

  Neighbor neighbor(place, how.audience);
  if (neighbor.errorNumber() != 0)
    return cannotWrite(file, reason(neighbor.errorNumber()) + " in its folder.");
  Descriptor descriptor(neighbor.descriptor());
  if (!writeAll(descriptor.number(), content) || ::fsync(descriptor.number()) != 0 ||
      !descriptor.close())
    return cannotWrite(file, reason(errno) + ".");
  if (const int failure = neighbor.moveTo(place, how))
    return cannotWrite(file, reason(failure) + ".");
  return {};
}

Result<void> writeWhole(const fs::path& file, const std::function<bool(const fs::path&)>& write,
                        const Writing& how)
{
  const fs::path place = placeOf(file, how.links);
  if (!isLink(place) && isStream(place)) {
    if (const auto failure = failureOf(write, place)) return cannotWrite(file, *failure);
    return {};
  }
  if (const auto error = obstacle(file, place)) return *error;

  Neighbor neighbor(place, how.audience);
  if (neighbor.errorNumber() != 0)
    return cannotWrite(file, reason(neighbor.errorNumber()) + " in its folder.");
  Descriptor(neighbor.descriptor()).close();
  if (const auto failure = failureOf(write, neighbor.path())) return cannotWrite(file, *failure);

  // The library may have closed its file without flushing it to the disk.
  Descriptor written(::open(neighbor.path().c_str(), O_RDONLY | O_CLOEXEC));
  if (!written || ::fsync(written.number()) != 0) return cannotWrite(file, reason(errno) + ".");
  if (const int failure = neighbor.moveTo(place, how))
    return cannotWrite(file, reason(failure) + ".");
  return {};
}

void removeUnfinishedFiles() noexcept { UnfinishedName::removeAll(); }

Result<std::string> readWhole(const fs::path& file, std::size_t maxBytes)
{
  const auto cannotRead = [&file](const std::string& why) {
    return Error{"Cannot read %1: %2", file, why};
  };
  if (file.empty()) return Error{"No file is named. Give the path of a file."};
  // Without O_NONBLOCK, opening a pipe would block until it has a writer.
  const Descriptor descriptor(::open(file.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY));
  if (!descriptor && errno == ENOENT) return cannotRead("there is no such file. Check the path.");
  if (!descriptor) return cannotRead(reason(errno) + ". Check its permissions.");
  // Query the descriptor, not the path, which may name another file by now.
  struct stat status = {};
  if (::fstat(descriptor.number(), &status) != 0) return cannotRead(reason(errno) + ".");
  if (S_ISDIR(status.st_mode)) return cannotRead("it is a folder. Give the name of a file in it.");
  if (!S_ISREG(status.st_mode))
    return cannotRead("it is a pipe or a device, not a file. Give the name of a file.");

  std::string content;
  const auto isTooLarge = [&](std::uintmax_t bytes) { return bytes > maxBytes; };
  const Error tooLarge = cannotRead("it is larger than " + std::to_string(maxBytes >> 20) +
                                    " MiB, the most such a file may have here. Check that it is "
                                    "the right file.");
  if (isTooLarge(static_cast<std::uintmax_t>(status.st_size))) return tooLarge;
  char block[65536];
  while (true) {
    const ssize_t count = ::read(descriptor.number(), block, sizeof block);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return cannotRead(reason(errno) + ".");
    if (count == 0) return content;
    content.append(block, static_cast<std::size_t>(count));
    if (isTooLarge(content.size())) return tooLarge;  // the file grows, or belongs to /proc
  }
}

}  // namespace perilymph
