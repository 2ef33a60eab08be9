// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Ends the process that hosts a plug-in if a call of the plug-in does not return.

#include <atomic>
#include <thread>

#include "plugin/PluginChannel.h"
#include "plugin/PluginLibrary.h"

namespace perilymph::device::plugin {

/// A thread that looks every 10 ms whether the plug-in's calls return and whether the program is
/// still there. A call of read or write that runs at five looks has hung: looks are counted, so
/// that a process that was stopped as a whole has not. Then the process ends, which closes the
/// device's file; after read also with a last attempt to write zero and to close the device.
class CallTimeout {
public:
  explicit CallTimeout(Channel& channel);
  ~CallTimeout();
  CallTimeout(const CallTimeout&) = delete;
  CallTimeout& operator=(const CallTimeout&) = delete;

  /// The plug-in to take the force from; null: none is loaded.
  void watch(const Library* library) noexcept { library_ = library; }

  /// The program is gone.
  const std::atomic<bool>& isAlone() const noexcept { return isAlone_; }
  /// A call hung; the process is about to end.
  const std::atomic<bool>& isDoomed() const noexcept { return isDoomed_; }

private:
  void run() noexcept;
  [[noreturn]] void endHung(Function function) noexcept;

  Channel& channel_;
  std::atomic<const Library*> library_{nullptr};
  std::atomic<bool> isAlone_{false}, isDoomed_{false}, isStopping_{false};
  std::thread thread_;
};

}  // namespace perilymph::device::plugin
