// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/foundation/Program.h"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <sstream>

#include "Descriptor.h"
#include "perilymph/foundation/Utf8.h"

namespace perilymph {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::size_t maxAnswer = std::size_t{1} << 20;

/// Appends what can be read now; false at the end of the file.
bool readMore(int descriptor, std::string& text)
{
  std::array<char, 4096> block;
  const ssize_t count = ::read(descriptor, block.data(), block.size());
  if (count < 0) return errno == EINTR;
  const auto bytes = static_cast<std::size_t>(count);
  text.append(block.data(), std::min(bytes, maxAnswer - text.size()));
  return count > 0;
}

/// Reads both pipes to their end; false if that takes too long.
bool readAll(int output, int errors, ProgramAnswer& answer, Clock::time_point end)
{
  std::array<pollfd, 2> sources{{{output, POLLIN, 0}, {errors, POLLIN, 0}}};
  const std::array<std::string*, 2> texts{&answer.output, &answer.errors};
  while (sources[0].fd >= 0 || sources[1].fd >= 0) {
    const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(end - Clock::now());
    if (left.count() <= 0) return false;
    const int ready = ::poll(sources.data(), sources.size(), static_cast<int>(left.count()) + 1);
    if (ready < 0 && errno != EINTR) return false;
    if (ready <= 0) continue;
    for (std::size_t i = 0; i < sources.size(); ++i)
      if (sources[i].fd >= 0 && sources[i].revents != 0 && !readMore(sources[i].fd, *texts[i]))
        sources[i].fd = -1;
  }
  return true;
}

}  // namespace

Result<pid_t> startProgram(const ProgramCall& call)
{
  // Copies above every number that the program gets, so that none overwrites a source.
  int highest = STDERR_FILENO;
  for (const auto& [here, there] : call.files) highest = std::max(highest, there);
  std::vector<Descriptor> copies;
  for (const auto& [here, there] : call.files) {
    copies.emplace_back(::fcntl(here, F_DUPFD_CLOEXEC, highest + 1));
    if (!copies.back()) return Error{reason(errno)};
  }
  posix_spawn_file_actions_t actions;
  if (const int failure = ::posix_spawn_file_actions_init(&actions)) return Error{reason(failure)};
  for (std::size_t i = 0; i < copies.size(); ++i)
    ::posix_spawn_file_actions_adddup2(&actions, copies[i].number(), call.files[i].second);
  posix_spawnattr_t attributes;
  ::posix_spawnattr_init(&attributes);
  if (call.hasOwnSession) ::posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSID);

  std::vector<std::string> texts{call.program};
  texts.insert(texts.end(), call.arguments.begin(), call.arguments.end());
  std::vector<char*> pointers;
  for (std::string& text : texts) pointers.push_back(text.data());
  pointers.push_back(nullptr);
  pid_t id = 0;
  const int failure =
      ::posix_spawnp(&id, call.program.c_str(), &actions, &attributes, pointers.data(), environ);
  ::posix_spawnattr_destroy(&attributes);
  ::posix_spawn_file_actions_destroy(&actions);
  if (failure != 0) return Error{reason(failure)};
  return id;
}

Result<ProgramAnswer> runProgram(const std::string& program,
                                 const std::vector<std::string>& arguments,
                                 std::chrono::milliseconds longest)
{
  std::array<int, 2> output{}, errors{};
  if (::pipe2(output.data(), O_CLOEXEC) != 0) return Error{reason(errno)};
  const Descriptor outputRead(output[0]);
  Descriptor outputWrite(output[1]);
  if (::pipe2(errors.data(), O_CLOEXEC) != 0) return Error{reason(errno)};
  const Descriptor errorsRead(errors[0]);
  Descriptor errorsWrite(errors[1]), none(::open("/dev/null", O_RDONLY | O_CLOEXEC));
  const auto id = startProgram({program,
                                arguments,
                                {{none.number(), STDIN_FILENO},
                                 {outputWrite.number(), STDOUT_FILENO},
                                 {errorsWrite.number(), STDERR_FILENO}},
                                false});
  if (!id) return id.error();
  outputWrite.close();
  errorsWrite.close();
  ProgramAnswer answer;
  const bool hasEnded =
      readAll(outputRead.number(), errorsRead.number(), answer, Clock::now() + longest);
  if (!hasEnded) ::kill(*id, SIGKILL);
  int status = 0;
  while (::waitpid(*id, &status, 0) < 0 && errno == EINTR) continue;
  if (!hasEnded)
    return Error{"it did not end within %1 s",
                 std::chrono::duration_cast<std::chrono::seconds>(longest).count()};
  if (WIFEXITED(status)) answer.status = WEXITSTATUS(status);
  return answer;
}

std::string linesTogether(const std::string& text)
{
  std::istringstream lines(text);
  std::string together;
  for (std::string line; std::getline(lines, line);) {
    line = onOneLine(line);
    const std::size_t first = line.find_first_not_of(' ');
    if (first == std::string::npos) continue;
    together +=
        (together.empty() ? "" : "; ") + line.substr(first, line.find_last_not_of(' ') + 1 - first);
  }
  return together;
}

}  // namespace perilymph
