// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Recording of an insertion: one SQLite database, readable at any time, even after a crash.
//
//   meta(key, value)                   scenario, version, device, step: see RecordingFacts
//   block(tick, ticks, packed)         up to 1024 ticks, packed without loss, by the first of them
//   event(tick, time_s, kind, value)   commands, changes of workflow and status, rupture of the
//                                      partition, lost ticks

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>

#include "perilymph/foundation/Result.h"
#include "perilymph/haptics/Snapshot.h"
#include "perilymph/session/RunParameters.h"

namespace perilymph::session {

/// Newest file format that this program writes and reads.
inline constexpr int newestRecordingVersion = 3;

/// Ticks in a full block: a second at 1 kHz. Larger blocks save 2 % more (measured), and showing one
/// tick unpacks its block.
inline constexpr std::size_t blockTicks = 1024;

/// Metadata of a recording. Numbers needed for replay are stored exactly.
struct RecordingFacts {
  std::string scenarioName;
  std::string scenarioText;  ///< Scenario::text.
  std::string device;        ///< DeviceTraits::name.
  double timeStep = 1e-3;    ///< [s]
  RunParameters run;
  double deviceDelay = 0.0;  ///< From a force to the report that shows its effect, measured [s].
  long seed = 1;
  std::uint64_t modelFingerprint = 0;
  std::string version;  ///< Version of the program.
  std::string buildId;
  std::string startedUtc;  ///< "2010-05-17T09:30:00Z".

  /// A script moved the array, not a hand; by the name of device::ScriptedDevice.
  bool isScripted() const { return device == "Scripted insertion"; }
  /// By the name of device::PointerDevice.
  bool isByPointer() const { return device == "Mouse and keyboard"; }
};

/// Writer of a recording. One thread at a time.
class Recording {
public:
  /// Begins a recording in a new file; an existing file is refused, never replaced.
  static Result<std::unique_ptr<Recording>> create(const std::filesystem::path& file,
                                                   const RecordingFacts& facts);
  /// Closes without lost ticks, unless close() was called.
  ~Recording();
  Recording(const Recording&) = delete;
  Recording& operator=(const Recording&) = delete;

  /// Adds ticks in one transaction: after return they survive the end of the process. Those of a few
  /// calls are small blocks, which a full one replaces. On failure none of them is stored. A closed recording is opened again and continued, as when an array is
  /// withdrawn after its insertion.
  Result<void> append(std::span<const haptics::TickRecord> records);

  /// Marks the recording as closed and merges its log into one file, which others may then read,
  /// compare and report.
  ///
  /// @param lostRecords   Ticks that never reached append(); the recording itself counts gaps in
  ///                      the tick numbers, and the larger count is stored.
  /// @param deviceReport  Performance of the device, as JSON (`device_report` in meta); not stored
  ///                      if empty.
  Result<void> close(std::uint64_t lostRecords = 0, const std::string& deviceReport = {});

  /// Closes a recording that may be continued, without waiting for those who read it.
  ///
  /// @return  Whether the log is merged; while it has readers it is not: call again later. Nothing is lost.
  Result<bool> conclude(std::uint64_t lostRecords);

  const std::filesystem::path& file() const noexcept;

private:
  Recording();
  struct Content;
  std::unique_ptr<Content> content_;
};

/// Names of the status bits: "forceClamped rampingIn"; empty if none is set.
std::string statusText(std::uint32_t status);
/// "idle", "armed", ...
std::string workflowWord(haptics::Workflow workflow);

}  // namespace perilymph::session
