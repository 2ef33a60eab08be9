#pragma once

// The summaries of recordings that were read before, in a file that may be deleted.

#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>

#include "perilymph/session/SessionLibrary.h"

namespace perilymph::session {

/// A JSON file in the library's cache, read at once and replaced at once. Whatever fails only costs
/// time: recordings are then read again. One thread at a time.
class SessionIndex {
public:
  /// Reads the index of a folder; empty where it is missing, damaged or of another format.
  explicit SessionIndex(const std::filesystem::path& folder);

  /// The summary of a file that still has this size and time.
  std::optional<SessionSummary> find(const std::string& name, std::uint64_t bytes,
                                     std::int64_t modified_ns) const;
  void keep(const SessionSummary& summary);
  /// Forgets the files that are not there any more.
  void forget(const std::set<std::string>& present);
  /// Writes the index, if it has changed.
  void close();

private:
  void read();

  std::filesystem::path file_;  ///< Empty where the folder can have no cache.
  std::map<std::string, SessionSummary> known_;
  bool hasChanged_ = false;
};

}  // namespace perilymph::session
