// A program of its own that outlives the one that holds a haptic device, by a moment:
//
//   perilymph-device-guard    started by that program with the files of GuardScript.h
//
// It waits for the other's end. If that comes without a goodbye (a crash, a kill, an abort), it
// sends the reports that take the force away and switch the actuators off. If the other merely
// stands still while the device pushes (stopped in a terminal, frozen), it sends those of no force.

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

/// All bytes or nothing, however many pieces they come in.
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
  // A device that refuses one may still take the next: nobody is left to be told.
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

/// Nothing that ends its neighbors may end it, nothing of theirs is kept open by it.
void standApart()
{
  for (const int signal : {SIGHUP, SIGINT, SIGQUIT, SIGTERM, SIGPIPE, SIGTSTP, SIGTTIN, SIGTTOU})
    ::signal(signal, SIG_IGN);
  ::close_range(guard::pulse + 1, ~0u, 0);
  if (::chdir("/") != 0) return;
  // First when it is needed. Without the right to it, it comes when it is its turn.
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

    // The pulse: a force that stands, and nobody who renews it.
    const std::uint64_t now = pulse->forces;
    looksWithout = now == forces ? looksWithout + 1 : 0;
    forces = now;
    if (looksWithout == looksAPatience && pulse->isPushing != 0)
      send(script, 0, script.noForceLines());
  }
}
