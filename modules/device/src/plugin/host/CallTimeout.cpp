// SPDX-License-Identifier: BSD-3-Clause
#include "plugin/host/CallTimeout.h"

#include <poll.h>
#include <unistd.h>

#include <csignal>

#include "perilymph/foundation/RealTime.h"
#include "perilymph/realtime/RealTimePriority.h"

namespace perilymph::device::plugin {

namespace {

constexpr int look_ms = 10;
constexpr int looksForCall = 5;  // 50 ms, as the guard of a HID device
// Opening and closing may take long, but not after the program is gone: 2 s.
constexpr int looksForEnd = 200;
constexpr unsigned lastAttempt_s = 1;

}  // namespace

CallTimeout::CallTimeout(Channel& channel) : channel_(channel)
{
  thread_ = std::thread([this] {
    declareThread(ThreadRole::pluginWatch);
    run();
  });
}

CallTimeout::~CallTimeout()
{
  isStopping_ = true;
  thread_.join();
}

void CallTimeout::run() noexcept
{
  // Above the thread that calls the plug-in, so that one that never sleeps is ended, too.
  realtime::requestRealTimePriority(realtime::Rank::tick);
  std::uint64_t calls = 0;
  int looksStuck = 0, looksAlone = 0;
  while (!isStopping_) {
    // Nothing is read here: only the end of the pipe is awaited.
    pollfd program{isAlone_ ? -1 : static_cast<int>(requests), 0, 0};
    ::poll(&program, 1, look_ms);
    if ((program.revents & (POLLHUP | POLLERR)) != 0) isAlone_ = true;
    if (isAlone_) channel_.forHost.ring();
    looksAlone += isAlone_ ? 1 : 0;

    const Function function = channel_.function;
    const bool isFast = function == Function::read || function == Function::write;
    const std::uint64_t now = channel_.calls;
    looksStuck = isFast && now == calls ? looksStuck + 1 : 0;
    calls = now;
    if (looksStuck >= looksForCall) endHung(function);
    if (looksAlone < looksForEnd) continue;
    ::kill(0, SIGKILL);  // with what the plug-in started: nobody else would end it
    ::_exit(abandoned);
  }
}

void CallTimeout::endHung(Function function) noexcept
{
  isDoomed_ = true;
  const Library* const library = library_;
  // A second write would wait for the first one; a read is different, and nothing is left to lose.
  if (function == Function::read && library != nullptr) {
    std::signal(SIGALRM, SIG_DFL);
    ::alarm(lastAttempt_s);  // ends the process if the attempt hangs, too
    PerilymphDeviceWrenchV1 none{};
    none.size = sizeof none;
    library->functions().write(library->device(), &none);
    library->functions().close(library->device());
  }
  if (isAlone_) ::kill(0, SIGKILL);
  ::_exit(function == Function::read ? hungInRead : hungInWrite);
}

}  // namespace perilymph::device::plugin
