// SPDX-License-Identifier: BSD-3-Clause

// A process in which a device plug-in runs, so that a plug-in that crashes or hangs takes neither
// the program nor the force with it:
//
//   perilymph-plugin-host LIBRARY    started by the program with the files of PluginChannel.h
//
// The main thread calls the plug-in; a second one watches it (CallTimeout). When the program is gone,
// the force is set to zero, the device is closed, and the process ends.

#include <poll.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <string>

#include "perilymph/realtime/RealTimePriority.h"
#include "plugin/host/CallTimeout.h"
#include "plugin/host/PluginRun.h"

namespace {

using namespace perilymph;
using namespace perilymph::device::plugin;

// For the handler of fatal signals, which has no other access.
const Library* crashing = nullptr;
Channel* crashingChannel = nullptr;

/// Takes the force away when the plug-in crashes, as far as that still works, then dies of it.
void crash(int number)
{
  std::signal(number, SIG_DFL);
  const Library* const library = crashing;
  crashing = nullptr;
  // Writing within write() would find its data half changed, within open() a device half open.
  const Function function = crashingChannel->function;
  if (library != nullptr && function != Function::write && function != Function::open) {
    PerilymphDeviceWrenchV1 none{};
    none.size = sizeof none;
    library->functions().write(library->device(), &none);
  }
  std::raise(number);
}

void watchForCrash(Channel& channel, const Library& library)
{
  static unsigned char stack[65536];
  const stack_t own{stack, 0, sizeof stack};
  ::sigaltstack(&own, nullptr);
  crashingChannel = &channel;
  crashing = &library;
  struct sigaction action {};
  action.sa_handler = crash;
  action.sa_flags = SA_ONSTACK | SA_NODEFER;
  for (const int number : {SIGSEGV, SIGBUS, SIGILL, SIGFPE, SIGABRT})
    ::sigaction(number, &action, nullptr);
}

/// Detaches the process: signals of its group do not end it, and it keeps no file of the program
/// open.
void standApart()
{
  for (const int number : {SIGHUP, SIGINT, SIGQUIT, SIGTERM, SIGPIPE, SIGTSTP, SIGTTIN, SIGTTOU})
    std::signal(number, SIG_IGN);
  ::close_range(replies + 1, ~0u, 0);
}

/// Ends what the plug-in left running in the session of this process, once the program is gone. Else
/// the program does that.
struct GroupEnd {
  GroupEnd() = default;
  ~GroupEnd()
  {
    pollfd program{static_cast<int>(requests), 0, 0};
    ::poll(&program, 1, 0);
    if ((program.revents & (POLLHUP | POLLERR)) != 0) ::kill(0, SIGKILL);
  }
  GroupEnd(const GroupEnd&) = delete;
  GroupEnd& operator=(const GroupEnd&) = delete;
};

void reply(Reply answer, const std::string& sentence = {})
{
  // Without a terminating zero if it fills the field.
  std::copy_n(sentence.begin(), std::min(sentence.size(), answer.sentence.size()),
              answer.sentence.begin());
  if (::write(replies, &answer, sizeof answer) < 0) return;  // the program is gone
}

void open(Channel& memory, const Library& library, const CallTimeout& watch)
{
  Reply answer;
  const auto capacity = static_cast<std::uint32_t>(answer.sentence.size() - 1);
  {
    const CallGuard mark(memory, Function::open);
    answer.isDone =
        library.functions().open(library.device(), answer.sentence.data(), capacity) == 0 ? 1 : 0;
  }
  reply(answer);
  if (answer.isDone == 0) return;
  PluginRun(memory, library, watch.isAlone(), watch.isDoomed()).run();
  while (watch.isDoomed()) ::pause();
  const CallGuard mark(memory, Function::close);
  library.functions().close(library.device());
}

/// Serves the requests of the program until it says goodbye or is gone.
void serve(Channel& memory, const Library& library, const CallTimeout& watch)
{
  char request = 0;
  while (::read(requests, &request, 1) == 1 && request != goodbye) {
    if (request == device::plugin::open) open(memory, library, watch);
    if (request != device::plugin::close) continue;
    memory.isClosing = 0;
    Reply done;
    done.isDone = 1;
    reply(done);
  }
}

}  // namespace

int main(int count, char** text)
{
  if (count != 2) {
    std::fprintf(stderr, "%s is started by perilymph and perilymph-cli.\n", text[0]);
    return 2;
  }
  standApart();
  void* const place =
      ::mmap(nullptr, sizeof(Channel), PROT_READ | PROT_WRITE, MAP_SHARED, channel, 0);
  if (place == MAP_FAILED) return 1;
  auto& memory = *static_cast<Channel*>(place);

  CallTimeout watch(memory);
  const GroupEnd afterTheLibrary;
  std::optional<CallGuard> loading(std::in_place, memory, Function::load);
  const auto library = Library::load(text[1]);
  loading.reset();
  if (!library) {
    reply({}, library.error().message);
    return inOrder;
  }
  watch.watch(&*library);
  watchForCrash(memory, *library);
  realtime::requestRealTimePriority(realtime::Rank::write);
  ::mlockall(MCL_CURRENT);
  Reply loaded;
  loaded.isDone = 1;
  loaded.traits = library->traits();
  reply(loaded);
  serve(memory, *library, watch);
  crashing = nullptr;
  watch.watch(nullptr);
  return inOrder;
}
