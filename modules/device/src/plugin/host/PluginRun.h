// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The exchange between an open plug-in and the program, in the process that hosts the plug-in.

#include <atomic>
#include <cstdint>

#include "plugin/PluginChannel.h"
#include "plugin/PluginLibrary.h"

namespace perilymph::device::plugin {

/// Marks which function of the plug-in runs, for the watch and the program.
class CallGuard {
public:
  CallGuard(Channel& channel, Function function) noexcept : channel_(channel)
  {
    channel_.function = function;
  }
  ~CallGuard()
  {
    channel_.function = Function::none;
    ++channel_.calls;
  }
  CallGuard(const CallGuard&) = delete;
  CallGuard& operator=(const CallGuard&) = delete;

private:
  Channel& channel_;
};

/// Reads the plug-in once per nominal period and writes each force when it arrives. Writes zero if
/// no force arrives for 50 ms or three periods, whichever is longer: then the program is stopped or
/// hangs.
class PluginRun {
public:
  /// @param isAlone  Set when the program is gone. @param isDoomed  Set when a call hung: no
  ///                 further one is made.
  PluginRun(Channel& channel, const Library& library, const std::atomic<bool>& isAlone,
            const std::atomic<bool>& isDoomed) noexcept;

  /// Returns, with the force at zero, once the program asks to close or is gone.
  void run() noexcept;

private:
  void takeForce() noexcept;
  void write(const Force& force) noexcept;
  void read() noexcept;

  Channel& channel_;
  const Library& library_;
  const std::atomic<bool>& isAlone_;
  const std::atomic<bool>& isDoomed_;
  std::int64_t period_;     // [ns]
  std::uint64_t patience_;  // reads without a force
  std::uint64_t readsWithout_ = 0;
  std::uint64_t seen_ = 0;
  bool isPushing_ = false;
  HostedSample newest_;
};

}  // namespace perilymph::device::plugin
