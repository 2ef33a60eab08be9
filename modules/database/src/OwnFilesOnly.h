#pragma once

// SQLite's access to the file system, less what a forged journal could make of it.

namespace perilymph::database {

/// Name of a VFS of SQLite that opens no super-journal. A rollback journal may name any file as the
/// journal of several databases; SQLite would read that file for further names and then delete it
/// (its file format, section 3). No database of ours has one. Registered at the first call.
const char* ownFilesOnly();

}  // namespace perilymph::database
