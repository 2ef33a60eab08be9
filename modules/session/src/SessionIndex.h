#pragma once

// The summaries of recordings that were read before, in a database that may be deleted.

#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>

#include "Database.h"
#include "perilymph/session/SessionLibrary.h"

namespace perilymph::session {

/// One thread at a time. Everything it fails at only costs time: recordings are then read again.
class SessionIndex {
public:
  /// Opens the index of a folder and takes it into memory; makes it anew where it is missing,
  /// damaged or of another format.
  explicit SessionIndex(const std::filesystem::path& folder);

  /// What is known of a file that still has this size and time.
  std::optional<SessionSummary> find(const std::string& name, std::uint64_t bytes,
                                     std::int64_t modified_ns) const;
  void keep(const SessionSummary& summary);
  /// Forgets the files that are not there any more.
  void forget(const std::set<std::string>& present);
  /// Writes down what was kept and forgotten.
  void close();

private:
  bool open(const std::filesystem::path& file);
  bool read();

  std::optional<Database> database_;
  std::map<std::string, SessionSummary> known_;
  bool isWriting_ = false;
};

}  // namespace perilymph::session
