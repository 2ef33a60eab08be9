// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/foundation/SignalsAtStart.h"

#include <signal.h>

#include <array>
#include <cstddef>

namespace perilymph {

namespace {

constexpr std::array watched{SIGHUP, SIGINT, SIGTERM};
std::array<bool, watched.size()> wasIgnored{};

void remember(int, char**, char**)
{
  for (std::size_t i = 0; i < watched.size(); ++i) {
    struct sigaction now = {};
    wasIgnored[i] = ::sigaction(watched[i], nullptr, &now) == 0 && now.sa_handler == SIG_IGN;
  }
}

// The functions of this section run before those of all shared libraries (System V gABI, "Initialization and
// Termination Functions").
[[gnu::section(".preinit_array"), gnu::used]] void (*beforeLibraries)(int, char**,
                                                                      char**) = remember;

}  // namespace

bool wasIgnoredAtStart(int signal) noexcept
{
  for (std::size_t i = 0; i < watched.size(); ++i)
    if (watched[i] == signal) return wasIgnored[i];
  return false;
}

}  // namespace perilymph
