// SPDX-License-Identifier: BSD-3-Clause
#include "guard/CompanionProcess.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <ctime>

#include "perilymph/foundation/Program.h"

namespace perilymph::device {

namespace fs = std::filesystem;

OwnedFile::~OwnedFile()
{
  if (file_ >= 0) ::close(file_);
}

fs::path companionProgram(const char* name)
{
  std::error_code failure;
  const fs::path folder = fs::read_symlink("/proc/self/exe", failure).parent_path();
  for (const char* place : {".", "../libexec/perilymph", "../../bin"}) {
    fs::path program = (folder / place / name).lexically_normal();
    if (::access(program.c_str(), X_OK) == 0) return program;
  }
  return {};
}

pid_t startCompanion(const ChildCommand& call)
{
  const OwnedFile nowhere(::open("/dev/null", O_WRONLY | O_CLOEXEC));
  const int output =
      call.output == CompanionOutput::nowhere ? nowhere.get() : static_cast<int>(STDERR_FILENO);
  ProgramCall started{call.program.string(), call.arguments, call.files, true};
  for (const int stream : {STDOUT_FILENO, STDERR_FILENO})
    started.files.emplace_back(output, stream);
  const auto id = startProgram(started);
  return id ? *id : 0;
}

bool say(const OwnedFile& pipe, std::uint8_t letter) noexcept
{
  sigset_t broken, before;
  ::sigemptyset(&broken);
  ::sigaddset(&broken, SIGPIPE);
  ::pthread_sigmask(SIG_BLOCK, &broken, &before);
  const bool isSaid = ::write(pipe.get(), &letter, 1) == 1;
  if (!isSaid && errno == EPIPE) {
    const timespec now{};
    ::sigtimedwait(&broken, nullptr, &now);
  }
  ::pthread_sigmask(SIG_SETMASK, &before, nullptr);
  return isSaid;
}

void endCompanion(pid_t id, int patience_ms) noexcept
{
  const OwnedFile life(static_cast<int>(::syscall(SYS_pidfd_open, id, 0)));
  pollfd end{life.get(), POLLIN, 0};
  if (life.get() >= 0 && ::poll(&end, 1, patience_ms) <= 0) ::kill(id, SIGKILL);
  // A process blocked in a write exits when the write returns; do not wait for it.
  ::waitpid(id, nullptr, life.get() >= 0 ? WNOHANG : 0);
}

}  // namespace perilymph::device
