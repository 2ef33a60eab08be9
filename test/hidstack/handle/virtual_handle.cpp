// SPDX-License-Identifier: BSD-3-Clause

// Simulates a force-feedback handle for the kernel: virtual_handle SCRIPT LOG

#include <poll.h>
#include <sched.h>
#include <sys/mman.h>
#include <sys/timerfd.h>
#include <unistd.h>

#include <iostream>
#include <string>

#include "HandleReports.h"
#include "TickLog.h"
#include "UhidDevice.h"
#include "VirtualHandle.h"
#include "perilymph/realtime/Pacer.h"

namespace {

using namespace perilymph;
using namespace perilymph::hidstack;

constexpr std::int64_t period = 1'000'000;  // [ns]
// Higher than every thread of the host side, like hardware.
constexpr int priority = 90;

/// A periodic timer on the monotonic clock, for poll().
class TickClock {
public:
  TickClock()
      : file_(::timerfd_create(CLOCK_MONOTONIC, TFD_CLOEXEC)),
        due_(realtime::monotonicNanoseconds())
  {
    due_ += period;
    itimerspec grid{};
    grid.it_value = {due_ / 1'000'000'000, due_ % 1'000'000'000};
    grid.it_interval = {0, period};
    ::timerfd_settime(file_, TFD_TIMER_ABSTIME, &grid, nullptr);
  }
  ~TickClock() { ::close(file_); }
  TickClock(const TickClock&) = delete;
  TickClock& operator=(const TickClock&) = delete;

  int file() const { return file_; }
  std::uint64_t missed() const { return missed_; }
  /// Due time of the tick that poll() returned for [ns].
  std::int64_t take()
  {
    std::uint64_t beats = 0;
    if (::read(file_, &beats, sizeof beats) != sizeof beats || beats == 0) return due_;
    const std::int64_t struck = due_ + static_cast<std::int64_t>(beats - 1) * period;
    missed_ += beats - 1;
    due_ = struck + period;
    return struck;
  }

private:
  int file_;
  std::int64_t due_;  // the next tick [ns]
  std::uint64_t missed_ = 0;
};

/// Connects or disconnects according to the script.
Result<void> follow(Wire wire, UhidDevice& device)
{
  if (wire == Wire::unplugged) device.unplug();
  if (wire == Wire::unplugged || device.isPlugged()) return {};
  return device.plug("Perilymph virtual handle", vendor, product, reportDescriptor());
}

/// Handles all pending events of the kernel.
void listen(UhidDevice& device, VirtualHandle& handle)
{
  std::span<const std::uint8_t> bytes;
  for (UhidEvent event = UhidEvent::other; event != UhidEvent::nothing;) {
    event = device.take(bytes);
    if (event == UhidEvent::featureSet || event == UhidEvent::featureRequested) device.refuse();
    if (event != UhidEvent::output) continue;
    if (const auto report = decodeOutput(bytes))
      handle.take(*report, realtime::monotonicNanoseconds());
    if (handle.wire() == Wire::answering) device.send(handle.answer());
  }
}

Result<void> play(VirtualHandle& handle, TickClock& beat)
{
  UhidDevice device;
  while (true) {
    pollfd waits[2] = {{beat.file(), POLLIN, 0}, {device.file(), POLLIN, 0}};
    if (::poll(waits, device.isPlugged() ? 2 : 1, -1) < 0) continue;
    if (device.isPlugged() && (waits[1].revents & POLLIN) != 0) listen(device, handle);
    if ((waits[0].revents & POLLIN) == 0) continue;
    if (!handle.tick(beat.take())) return {};
    if (const auto followed = follow(handle.wire(), device); !followed) return followed;
    for (int i = 0; i < handle.reportsDue(); ++i)
      if (device.send(handle.report())) handle.noteSent(realtime::monotonicNanoseconds());
  }
}

}  // namespace

int main(int count, char** text)
{
  if (count != 3) {
    std::cerr << "virtual_handle needs the name of a script and of a file for its log.\n";
    return 2;
  }
  const auto script = scriptNamed(text[1]);
  if (!script) {
    std::cerr << script.error().message << '\n';
    return 2;
  }
  sched_param wanted{};
  wanted.sched_priority = priority;
  if (::sched_setscheduler(0, SCHED_FIFO, &wanted) != 0 ||
      ::mlockall(MCL_CURRENT | MCL_FUTURE) != 0)
    std::cout << "note: the virtual handle runs without real-time priority\n";

  VirtualHandle handle(*script, HandleBody{});
  TickClock beat;
  if (const auto played = play(handle, beat); !played) {
    std::cerr << played.error().message << '\n';
    return 1;
  }
  if (beat.missed() > 0)
    std::cout << "note: the virtual handle missed " << beat.missed() << " beats\n";
  if (const auto written = write(text[2], handle.ticks()); !written) {
    std::cerr << written.error().message << '\n';
    return 1;
  }
  return 0;
}
