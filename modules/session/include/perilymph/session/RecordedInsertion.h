#pragma once

// An insertion that was written down, to be read.

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>

#include "perilymph/foundation/Result.h"
#include "perilymph/haptics/Snapshot.h"
#include "perilymph/session/Highlights.h"
#include "perilymph/session/Recording.h"

namespace perilymph::session {

/// Whether a recording holds what was recorded.
struct RecordingCheck {
  std::uint64_t ticks = 0;         ///< In the file.
  std::uint64_t missingTicks = 0;  ///< Between those in the file; the recording says so itself.
  bool hasHash = false;            ///< False in recordings of version 1.
  /// Empty, or what is not as it was recorded: counts, columns that differ from their record,
  /// events that do not follow from the ticks, the hash over everything.
  std::string damage;
};

/// The reading end of an `.insertion` file.
class RecordedInsertion {
public:
  /// Opens a recording. One that was not closed is recovered with its `-wal` file; where the folder
  /// is read-only, only what had been folded into the file can be read, and note() says so.
  ///
  /// @param shouldStop  Asked some fifty times a second by this call and all that read later; true
  ///                    ends them with an error.
  static Result<RecordedInsertion> open(const std::filesystem::path& file,
                                        std::function<bool()> shouldStop = {});
  RecordedInsertion(RecordedInsertion&&) noexcept;
  RecordedInsertion& operator=(RecordedInsertion&&) noexcept;
  ~RecordedInsertion();

  const RecordingFacts& facts() const noexcept;
  std::uint64_t ticks() const;               ///< Rows in the file, counted one by one.
  std::uint64_t lostRecords() const;         ///< Ticks that ran but are not in the file.
  bool wasClosed() const noexcept;           ///< False after a crash, or while it is being written.
  const std::string& note() const noexcept;  ///< A sentence about what could not be read, or empty.

  /// What the insertion was like in a few numbers: as noted when the recording was closed, else
  /// found among the ticks.
  Result<Highlights> highlights() const;

  /// Reads the whole file and compares it with itself. An error where a row cannot be read.
  Result<RecordingCheck> check() const;

  /// Shows every tick in its order, from one on; `each` stops by giving false.
  Result<Done> forEach(const std::function<bool(const haptics::TickRecord&)>& each,
                       std::uint64_t firstTick = 0) const;

private:
  RecordedInsertion();
  struct Content;
  std::unique_ptr<Content> content_;
};

}  // namespace perilymph::session
