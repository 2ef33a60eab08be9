// SPDX-License-Identifier: BSD-3-Clause
#include "Interruption.h"

#include <unistd.h>

#include <csignal>
#include <initializer_list>
#include <stop_token>
#include <string_view>

#include "perilymph/foundation/AtomicFile.h"
#include "perilymph/foundation/SignalsAtStart.h"

namespace perilymph::cli {

namespace {

constexpr unsigned grace_s = 3;  // longer than any insertion of a validation takes

volatile std::sig_atomic_t wasRequested = 0;

// Handlers call nothing but what signal-safety(7) allows.
extern "C" void endNow(int)
{
  constexpr std::string_view sentence = "Interrupted; nothing half-written is left.\n";
  removeUnfinishedFiles();
  [[maybe_unused]] const ssize_t written = ::write(STDERR_FILENO, sentence.data(), sentence.size());
  ::_exit(1);
}

void handle(int signal, void (*handler)(int))
{
  struct sigaction action = {};
  action.sa_handler = handler;
  sigemptyset(&action.sa_mask);
  sigaction(signal, &action, nullptr);
}

constexpr std::initializer_list<int> ends = {SIGINT, SIGTERM, SIGHUP};

extern "C" void askForEnd(int)
{
  if (wasRequested != 0) endNow(0);
  wasRequested = 1;
  handle(SIGALRM, endNow);
  ::alarm(grace_s);
}

void handleEnds(void (*handler)(int))
{
  sigset_t handled;
  sigemptyset(&handled);
  for (const int signal : ends) {
    if (wasIgnoredAtStart(signal)) {
      handle(signal, SIG_IGN);
      continue;
    }
    handle(signal, handler);
    sigaddset(&handled, signal);
  }
  // A caller that blocks signals, such as a service, leaves them blocked in its child processes.
  pthread_sigmask(SIG_UNBLOCK, &handled, nullptr);
}

std::stop_source& interruption()
{
  static std::stop_source source;
  return source;
}

}  // namespace

void endOnInterruption() { handleEnds(endNow); }

std::stop_token watchForInterruption()
{
  handleEnds(askForEnd);
  return interruption().get_token();
}

bool isInterrupted()
{
  if (wasRequested == 0) return false;
  interruption().request_stop();
  return true;
}

}  // namespace perilymph::cli
