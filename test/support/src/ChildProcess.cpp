// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/test/ChildProcess.h"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <condition_variable>
#include <csignal>
#include <cstring>
#include <initializer_list>
#include <mutex>
#include <system_error>
#include <thread>

namespace perilymph::test {

namespace {

/// Both ends of a pipe, closed with it.
struct Pipe {
  Pipe()
  {
    if (pipe2(end.data(), O_CLOEXEC) != 0)
      throw std::system_error(errno, std::generic_category(), "No pipe could be made");
  }
  ~Pipe()
  {
    closeEnd(0);
    closeEnd(1);
  }
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;

  void closeEnd(std::size_t which)
  {
    if (end[which] >= 0) close(end[which]);
    end[which] = -1;
  }

  std::array<int, 2> end{-1, -1};  // read end, write end
};

std::vector<std::string> environmentFor(const ProgramCall& call)
{
  std::vector<std::string> variables;
  for (char** each = environ; *each != nullptr; ++each) {
    const std::string line = *each;
    const std::string name = line.substr(0, line.find('='));
    bool isChanged = false;
    for (const auto& [changed, value] : call.environment) isChanged |= changed == name;
    if (!isChanged) variables.push_back(line);
  }
  for (const auto& [name, value] : call.environment)
    if (value) variables.push_back(name + "=" + *value);
  return variables;
}

std::vector<char*> pointersTo(std::vector<std::string>& texts)
{
  std::vector<char*> pointers;
  pointers.reserve(texts.size() + 1);
  for (std::string& text : texts) pointers.push_back(text.data());
  pointers.push_back(nullptr);
  return pointers;
}

}  // namespace

struct ChildProcess::Content {
  pid_t id = -1;
  Pipe out, err, ended;
  std::thread reader, waiter;

  std::mutex mutex;  // protects all members below
  std::condition_variable changed;
  ProgramOutcome outcome;
  bool hasEnded = false;    // it must not be signalled any more
  bool isComplete = false;  // it ended, and all its output was read

  void start(const ProgramCall& call);
  void readAll();
  void waitForEnd();
  void signalGroup(int signal);
};

void ChildProcess::Content::start(const ProgramCall& call)
{
  posix_spawn_file_actions_t files;
  posix_spawn_file_actions_init(&files);
  posix_spawn_file_actions_addopen(&files, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_adddup2(&files, out.end[1], STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&files, err.end[1], STDERR_FILENO);
  if (call.folder) posix_spawn_file_actions_addchdir_np(&files, call.folder->c_str());

  // A process group of its own, so that its child processes can be killed with it.
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  posix_spawnattr_setpgroup(&attributes, 0);
  // Reset signals to default, even if the test runs in the background, where some are ignored.
  sigset_t asUsual;
  sigemptyset(&asUsual);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGPIPE}) sigaddset(&asUsual, signal);
  posix_spawnattr_setsigdefault(&attributes, &asUsual);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGDEF);

  std::vector<std::string> label{call.program};
  label.insert(label.end(), call.arguments.begin(), call.arguments.end());
  std::vector<std::string> variables = environmentFor(call);
  const int error = posix_spawnp(&id, call.program.c_str(), &files, &attributes,
                                 pointersTo(label).data(), pointersTo(variables).data());
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&files);
  if (error != 0)
    throw std::system_error(error, std::generic_category(), call.program + " could not be started");
  out.closeEnd(1);
  err.closeEnd(1);
  reader = std::thread([this] { readAll(); });
  waiter = std::thread([this] { waitForEnd(); });
}

void ChildProcess::Content::readAll()
{
  std::array<pollfd, 3> sources{{{out.end[0], POLLIN, 0},  //
                                 {err.end[0], POLLIN, 0},
                                 {ended.end[0], POLLIN, 0}}};
  const std::array<std::string*, 2> texts{&outcome.out, &outcome.err};
  std::array<char, 4096> buffer;
  bool goesOn = true;
  while (goesOn) {
    // After its end, read only what is already in the pipes: a remaining child process may keep
    // them open.
    const bool afterEnd = sources[2].fd < 0;
    const int ready = poll(sources.data(), sources.size(), afterEnd ? 0 : -1);
    if (ready < 0 && errno == EINTR) continue;
    if (ready <= 0) break;
    goesOn = false;
    for (std::size_t i = 0; i < 2; ++i) {
      if (sources[i].fd >= 0 && sources[i].revents != 0) {
        const ssize_t count = read(sources[i].fd, buffer.data(), buffer.size());
        if (count <= 0) sources[i].fd = -1;
        if (count > 0) {
          const std::lock_guard lock(mutex);
          texts[i]->append(buffer.data(), static_cast<std::size_t>(count));
          changed.notify_all();
        }
      }
      goesOn |= sources[i].fd >= 0;
    }
    if (sources[2].fd >= 0 && sources[2].revents != 0) sources[2].fd = -1;
  }
}

void ChildProcess::Content::waitForEnd()
{
  // Waits without reaping, so that its process id cannot be reused.
  siginfo_t ending{};
  while (waitid(P_PID, static_cast<id_t>(id), &ending, WEXITED | WNOWAIT) != 0 && errno == EINTR) {
  }
  {
    const std::lock_guard lock(mutex);
    hasEnded = true;
    int status = 0;
    waitpid(id, &status, 0);
    if (WIFEXITED(status)) outcome.status = WEXITSTATUS(status);
    if (WIFSIGNALED(status)) outcome.signal = WTERMSIG(status);
  }
  ended.closeEnd(1);
  reader.join();
  const std::lock_guard lock(mutex);
  isComplete = true;
  changed.notify_all();
}

void ChildProcess::Content::signalGroup(int signal)
{
  const std::lock_guard lock(mutex);
  if (!hasEnded) kill(-id, signal);
}

ChildProcess::ChildProcess(const ProgramCall& call) : content_(std::make_unique<Content>())
{
  content_->start(call);
}

ChildProcess::~ChildProcess()
{
  content_->signalGroup(SIGKILL);
  content_->waiter.join();
}

bool ChildProcess::waitForOutput(const std::string& text, std::chrono::milliseconds timeout)
{
  std::unique_lock lock(content_->mutex);
  const auto isThere = [&] { return content_->outcome.out.find(text) != std::string::npos; };
  content_->changed.wait_for(lock, timeout, [&] { return isThere() || content_->isComplete; });
  return isThere();
}

ProgramOutcome ChildProcess::wait(std::chrono::milliseconds timeout)
{
  std::unique_lock lock(content_->mutex);
  const auto isComplete = [this] { return content_->isComplete; };
  if (!content_->changed.wait_for(lock, timeout, isComplete)) {
    content_->outcome.timedOut = true;
    lock.unlock();
    content_->signalGroup(SIGKILL);
    lock.lock();
    content_->changed.wait(lock, isComplete);
  }
  return content_->outcome;
}

void ChildProcess::send(int signal)
{
  const std::lock_guard lock(content_->mutex);
  if (!content_->hasEnded) kill(content_->id, signal);
}

int ChildProcess::id() const noexcept { return content_->id; }

ProgramOutcome run(const ProgramCall& call, std::chrono::milliseconds timeout)
{
  return ChildProcess(call).wait(timeout);
}

}  // namespace perilymph::test
