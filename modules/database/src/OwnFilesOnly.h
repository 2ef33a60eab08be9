// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// A SQLite VFS that blocks an attack by a forged journal.

namespace perilymph::database {

/// Name of a SQLite VFS that opens no super-journal. A rollback journal may name any file as the
/// journal of several databases; SQLite would read that file for further names and then delete it
/// (SQLite file format, section 3). No database of this program has one. Registered at the first
/// call.
const char* ownFilesOnly();

/// Name of one that sees no journal, either: a file of this program needs none to be read
/// (Companions.h), and SQLite would take that of another file for its own.
const char* withoutJournals();

}  // namespace perilymph::database
