// SPDX-License-Identifier: BSD-3-Clause
#include "plugin/PluginFile.h"

#include <elf.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstring>
#include <fstream>

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

}  // namespace

Result<void> checkFile(const std::filesystem::path& file)
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
  struct stat folder {};
  // In a folder with the sticky bit, as /tmp, only its owner may replace a file.
  if (::stat(file.parent_path().c_str(), &folder) == 0 && (folder.st_mode & S_IWOTH) != 0 &&
      (folder.st_mode & S_ISVTX) == 0)
    return Error{
        "every user of this machine may replace it, and it would run with your rights. Take that "
        "right away: chmod o-w %1",
        file.parent_path()};
  if (!isSharedLibrary(file))
    return Error{"it is not a shared library of this machine. Build it, and give the .so file."};
  return {};
}

}  // namespace perilymph::device::plugin
