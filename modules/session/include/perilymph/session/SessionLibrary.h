#pragma once

// The recordings of a folder as a list: each read once, then known by its path, size and time.

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "perilymph/foundation/Result.h"
#include "perilymph/session/Highlights.h"

namespace perilymph::session {

/// One recording in a list.
struct SessionSummary {
  std::filesystem::path file;
  std::uint64_t bytes = 0;
  std::int64_t modified_ns = 0;  ///< Modification time by the file system's clock.
  std::string startedUtc;        ///< "2010-05-17T09:30:00Z".
  std::string scenario, patient, side, array, device, version;
  Highlights highlights;
  bool wasClosed = true;
  bool isBeingRecorded = false;
  std::string error;  ///< One sentence where it cannot be read, or not whole; else empty.
};

/// Everything a list shows of one recording. Never fails: what cannot be read says so in `error`.
///
/// @param shouldStop  Asked some fifty times a second; true ends the reading.
SessionSummary summarize(const std::filesystem::path& file,
                         const std::function<bool()>& shouldStop = {});

/// Told how many recordings of how many are listed, also while one is read; false stops: the rest
/// is left out.
using LibraryProgress = std::function<bool(std::size_t done, std::size_t all)>;

/// Given each recording as soon as it is read, so that one that takes long hides no other.
using LibraryEntry = std::function<void(const SessionSummary&)>;

/// The folder of a library's caches: index and pictures. Whatever is in it may be deleted.
std::filesystem::path libraryCache(const std::filesystem::path& folder);
/// Makes that folder if it is missing. Nothing where it cannot be made, or where there is a link in
/// its place: what it leads to is somebody else's.
std::optional<std::filesystem::path> makeLibraryCache(const std::filesystem::path& folder);

/// Lists the recordings of a folder, newest first. A recording that has not changed since it was
/// last listed is not opened again: its summary is kept in an index beside the recordings, which is
/// made anew whenever it is missing or damaged. Where none can be written, the list only takes
/// longer. Files are read in the order of their names, the last first: those that were named by
/// their time, the newest.
///
/// @param beingRecorded  A file this program is writing: it is listed, but left alone. May be
/// empty.
Result<std::vector<SessionSummary>> listSessions(const std::filesystem::path& folder,
                                                 const std::filesystem::path& beingRecorded = {},
                                                 const LibraryProgress& progress = {},
                                                 const LibraryEntry& listed = {});

/// Gives a recording another name in its folder (without ending).
Result<std::filesystem::path> renameSession(const std::filesystem::path& file,
                                            const std::string& name);
/// Moves a recording into the folder's own trash, where it stays until somebody empties it.
/// @return Where it is now.
Result<std::filesystem::path> trashSession(const std::filesystem::path& file);
/// Puts a recording back to where it was.
Result<Done> restoreSession(const std::filesystem::path& trashed,
                            const std::filesystem::path& place);

}  // namespace perilymph::session
