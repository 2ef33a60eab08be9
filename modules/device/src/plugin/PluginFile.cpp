// SPDX-License-Identifier: BSD-3-Clause
#include "plugin/PluginFile.h"

#include <elf.h>
#include <pwd.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstring>
#include <fstream>
#include <string>

namespace perilymph::device::plugin {

namespace {

/// Whether the file begins as a shared library of this machine's word size (ELF, gABI chapter 4).
bool isSharedLibrary(const std::filesystem::path& file)
{
  Elf64_Ehdr head{};
  std::ifstream stream(file, std::ios::binary);
  stream.read(reinterpret_cast<char*>(&head), sizeof head);
  return stream && std::memcmp(head.e_ident, ELFMAG, SELFMAG) == 0 &&
         head.e_ident[EI_CLASS] == ELFCLASS64 && head.e_type == ET_DYN;
}

namespace fs = std::filesystem;

/// Whose files may run with this user's rights: the owner of this program could change that.
bool isTrusted(uid_t owner)
{
  static const uid_t ownersOfProgram = [] {
    struct stat program {};
    return ::stat("/proc/self/exe", &program) == 0 ? program.st_uid : uid_t{0};
  }();
  return owner == 0 || owner == ::geteuid() || owner == ownersOfProgram;
}

std::string nameOf(uid_t owner)
{
  const passwd* entry = ::getpwuid(owner);
  return entry != nullptr ? entry->pw_name : "user " + std::to_string(owner);
}

/// Checks a folder and all above it.
Result<void> checkFolders(fs::path folder)
{
  for (;; folder = folder.parent_path()) {
    struct stat found {};
    if (::stat(folder.c_str(), &found) != 0) return {};
    // In a folder with the sticky bit, as /tmp, only its owner may replace a file.
    if ((found.st_mode & S_IWOTH) != 0 && (found.st_mode & S_ISVTX) == 0)
      return Error{
          "every user of this machine may replace it, and it would run with your rights. Take that "
          "right away: chmod o-w %1",
          folder};
    if (!isTrusted(found.st_uid))
      return Error{
          "%1 may replace it, because the folder %2 is theirs, and it would run with your rights. "
          "Copy it to a folder of your own.",
          nameOf(found.st_uid), folder};
    if (folder == folder.parent_path()) return {};
  }
}

}  // namespace

Result<fs::path> checkedFile(const fs::path& file)
{
  struct stat found {};
  if (::stat(file.c_str(), &found) != 0) return Error{"there is no such file. Check the path."};
  if (!S_ISREG(found.st_mode)) return Error{"it is not a file. Give the path of its library."};
  if (::access(file.c_str(), R_OK) != 0)
    return Error{"you may not read it. Give yourself the right: chmod u+r %1", file};
  if ((found.st_mode & S_IWOTH) != 0)
    return Error{
        "every user of this machine may change it, and it would run with your rights. Take that "
        "right away: chmod o-w %1",
        file};
  if (!isTrusted(found.st_uid))
    return Error{
        "%1 may change it, because it is theirs, and it would run with your rights. Copy it to a "
        "folder of your own.",
        nameOf(found.st_uid)};
  std::error_code failure;
  const fs::path library = fs::canonical(file, failure);
  if (failure) return Error{"there is no such file. Check the path."};
  // Who may replace a link on the way may replace the file, too.
  const fs::path named = fs::absolute(file, failure).lexically_normal();
  for (const fs::path& place : {named, library})
    if (const auto checked = checkFolders(place.parent_path()); !checked) return checked.error();
  if (!isSharedLibrary(file))
    return Error{"it is not a shared library of this machine. Build it, and give the .so file."};
  return library;
}

}  // namespace perilymph::device::plugin
