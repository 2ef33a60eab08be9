// SPDX-License-Identifier: BSD-3-Clause
#include "OwnFilesOnly.h"

#include <sqlite3.h>

#include <string_view>

namespace perilymph::database {

namespace {

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

int openNoJournal(sqlite3_vfs* vfs, const char* name, sqlite3_file* file, int flags, int* outFlags)
{
  file->pMethods = nullptr;
  if (flags & SQLITE_OPEN_MAIN_JOURNAL) return SQLITE_CANTOPEN;
  return openOwn(vfs, name, file, flags, outFlags);
}

int accessNoJournal(sqlite3_vfs*, const char* name, int flags, int* result)
{
  *result = 0;
  if (std::string_view(name).ends_with("-journal")) return SQLITE_OK;
  return systemVfs()->xAccess(systemVfs(), name, flags, result);
}

/// All other functions are those of the system's VFS.
sqlite3_vfs derived(const char* name, decltype(sqlite3_vfs::xOpen) open,
                    decltype(sqlite3_vfs::xAccess) access)
{
  sqlite3_vfs copy = *systemVfs();
  copy.pNext = nullptr;
  copy.zName = name;
  copy.xOpen = open;
  copy.xAccess = access;
  return copy;
}

}  // namespace

const char* ownFilesOnly()
{
  static sqlite3_vfs vfs = derived("perilymph-own-files-only", openOwn, systemVfs()->xAccess);
  static const int registered = sqlite3_vfs_register(&vfs, 0);
  return registered == SQLITE_OK ? vfs.zName : nullptr;
}

const char* withoutJournals()
{
  static sqlite3_vfs vfs = derived("perilymph-without-journals", openNoJournal, accessNoJournal);
  static const int registered = sqlite3_vfs_register(&vfs, 0);
  return registered == SQLITE_OK ? vfs.zName : nullptr;
}

}  // namespace perilymph::database
