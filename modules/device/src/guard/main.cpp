// SPDX-License-Identifier: BSD-3-Clause

// A separate process that briefly outlives the one that uses a haptic device:
//
//   perilymph-device-guard    started by that program with the files of GuardScript.h
//
// It waits for the end of that process. If it ends without goodbye (a crash, a kill, an abort), the
// guard sends the reports that remove the force and switch the actuators off. If it is only stopped
// while the device renders a force (stopped in a terminal, frozen), the guard sends the reports of
// no force.

#include <fcntl.h>
#include <linux/hidraw.h>
#include <poll.h>
#include <sched.h>
#include <sys/ioctl.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>

#include "guard/GuardScript.h"

namespace {

using namespace perilymph::device;

constexpr int looksAPatience = 3;

/// Reads the whole buffer or fails, however many pieces arrive.
bool readWhole(std::span<std::uint8_t> buffer)
{
  while (!buffer.empty()) {
    const ssize_t count = ::read(guard::wire, buffer.data(), buffer.size());
    if (count <= 0) return false;
    buffer = buffer.subspan(static_cast<std::size_t>(count));
  }
  return true;
}

bool readScript(guard::Script& script)
{
  static std::array<std::uint8_t, guard::Script::capacity> buffer;
  if (!readWhole(std::span(buffer).first(guard::Script::head))) return false;
  const std::size_t behind = guard::Script::sizeBehind(buffer);
  const auto whole = std::span(buffer).first(guard::Script::head + behind);
  return behind > 0 && readWhole(whole.subspan(guard::Script::head)) && script.take(whole);
}

void send(const guard::Line& line)
{
  // A device that refuses one report may accept the next; errors cannot be reported.
  if (line.isFeature) {
    auto* const bytes = const_cast<std::uint8_t*>(line.bytes.data());  // the ioctl only reads it
    ::ioctl(guard::device, HIDIOCSFEATURE(line.bytes.size()), bytes);
  } else if (::write(guard::device, line.bytes.data(), line.bytes.size()) < 0) {
    return;
  }
}

void send(const guard::Script& script, std::size_t first, std::size_t end)
{
  for (std::size_t i = first; i < end; ++i) send(script.line(i));
}

/// Detaches the process: signals of its group do not end it, and it keeps no file of the group
/// open.
void standApart()
{
  for (const int signal : {SIGHUP, SIGINT, SIGQUIT, SIGTERM, SIGPIPE, SIGTSTP, SIGTTIN, SIGTTOU})
    ::signal(signal, SIG_IGN);
  ::close_range(guard::pulse + 1, ~0u, 0);
  if (::chdir("/") != 0) return;
  // Real-time priority if permitted, else normal priority.
  sched_param wanted{};
  wanted.sched_priority = 40;  // below the haptic thread and the writer
  ::sched_setscheduler(0, SCHED_FIFO, &wanted);
  ::mlockall(MCL_CURRENT);
}

}  // namespace

int main()
{
  standApart();
  static guard::Script script;
  if (!readScript(script)) return 1;
  void* const memory =
      ::mmap(nullptr, sizeof(guard::Pulse), PROT_READ, MAP_SHARED, guard::pulse, 0);
  const auto* const pulse =
      memory == MAP_FAILED ? nullptr : static_cast<const guard::Pulse*>(memory);

  const int patience_ms = script.patience_ms();
  const bool isWatching = pulse != nullptr && patience_ms > 0;
  const int look_ms = isWatching ? std::max(1, patience_ms / looksAPatience) : -1;
  std::uint64_t forces = 0;
  int looksWithout = 0;
  while (true) {
    pollfd waits{guard::wire, POLLIN, 0};
    const int woken = ::poll(&waits, 1, look_ms);
    if (woken > 0) {
      std::uint8_t word = 0;
      const bool isOrderly = ::read(guard::wire, &word, 1) == 1 && word == guard::goodbye;
      if (!isOrderly) send(script, 0, script.lines());
      return 0;
    }
    if (woken < 0 || !isWatching) continue;

    // The pulse: a force is rendered and not renewed.
    const std::uint64_t now = pulse->forces;
    looksWithout = now == forces ? looksWithout + 1 : 0;
    forces = now;
    if (looksWithout == looksAPatience && pulse->isPushing != 0)
      send(script, 0, script.noForceLines());
  }
}
