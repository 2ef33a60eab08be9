// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The process that hosts a device plug-in, as seen by the program.

#include <atomic>
#include <filesystem>
#include <memory>
#include <stop_token>
#include <string>

#include "guard/CompanionProcess.h"
#include "perilymph/foundation/Result.h"
#include "perilymph/foundation/Units.h"
#include "plugin/PluginChannel.h"

namespace perilymph::device::plugin {

/// A running host. One thread at a time, if nothing else is stated: the UI thread, or a worker that
/// lists plug-ins.
class PluginProcess {
public:
  /// Starts a host, which begins to load the library.
  ///
  /// @param library   Absolute path.
  /// @return The error continues "The plug-in is not taken:".
  static Result<std::unique_ptr<PluginProcess>> start(const std::filesystem::path& library);
  /// Waits until the library is loaded. The error continues "The plug-in is not taken:".
  ///
  /// @param patience  After which it is given up, and ended.
  /// @param stop      Ends it earlier.
  Result<void> load(Duration patience, const std::stop_token& stop = {});
  ~PluginProcess();  ///< Ends the host, at the latest by SIGKILL.
  PluginProcess(const PluginProcess&) = delete;
  PluginProcess& operator=(const PluginProcess&) = delete;

  /// The traits stated by the plug-in, unchecked.
  const PerilymphDeviceTraitsV1& traits() const noexcept { return traits_; }

  /// Opens the device; waits 30 s at most. Then the exchange runs until close().
  Result<void> open(Duration patience, const std::stop_token& stop = {});
  /// Sets the force to zero and closes the device; kills a host that does not answer within 2 s.
  void close() noexcept;

  Channel& channel() noexcept { return *channel_; }

  /// The process has ended. Any thread; real-time safe.
  bool hasEnded() const noexcept;
  /// Kills the process and those it started, so that the system closes the device's file. Any thread;
  /// real-time safe.
  void kill() noexcept;
  /// The same for those that a host which ended left behind.
  void killGroup() noexcept;

  /// A sentence: how the process ended, or that it was killed; empty while it runs.
  std::string obituary() const;

private:
  PluginProcess(std::string name, pid_t id, OwnedFile requests, OwnedFile replies,
                Channel* channel) noexcept;
  /// @param tooSlow  The sentence for a host that does not answer, with the seconds since it was asked.
  Result<Reply> await(Duration patience, Phrase tooSlow, const std::stop_token& stop);

  std::string name_;
  pid_t id_;
  OwnedFile life_;  // becomes readable when the process ends
  OwnedFile requests_, replies_;
  Channel* channel_;
  PerilymphDeviceTraitsV1 traits_{};
  std::int64_t asked_;  // when it was last asked for something: to load, to open [ns]
  std::atomic<bool> isKilled_{false};
};

}  // namespace perilymph::device::plugin
