// SPDX-License-Identifier: BSD-3-Clause
#include <pthread.h>
#include <unistd.h>

#include "perilymph/foundation/RealTime.h"

namespace perilymph {
namespace {

thread_local ThreadRole roleOfThisThread = ThreadRole::none;

}  // namespace

void declareThread(ThreadRole role) noexcept
{
  assert(isOnThread(ThreadRole::none) || isOnThread(role));
  roleOfThisThread = role;
  const bool isMainThread = ::gettid() == ::getpid();
  if (!isMainThread) ::pthread_setname_np(::pthread_self(), threadName(role));
}

ThreadRole threadRole() noexcept { return roleOfThisThread; }

const char* threadName(ThreadRole role) noexcept
{
  switch (role) {
    case ThreadRole::none:
      break;
    case ThreadRole::window:
      return "window";
    case ThreadRole::haptic:
      return "haptic";
    case ThreadRole::recorder:
      return "recorder";
    case ThreadRole::worker:
      return "worker";
    case ThreadRole::calculation:
      return "calculation";
    case ThreadRole::deviceWriter:
      return "device-writer";
    case ThreadRole::deviceSupervisor:
      return "device-watch";
    case ThreadRole::tapeWriter:
      return "tape-writer";
    case ThreadRole::pluginWatch:
      return "plugin-watch";
    case ThreadRole::sound:
      return "sound";
    case ThreadRole::broadcast:
      return "broadcast";
  }
  return "perilymph";
}

}  // namespace perilymph
