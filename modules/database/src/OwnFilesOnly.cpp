// SPDX-License-Identifier: BSD-3-Clause
#include "OwnFilesOnly.h"

#include <sqlite3.h>

namespace perilymph::database {

namespace {

constexpr const char* vfsName = "perilymph-own-files-only";

sqlite3_vfs* systemVfs()
{
  static sqlite3_vfs* const vfs = sqlite3_vfs_find(nullptr);
  return vfs;
}

int openOwn(sqlite3_vfs*, const char* name, sqlite3_file* file, int flags, int* outFlags)
{
  file->pMethods = nullptr;
  if (flags & SQLITE_OPEN_SUPER_JOURNAL) return SQLITE_CANTOPEN;
  return systemVfs()->xOpen(systemVfs(), name, file, flags, outFlags);
}

}  // namespace

const char* ownFilesOnly()
{
  // Only opening differs: all other functions are those of the system's VFS.
  static sqlite3_vfs vfs = [] {
    sqlite3_vfs copy = *systemVfs();
    copy.pNext = nullptr;
    copy.zName = vfsName;
    copy.xOpen = openOwn;
    return copy;
  }();
  static const int registered = sqlite3_vfs_register(&vfs, 0);
  return registered == SQLITE_OK ? vfsName : nullptr;
}

}  // namespace perilymph::database
