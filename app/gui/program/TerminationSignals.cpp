// SPDX-License-Identifier: BSD-3-Clause
#include "gui/program/TerminationSignals.h"

#include <fcntl.h>
#include <signal.h>
#include <unistd.h>

#include <QSocketNotifier>
#include <array>
#include <atomic>
#include <cerrno>

#include "perilymph/foundation/SignalsAtStart.h"

namespace perilymph::gui {

namespace {

constexpr std::array terminating{SIGTERM, SIGINT, SIGHUP};

// A pipe: a signal handler may write to a file descriptor, and do little else.
std::array<int, 2> channel{-1, -1};

static_assert(std::atomic<int>::is_always_lock_free);
std::atomic<int> writingEnd{-1};

bool isOurs(int signal);

extern "C" void tellWindow(int signal)
{
  const int before = errno;
  for (const int each : terminating)
    if (isOurs(each)) ::signal(each, SIG_DFL);
  const auto number = static_cast<unsigned char>(signal);
  if (::write(writingEnd, &number, 1) != 1) ::raise(signal);  // now with default action
  errno = before;
}

/// Whether a signal is handled here: neither ignored nor with default action. Any thread;
/// async-signal-safe.
bool isOurs(int signal)
{
  struct sigaction now = {};
  return ::sigaction(signal, nullptr, &now) == 0 && now.sa_handler == tellWindow;
}

}  // namespace

TerminationSignals::TerminationSignals(QObject* parent) : QObject(parent)
{
  if (::pipe2(channel.data(), O_CLOEXEC | O_NONBLOCK) != 0) return;  // the default action remains
  writingEnd = channel[1];
  notifier_ = new QSocketNotifier(channel[0], QSocketNotifier::Read, this);
  connect(notifier_, &QSocketNotifier::activated, this, [this] { read(); });

  struct sigaction action = {};
  action.sa_handler = tellWindow;
  sigfillset(&action.sa_mask);
  action.sa_flags = SA_RESTART;
  for (const int signal : terminating) {
    if (wasIgnoredAtStart(signal))
      ::signal(signal, SIG_IGN);
    else
      ::sigaction(signal, &action, nullptr);
  }
}

TerminationSignals::~TerminationSignals()
{
  for (const int signal : terminating)
    if (isOurs(signal)) ::signal(signal, SIG_DFL);
  writingEnd = -1;
  for (const int end : channel)
    if (end >= 0) ::close(end);
  channel = {-1, -1};
}

void TerminationSignals::read()
{
  unsigned char number = 0;
  if (::read(channel[0], &number, 1) == 1) Q_EMIT received(number);
}

}  // namespace perilymph::gui
