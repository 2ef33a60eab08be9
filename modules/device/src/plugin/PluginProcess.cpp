// SPDX-License-Identifier: BSD-3-Clause
#include "plugin/PluginProcess.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/mman.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <csignal>
#include <cstring>
#include <new>

#include "hid/Intervals.h"
#include "perilymph/realtime/Pacer.h"
#include "plugin/Refusals.h"
#include "plugin/StatedTraits.h"

namespace perilymph::device::plugin {

namespace {

constexpr const char* programName = "perilymph-plugin-host";
constexpr int patienceForClose_ms = 2000;
constexpr int patienceForEnd_ms = 500;
// A killed host ends at once, unless its driver blocks in the kernel.
constexpr int patienceForKilled_ms = 100;
constexpr Phrase hangsInOpen{
    "It did not answer within %1 s while it was opened, and its plug-in was ended. The force is "
    "off. "
    "Check its power and its cable; if that recurs, tell the maker of the plug-in."};
constexpr const char* remedy =
    " The force is off. Reset loads it again; if that recurs, tell its maker.";

}  // namespace

PluginProcess::PluginProcess(std::string name, pid_t id, OwnedFile requests, OwnedFile replies,
                             Channel* channel) noexcept
    : name_(std::move(name)),
      id_(id),
      life_(static_cast<int>(::syscall(SYS_pidfd_open, id, 0))),
      requests_(std::move(requests)),
      replies_(std::move(replies)),
      channel_(channel),
      asked_(realtime::monotonicNanoseconds())
{
}

PluginProcess::~PluginProcess()
{
  say(requests_, goodbye);
  pollfd end{life_.get(), POLLIN, 0};
  ::poll(&end, 1, isKilled_ ? patienceForKilled_ms : patienceForEnd_ms);
  killGroup();
  endCompanion(id_, patienceForKilled_ms);
  ::munmap(channel_, sizeof *channel_);
}

Result<std::unique_ptr<PluginProcess>> PluginProcess::start(const std::filesystem::path& library)
{
  const auto failed = [] {
    return Error{"no process can be made for it: %1.", std::strerror(errno)};
  };
  const std::filesystem::path program = companionProgram(programName);
  if (program.empty())
    return Error{
        "the program %1, in which plug-ins run, is not installed. Install the package again.",
        std::string(programName)};
  int toHost[2] = {-1, -1}, fromHost[2] = {-1, -1};
  if (::pipe2(toHost, O_CLOEXEC) != 0) return failed();
  OwnedFile requests(toHost[1]);
  const OwnedFile hostsRequests(toHost[0]);
  // Not waiting for a host that died while it wrote.
  if (::pipe2(fromHost, O_CLOEXEC | O_NONBLOCK) != 0) return failed();
  OwnedFile replies(fromHost[0]);
  const OwnedFile hostsReplies(fromHost[1]);
  const OwnedFile memory(::memfd_create("perilymph plug-in", MFD_CLOEXEC));
  if (::ftruncate(memory.get(), sizeof(Channel)) != 0) return failed();
  void* const place =
      ::mmap(nullptr, sizeof(Channel), PROT_READ | PROT_WRITE, MAP_SHARED, memory.get(), 0);
  if (place == MAP_FAILED) return failed();
  auto* const channel = new (place) Channel;
  const pid_t id = startCompanion({program,
                                   {library.string()},
                                   {{hostsRequests.get(), plugin::requests},
                                    {memory.get(), plugin::channel},
                                    {hostsReplies.get(), plugin::replies}},
                                   CompanionOutput::standardError});
  if (id == 0) {
    ::munmap(place, sizeof(Channel));
    return Error{"%1 could not be started.", program};
  }
  std::unique_ptr<PluginProcess> process(new PluginProcess(
      library.filename().string(), id, std::move(requests), std::move(replies), channel));
  return process;
}

Result<void> PluginProcess::load(Duration patience, const std::stop_token& stop)
{
  const auto loaded = await(patience, refusals::isTooSlow, stop);
  if (!loaded) return loaded.error();
  if (loaded->version != plugin::version)
    return Error{"%1 is of another version. Install the package again.", std::string(programName)};
  if (loaded->isDone == 0) return Error{recognized(sentenceOf(*loaded), refusals::all)};
  traits_ = loaded->traits;
  return {};
}

Result<Reply> PluginProcess::await(Duration patience, Phrase tooSlow, const std::stop_token& stop)
{
  std::array<pollfd, 2> waits{{{replies_.get(), POLLIN, 0}, {life_.get(), POLLIN, 0}}};
  const std::int64_t end = realtime::monotonicNanoseconds() + nanoseconds(patience.si());
  constexpr std::int64_t lookAtStop_ms = 50;
  int found = 0;
  do {
    const std::int64_t rest_ms = (end - realtime::monotonicNanoseconds()) / 1'000'000;
    found = ::poll(waits.data(), waits.size(),
                   static_cast<int>(std::clamp<std::int64_t>(rest_ms, 0, lookAtStop_ms)));
  } while (found <= 0 && !stop.stop_requested() && realtime::monotonicNanoseconds() < end);
  Reply reply;
  if (::read(replies_.get(), &reply, sizeof reply) == sizeof reply) return reply;
  const bool isLate = waits[0].revents == 0 && waits[1].revents == 0;
  if (waits[0].revents != 0) {
    // The host's end is closed: it is about to end.
    ::poll(&waits[1], 1, patienceForEnd_ms);
  }
  if (!hasEnded()) kill();
  if (isLate) {
    const auto waited = static_cast<double>(realtime::monotonicNanoseconds() - asked_);
    return Error{Sentence(tooSlow, {std::to_string(std::lround(1e-9 * waited))})};
  }
  return Error{obituary()};
}

Result<void> PluginProcess::open(Duration patience, const std::stop_token& stop)
{
  asked_ = realtime::monotonicNanoseconds();
  if (!say(requests_, plugin::open)) return Error{obituary()};
  const auto reply = await(patience, hangsInOpen, stop);
  if (!reply) return reply.error();
  if (reply->isDone == 0) return Error{sentenceOf(*reply)};
  return {};
}

void PluginProcess::close() noexcept
{
  channel_->isClosing = 1;
  channel_->forHost.ring();
  pollfd waits{replies_.get(), POLLIN, 0};
  Reply reply;
  const bool isClosed = say(requests_, plugin::close) &&
                        ::poll(&waits, 1, patienceForClose_ms) == 1 &&
                        ::read(replies_.get(), &reply, sizeof reply) == sizeof reply;
  if (!isClosed && !hasEnded()) kill();
}

bool PluginProcess::hasEnded() const noexcept
{
  pollfd end{life_.get(), POLLIN, 0};
  return ::poll(&end, 1, 0) > 0;
}

void PluginProcess::kill() noexcept
{
  isKilled_ = true;
  // By the descriptor: the number could be another process's by now.
  ::syscall(SYS_pidfd_send_signal, life_.get(), SIGKILL, nullptr, 0);
  killGroup();
}

void PluginProcess::killGroup() noexcept
{
  // The host leads a session of its own. Its number is not another one's before it is waited for.
  ::kill(-id_, SIGKILL);
}

std::string PluginProcess::obituary() const
{
  const std::string plugin = "The plug-in " + name_;
  if (isKilled_) return plugin + " did not answer and was ended." + remedy;
  if (!hasEnded()) return {};
  siginfo_t end{};
  // Without burying it: the destructor does.
  ::waitid(P_PID, static_cast<id_t>(id_), &end, WEXITED | WNOHANG | WNOWAIT);
  if (end.si_code == CLD_KILLED || end.si_code == CLD_DUMPED)
    return plugin + " crashed (signal " + std::to_string(end.si_status) + ")." + remedy;
  if (end.si_status == hungInRead)
    return plugin + " did not return from read() and was ended." + remedy;
  if (end.si_status == hungInWrite)
    return plugin + " did not return from write() and was ended." + remedy;
  return plugin + " ended its process (status " + std::to_string(end.si_status) + ")." + remedy;
}

}  // namespace perilymph::device::plugin
