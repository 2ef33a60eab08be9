// SPDX-License-Identifier: BSD-3-Clause
#include "recording/RecordingFormat.h"

#include "perilymph/session/Csv.h"
#include "perilymph/session/Recording.h"

namespace perilymph::session {

const database::FileKind& recordingKind()
{
  static const database::FileKind kind = [] {
    const std::string meta = "CREATE TABLE meta(key TEXT PRIMARY KEY, value TEXT NOT NULL)";
    const std::string event =
        "CREATE TABLE event(tick INTEGER NOT NULL, time_s REAL, kind TEXT NOT NULL, value)";
    std::string columns;
    for (const char* name : recordedNames) columns += std::string(", ") + name + " REAL";
    database::FileKind recording{
        Sentence{"a recording of Perilymph"},
        Sentence{"Choose an .insertion file."},
        Sentence{"Use another copy of the recording."},
        0x506c796d,  // "Plym"
        newestRecordingVersion,
        {meta,
         "CREATE TABLE block(tick INTEGER PRIMARY KEY, ticks INTEGER NOT NULL, "
         "packed BLOB NOT NULL)",
         event}};
    recording.tablesSince = firstVersionWithBlocks;
    recording.formerTables = {
        meta, "CREATE TABLE tick(tick INTEGER PRIMARY KEY" + columns + ", record BLOB NOT NULL)",
        event};
    recording.lasting = {
        "SELECT key, value FROM meta WHERE key IN ('scenario_name','scenario','device','seed',"
        "'model_fingerprint','version','build_id','started_utc') ORDER BY key",
        "SELECT tick, time_s, kind, value FROM event ORDER BY rowid",
        "SELECT tick, packed FROM block WHERE ticks = " + std::to_string(blockTicks) +
            " ORDER BY tick",
        "SELECT tick, record FROM tick ORDER BY tick"};
    return recording;
  }();
  return kind;
}

}  // namespace perilymph::session
