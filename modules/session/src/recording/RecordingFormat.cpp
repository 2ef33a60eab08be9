// SPDX-License-Identifier: BSD-3-Clause
#include "recording/RecordingFormat.h"

#include "perilymph/session/Csv.h"
#include "perilymph/session/Recording.h"

namespace perilymph::session {

const database::FileKind& recordingKind()
{
  static const database::FileKind kind = [] {
    std::string columns;
    for (const char* name : recordedNames) columns += std::string(", ") + name + " REAL";
    return database::FileKind{
        Sentence{"a recording of Perilymph"},
        Sentence{"Choose an .insertion file."},
        Sentence{"Use another copy of the recording."},
        0x506c796d,  // "Plym"
        newestRecordingVersion,
        {"CREATE TABLE meta(key TEXT PRIMARY KEY, value TEXT NOT NULL)",
         "CREATE TABLE tick(tick INTEGER PRIMARY KEY" + columns + ", record BLOB NOT NULL)",
         "CREATE TABLE event(tick INTEGER NOT NULL, time_s REAL, kind TEXT NOT NULL, value)"}};
  }();
  return kind;
}

}  // namespace perilymph::session
