// SPDX-License-Identifier: BSD-3-Clause
#include "guard/CompanionProcess.h"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <ctime>

namespace perilymph::device {

namespace {

namespace fs = std::filesystem;

constexpr int firstFreeFile = 10;  // above the descriptors that a companion uses

}  // namespace

OwnedFile::~OwnedFile()
{
  if (file_ >= 0) ::close(file_);
}

OwnedFile OwnedFile::copyForCompanion() const noexcept
{
  return OwnedFile(::fcntl(file_, F_DUPFD_CLOEXEC, firstFreeFile));
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

pid_t startCompanion(const CompanionCall& call)
{
  posix_spawn_file_actions_t actions;
  posix_spawnattr_t attributes;
  if (::posix_spawn_file_actions_init(&actions) != 0) return 0;
  ::posix_spawnattr_init(&attributes);
  ::posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSID);
  if (call.output == CompanionOutput::nowhere)
    ::posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
  ::posix_spawn_file_actions_adddup2(&actions, STDERR_FILENO, STDOUT_FILENO);
  for (const auto& [here, there] : call.files)
    ::posix_spawn_file_actions_adddup2(&actions, here, there);

  std::vector<std::string> texts{call.program.filename().string()};
  texts.insert(texts.end(), call.arguments.begin(), call.arguments.end());
  std::vector<char*> pointers;
  for (std::string& text : texts) pointers.push_back(text.data());
  pointers.push_back(nullptr);
  pid_t id = 0;
  const int failure =
      ::posix_spawn(&id, call.program.c_str(), &actions, &attributes, pointers.data(), environ);
  ::posix_spawnattr_destroy(&attributes);
  ::posix_spawn_file_actions_destroy(&actions);
  return failure == 0 ? id : 0;
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
