// A program that pushes with a device until something ends it: guarded_hand SOCKET [FAULT]
// FAULT: none (ends in order at SIGTERM), abort, segv: what it does to itself after half a second.

#include <atomic>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "GuardedProfile.h"
#include "SocketPort.h"
#include "perilymph/device/HidHand.h"

namespace {

using namespace perilymph;

std::atomic<bool> isAsked{false};
void ask(int) { isAsked = true; }

}  // namespace

int main(int count, char** words)
{
  if (count != 3) return 2;
  const std::string fault = words[2];
  const auto profile = device::parseProfile(test::guardedProfile, "guarded");
  if (!profile) return std::fprintf(stderr, "%s\n", profile.error().message.c_str()), 1;
  auto codec = device::makeCodec(*profile, {});
  if (!codec) return std::fprintf(stderr, "%s\n", codec.error().message.c_str()), 1;
  std::signal(SIGTERM, ask);

  device::HidHand hand(device::traitsOf(*profile), *std::move(codec), test::socketPort(words[1]));
  if (const auto opened = hand.open(); !opened)
    return std::fprintf(stderr, "%s\n", opened.error().message.c_str()), 1;
  std::printf("%s\n", hand.health()->isGuarded ? "guarded" : "not guarded");
  std::fflush(stdout);
  device::Wrench push;
  push.force_D[2] = 0.5;
  for (int ticks = 0; !isAsked; ++ticks) {
    hand.await(milliseconds(5));
    hand.read();
    hand.write(push);
    if (ticks == 200) std::printf("pushing\n"), std::fflush(stdout);
    if (ticks == 500 && fault == "abort") std::abort();
    if (ticks == 500 && fault == "segv") std::raise(SIGSEGV);
  }
  hand.close();
  return 0;
}
