// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The thread of a device whose exchange waits for the device.

#include <atomic>
#include <thread>

#include "DeviceLink.h"

namespace perilymph::plugin {

/// How an exchange ended.
enum class Answer {
  fresh,   ///< A sample came.
  silent,  ///< None came in time; the device may answer later.
  lost,    ///< The device is gone.
};

/// Exchanges a force for a sample once per millisecond, or as fast as the device answers if that
/// takes longer. After an exchange that took longer than `patience` its sample is dropped, and the
/// next force is zero. The last force is zero, however it ends.
///
/// The thread inherits the real-time priority of the thread that starts it, if that was granted.
class ServoThread {
public:
  ~ServoThread() { stop(); }

  /// @param exchange  Answer(Vector force_D [N], Sample&): sends the force, calls link.noteSent(), and
  ///                  fills the sample. Must return within a fraction of a second.
  template <class Exchange>
  void start(DeviceLink& link, Exchange exchange)
  {
    isStopping_ = false;
    link.reset();
    thread_ = std::thread([this, &link, exchange] { run(link, exchange); });
  }

  /// Returns after the last force, zero, was sent.
  void stop() noexcept
  {
    isStopping_ = true;
    if (thread_.joinable()) thread_.join();
  }

private:
  static constexpr std::int64_t period = 1'000'000;     // [ns]
  static constexpr std::int64_t patience = 20'000'000;  // [ns]; the program's is 3 to 30 ms

  template <class Exchange>
  void run(DeviceLink& link, const Exchange& exchange) noexcept
  {
    std::int64_t due = now();
    Answer answer = Answer::fresh;
    Sample sample;
    while (!isStopping_ && answer != Answer::lost) {
      const std::int64_t began = now();
      answer = exchange(link.force(), sample);
      if (answer == Answer::fresh && now() - began > patience) answer = Answer::silent;
      if (answer == Answer::fresh) link.deliver(sample);
      if (answer == Answer::silent) link.noteSilence();
      due = std::max(due + period, now());
      const timespec time{due / 1'000'000'000, due % 1'000'000'000};
      ::clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &time, nullptr);
    }
    // Also to a lost device: some still take what they cannot answer.
    if (answer == Answer::lost) link.lose();
    exchange({}, sample);
  }

  std::atomic<bool> isStopping_{false};
  std::thread thread_;
};

}  // namespace perilymph::plugin
