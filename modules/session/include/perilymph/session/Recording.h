#pragma once

// An insertion being written down: one SQLite database, readable at any moment, even after a crash.
//
//   meta(key, value)                   scenario, version, device, step: see RecordingFacts
//   tick(tick, <columns>, record)      one row a tick: columns to read, and a BLOB for replay
//   event(tick, time_s, kind, value)   commands taken, changes of workflow and status, losses

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>

#include "perilymph/foundation/Result.h"
#include "perilymph/haptics/Snapshot.h"
#include "perilymph/session/RunParameters.h"

namespace perilymph::session {

/// Newest format of the file that this program writes and reads.
inline constexpr int newestRecordingVersion = 2;

/// What a recording says about itself. Numbers that replay needs are kept to the last bit.
struct RecordingFacts {
  std::string scenarioName;
  std::string scenarioText;  ///< Scenario::text.
  std::string device;        ///< DeviceTraits::name.
  double timeStep = 1e-3;    ///< [s]
  RunParameters run;
  double deviceDelay = 0.0;  ///< From a force to the report that shows it, measured [s].
  long seed = 1;
  std::uint64_t modelFingerprint = 0;
  std::string version;  ///< Version of the program.
  std::string buildId;
  std::string startedUtc;  ///< "2010-05-17T09:30:00Z".
};

/// The writing end. One thread at a time.
class Recording {
public:
  /// Begins a recording in a new file; a file that is there already is refused, never replaced.
  static Result<std::unique_ptr<Recording>> create(const std::filesystem::path& file,
                                                   const RecordingFacts& facts);
  /// Closes as if nothing had been lost, unless close() was called.
  ~Recording();
  Recording(const Recording&) = delete;
  Recording& operator=(const Recording&) = delete;

  /// Adds ticks in one transaction: after a return they survive the end of the process. On failure
  /// none of them is kept.
  Result<Done> append(std::span<const haptics::TickRecord> records);

  /// Marks the recording as closed properly and folds it into one file.
  ///
  /// @param lostRecords  Ticks that never came to append(); gaps in the numbers of the ticks are
  ///                     counted by the recording itself, the larger count is kept.
  /// @param deviceReport  How the device did, as JSON (`device_report` in meta); empty: nothing
  /// kept.
  Result<Done> close(std::uint64_t lostRecords = 0, const std::string& deviceReport = {});

  const std::filesystem::path& file() const noexcept;

private:
  Recording();
  struct Content;
  std::unique_ptr<Content> content_;
};

/// A status as words: "forceClamped rampingIn"; empty when all is well.
std::string statusText(std::uint32_t status);
/// "idle", "armed", ...
std::string workflowWord(haptics::Workflow workflow);

}  // namespace perilymph::session
