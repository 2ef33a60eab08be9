// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/foundation/FileIdentity.h"

#include <sys/stat.h>

#include <algorithm>
#include <system_error>
#include <utility>

namespace perilymph {
namespace {

namespace fs = std::filesystem;

/// Resolves a chain of symbolic links, up to the kernel's maximum length.
fs::path targetOf(fs::path file)
{
  constexpr int maxLinks = 40;  // Linux follows 40 (path_resolution(7))
  std::error_code failure;
  for (int i = 0; i < maxLinks && fs::is_symlink(file, failure); ++i) {
    const fs::path target = fs::read_symlink(file, failure);
    if (failure) break;
    fs::path next = target.is_absolute() ? target : file.parent_path() / target;
    // An open pipe in /proc/self/fd is a link whose text names no file.
    if (fs::exists(file, failure) && !fs::exists(next, failure)) break;
    file = std::move(next);
  }
  return file;
}

}  // namespace

FileIdentity identityOf(const fs::path& file)
{
  FileIdentity identity;
  std::error_code failure;
  const fs::path target = fs::absolute(targetOf(file), failure);
  const fs::path folder = fs::weakly_canonical(target.parent_path(), failure);
  identity.place = (failure ? target : folder / target.filename()).lexically_normal();
  struct stat status = {};
  if (::stat(identity.place.c_str(), &status) != 0) return identity;
  identity.device = status.st_dev;
  identity.inode = status.st_ino;
  return identity;
}

bool isSameFile(const FileIdentity& one, const FileIdentity& other)
{
  if (one.inode != 0 && other.inode != 0)
    return one.device == other.device && one.inode == other.inode;
  return one.place == other.place;
}

bool isExistingBelow(const fs::path& file, const fs::path& folder)
{
  std::error_code failed;
  const fs::path found = fs::canonical(file, failed);
  if (failed) return false;
  const fs::path around = fs::canonical(folder, failed);
  if (failed) return false;
  return std::mismatch(around.begin(), around.end(), found.begin(), found.end()).first ==
         around.end();
}

}  // namespace perilymph
