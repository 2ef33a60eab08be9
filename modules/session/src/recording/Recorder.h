// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Transfers ticks from the loop's channel to a recording: on a thread of its own by the clock, or
// in the caller's thread in virtual time. File errors never affect the insertion.

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "perilymph/haptics/HapticLoop.h"
#include "perilymph/session/Recording.h"

namespace perilymph::session {

class Recorder {
public:
  /// @param recording  Null: records are discarded, so that the channel never fills.
  Recorder(haptics::HapticLoop& loop, std::unique_ptr<Recording> recording, double timeStep);
  ~Recorder();  ///< Stops and closes the recording.
  Recorder(const Recorder&) = delete;
  Recorder& operator=(const Recorder&) = delete;

  // --- by the clock ---
  /// Starts the recorder thread, which drains every 20 ms.
  void start();
  /// Ends the thread; remaining records are stored. The loop must have stopped.
  void stop() noexcept;

  /// Closes the recording within a drain, while the loop continues: it can then be read as a whole. A
  /// tick that follows opens it again. Any thread.
  ///
  /// @param lostRecords  Records that the loop has lost so far.
  void conclude(std::uint64_t lostRecords) noexcept;
  /// The recording is closed, and no tick has followed. Any thread.
  bool isConcluded() const noexcept { return isConcluded_; }

  // --- virtual time, while no thread runs ---
  /// Adds one record; committed together with the others of its 20 ms.
  void keep(const haptics::TickRecord& record);
  /// Commits the added records.
  void flush();

  /// Sets the device report that closing stores. Only while nothing runs.
  void describeDevice(std::string report) { deviceReport_ = std::move(report); }

  /// Flushes and closes the recording. Nothing is recorded afterwards.
  void close() noexcept;

  /// Why recording stopped; empty if there is no error. Any thread.
  Sentence error() const;

private:
  void run(const std::stop_token& stop);
  void drain();
  void concludeIfRequested();
  void setError(const Sentence& sentence);

  haptics::HapticLoop& loop_;
  std::unique_ptr<Recording> recording_;
  std::string deviceReport_;
  std::size_t batch_;
  static constexpr std::int64_t notRequested = -1;
  std::atomic<std::int64_t> lostAtConclusion_{notRequested};
  std::atomic<bool> isConcluded_{false};
  std::vector<haptics::TickRecord> waiting_;
  mutable std::mutex errorMutex_;
  Sentence error_;
  std::mutex sleepMutex_;
  std::condition_variable_any sleep_;
  std::jthread thread_;
};

}  // namespace perilymph::session
