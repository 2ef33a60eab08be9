// SPDX-License-Identifier: BSD-3-Clause
#include "UntrustedRead.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <fstream>
#include <stop_token>
#include <string>

namespace perilymph::imaging {
namespace {

constexpr std::chrono::seconds timeLimit{60};
constexpr int pollInterval_ms = 100;

/// Bytes of private memory that this process has now, as counted by RLIMIT_DATA; 0 if unknown.
rlim_t dataBytes()
{
  std::ifstream status("/proc/self/status");
  std::string word;
  while (status >> word)
    if (word == "VmData:") {
      rlim_t kilobytes = 0;
      status >> kilobytes;
      return 1024 * kilobytes;
    }
  return 0;
}

/// The child: works without output and without a core file, and ends.
[[noreturn]] void runChild(const std::function<int()>& work, const ChildLimits& limits)
{
  const rlimit none = {0, 0};
  ::setrlimit(RLIMIT_CORE, &none);
  for (const int signal : {SIGABRT, SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGINT, SIGTERM, SIGHUP})
    std::signal(signal, SIG_DFL);
  const int nothing = ::open("/dev/null", O_RDWR);
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) ::dup2(nothing, stream);
  int status = childFailed;
  try {
    if (limits.memory) {
      const rlim_t bytes = dataBytes() + *limits.memory;
      const rlimit memory = {bytes, bytes};
      ::setrlimit(RLIMIT_DATA, &memory);
    }
    status = work();
  } catch (...) {
    status = childFailed;
  }
  ::_exit(status);
}

/// Exit status of a child, whose end closes the pipe; `childFailed` where it was ended by a signal or
/// cannot be asked; empty where it was killed because it took too long or was canceled.
std::optional<int> statusOf(::pid_t child, int pipe, const std::stop_token& stop,
                            std::chrono::milliseconds longest)
{
  const auto start = std::chrono::steady_clock::now();
  pollfd watched = {pipe, POLLIN, 0};
  int status = 0;
  ::pid_t ended = 0;
  while (ended == 0 && std::chrono::steady_clock::now() - start < longest) {
    if (stop.stop_requested()) break;
    // Another process may hold the pipe open, so that its silence says nothing.
    const bool isClosed = ::poll(&watched, 1, pollInterval_ms) > 0;
    ended = ::waitpid(child, &status, isClosed ? 0 : WNOHANG);
    if (ended < 0 && errno == EINTR) ended = 0;
  }
  if (ended == child) return WIFEXITED(status) ? WEXITSTATUS(status) : childFailed;
  if (ended != 0) return childFailed;
  ::kill(child, SIGKILL);
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) continue;
  return std::nullopt;
}

std::optional<int> runOnce(const std::function<int()>& work, const ChildLimits& limits,
                           std::chrono::milliseconds longest)
{
  std::array<int, 2> ends{};
  if (::pipe2(ends.data(), O_CLOEXEC) != 0) return childFailed;
  const ::pid_t child = ::fork();
  if (child == 0) runChild(work, limits);
  ::close(ends[1]);
  const std::optional<int> status =
      child > 0 ? statusOf(child, ends[0], limits.stop, longest) : childFailed;
  ::close(ends[0]);
  return status;
}

}  // namespace

int runInChild(const std::function<int()>& work, const ChildLimits& limits)
{
  if (limits.patience) {
    const std::optional<int> status = runOnce(work, limits, *limits.patience);
    if (status) return *status;
    if (limits.stop.stop_requested()) return childFailed;
  }
  return runOnce(work, limits, timeLimit).value_or(childFailed);
}

}  // namespace perilymph::imaging
