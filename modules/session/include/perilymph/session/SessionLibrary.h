// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// List of the recordings in a folder: each is read once, then cached by path, size and time.

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "perilymph/foundation/Result.h"
#include "perilymph/session/Highlights.h"

namespace perilymph::session {

/// The entities named in a scenario's text.
struct ScenarioSubject {
  std::string patient, side, array, technique;
  std::string cochlea;  ///< Equal for equal cochleae, regardless of the ear.
  Sentence error;       ///< Why the text cannot be replayed; else empty.
};

/// From the text alone, so that a recording whose array was removed from the catalog can be listed.
///
/// @param name  For error messages.
ScenarioSubject subjectOf(const std::string& text, const std::string& name);

/// One recording in a list.
struct SessionSummary {
  std::filesystem::path file;
  std::uint64_t bytes = 0;
  std::int64_t modified_ns = 0;  ///< Modification time from the file system.
  std::string startedUtc;        ///< "2010-05-17T09:30:00Z".
  std::string scenario, patient, side, array, device, version;
  std::string technique;  ///< "standard" or "aos"; see nameOf(Technique).
  Highlights highlights;
  bool wasClosed = true;
  bool isBeingRecorded = false;
  Sentence error;  ///< Why it cannot be read, is incomplete or is no insertion; else empty.
};

/// Whether a recording is one of an insertion, which can be replayed, compared and reported: its writing
/// has ended, and the array moved in it. Others are left where the program ended before an insertion
/// began, or cannot be read; `error` states which.
bool isInsertion(const SessionSummary& summary) noexcept;

/// Summarizes one recording. Never fails: errors are reported in `error`.
///
/// @param stop  Ends reading early, with an error.
SessionSummary summarize(const std::filesystem::path& file, const std::stop_token& stop = {});

/// Receives the number of listed recordings and of all recordings, before each of them.
using LibraryProgress = std::function<void(std::size_t done, std::size_t all)>;

/// Receives each recording as soon as it is read, so that a slow one does not delay the others.
using LibraryEntry = std::function<void(const SessionSummary&)>;

/// The cache folder of a library: index and pictures. Its content may be deleted.
std::filesystem::path libraryCache(const std::filesystem::path& folder);
/// Creates that folder if it is missing. Empty if it cannot be created, or if there is a link in
/// its place: the link's target is not ours.
std::optional<std::filesystem::path> makeLibraryCache(const std::filesystem::path& folder);

/// Lists the recordings of a folder, newest first. A recording unchanged since it was last listed
/// is not opened again: its summary is in an index beside the recordings, which is rebuilt if it is
/// missing or damaged. Without a writable index, listing only takes longer. Files are read in
/// descending order of their names: for names with a time, newest first.
///
/// @param beingRecorded  A file this program is writing: it is listed but not read. May be empty.
/// @param stop           Ends the listing early: the rest is omitted.
Result<std::vector<SessionSummary>> listSessions(const std::filesystem::path& folder,
                                                 const std::filesystem::path& beingRecorded = {},
                                                 const LibraryProgress& progress = {},
                                                 const LibraryEntry& listed = {},
                                                 const std::stop_token& stop = {});

/// Name of a recording for display: that of its file without extension, and without the time with
/// which automatic names begin.
std::string displayNameOf(const std::filesystem::path& file);
/// The time with which an automatic name begins, as "2026-01-31T15:45:02Z"; empty for other names.
std::string startedUtcOf(const std::filesystem::path& file);

/// Renames a recording in its folder (name without extension).
Result<std::filesystem::path> renameSession(const std::filesystem::path& file,
                                            const std::string& name);
/// Moves a recording into the folder's own trash, which is never emptied automatically.
///
/// @return Its new path.
Result<std::filesystem::path> trashSession(const std::filesystem::path& file);
/// Moves a recording from the trash to its previous path.
Result<void> restoreSession(const std::filesystem::path& trashed,
                            const std::filesystem::path& place);

}  // namespace perilymph::session
