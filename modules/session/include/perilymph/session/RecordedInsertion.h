// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Reading of a recorded insertion.

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <stop_token>
#include <string>

#include "perilymph/foundation/Result.h"
#include "perilymph/haptics/Snapshot.h"
#include "perilymph/session/Highlights.h"
#include "perilymph/session/Recording.h"

namespace perilymph::session {

/// Result of the integrity check of a recording.
struct RecordingCheck {
  std::uint64_t ticks = 0;         ///< In the file.
  std::uint64_t missingTicks = 0;  ///< Missing between those in the file, as stated by the
                                   ///< recording.
  bool hasHash = false;            ///< False in recordings of format 1.
  /// Empty, or the first inconsistency: counts, columns that differ from their record, events that
  /// do not follow from the ticks, the hash of the content.
  std::string damage;
};

/// A sentence about a recording that was changed after it was recorded, or carries no seal; empty for
/// an intact one.
std::string noteOn(const RecordingCheck& check, const std::filesystem::path& file);

/// Reader of an `.insertion` file.
class RecordedInsertion {
public:
  /// Opens a recording. One that was not closed is recovered with its `-wal` file; in a read-only
  /// folder only checkpointed content can be read, which note() states. All that is read is of one
  /// state of the file, also while it is being written.
  ///
  /// @param stop  Ends this and all later reads, with an error.
  static Result<RecordedInsertion> open(const std::filesystem::path& file,
                                        std::stop_token stop = {});
  RecordedInsertion(RecordedInsertion&&) noexcept;
  RecordedInsertion& operator=(RecordedInsertion&&) noexcept;
  ~RecordedInsertion();

  const RecordingFacts& facts() const noexcept;
  std::uint64_t ticks() const;        ///< Rows in the file, counted individually.
  std::uint64_t lostRecords() const;  ///< Ticks that ran but are not in the file.
  bool wasClosed() const noexcept;    ///< False after a crash, or during recording.
  /// Not closed, and another connection has it open: most likely that which writes it.
  bool isBeingWritten() const noexcept;
  const std::string& note() const noexcept;  ///< A sentence about content that could not be read,
                                             ///< or empty.

  /// Leaves out all ticks after this one from now on, because they cannot be read.
  void endAfter(std::uint64_t lastTick) noexcept;

  /// Key figures of the insertion: as stored when the recording was closed, else computed from the
  /// ticks.
  Result<Highlights> highlights() const;

  /// Reads the whole file and checks its consistency. An error if a row cannot be read.
  Result<RecordingCheck> check() const;

  /// Calls `each` for every tick in order, from a given one on; `each` returns false to stop.
  Result<void> forEach(const std::function<bool(const haptics::TickRecord&)>& each,
                       std::uint64_t firstTick = 0) const;

private:
  RecordedInsertion();
  struct Content;
  std::unique_ptr<Content> content_;
};

}  // namespace perilymph::session
