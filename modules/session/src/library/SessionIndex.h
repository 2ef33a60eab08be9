// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Cached summaries of recordings, in a file that may be deleted.

#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>

#include "perilymph/session/SessionLibrary.h"

namespace perilymph::session {

/// A JSON file in the library's cache, read and replaced as a whole. Errors only cost time:
/// recordings are then read again. One thread at a time.
class SessionIndex {
public:
  /// Reads the index of a folder; empty if it is missing, damaged or of another format.
  explicit SessionIndex(const std::filesystem::path& folder);

  /// The summary of a file, if its size and time are unchanged.
  std::optional<SessionSummary> find(const std::string& name, std::uint64_t bytes,
                                     std::int64_t modified_ns) const;
  void keep(const SessionSummary& summary);
  /// Removes the files that no longer exist.
  void removeAbsent(const std::set<std::string>& present);
  /// Writes the index if it has changed.
  void close();

private:
  void read();

  std::filesystem::path file_;  ///< Empty if the folder can have no cache.
  std::map<std::string, SessionSummary> known_;
  bool hasChanged_ = false;
};

}  // namespace perilymph::session
