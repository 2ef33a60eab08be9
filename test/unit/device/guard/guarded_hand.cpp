// SPDX-License-Identifier: BSD-3-Clause

// A program that renders a force until something ends it: guarded_hand SOCKET [FAULT]
// FAULT: none (ends in order at SIGTERM), abort or segv after half a second.

#include <atomic>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "SocketPort.h"
#include "codec/DeviceProfile.h"
#include "hid/HidDevice.h"
#include "perilymph/test/DeviceProfiles.h"

namespace {

using namespace perilymph;

/// A device with plain numbers in its reports that must be switched off at the end.
const std::string guarded = test::profileHead("vector") + R"(max_force_N = 3.0
nominal_period_ms = 1.0
reporting = "periodic"
[mount]
[input]
report = 1
bytes = 8
bits = 16
first_bits = [16, 32, 48]
quantum_mm = [0.01, 0.01, 0.01]
counter_bit = 0
counter_bits = 16
[output]
report = 2
bytes = 6
bits = 16
first_bits = [0, 16, 32]
quantum_N = [0.001, 0.001, 0.001]
[[on_close]]
kind = "output"
bytes = [9, 77]
)";

std::atomic<bool> isRequested{false};
void ask(int) { isRequested = true; }

}  // namespace

int main(int count, char** text)
{
  if (count != 3) return 2;
  const std::string fault = text[2];
  const auto profile = device::parseProfile(guarded, "guarded");
  if (!profile) return std::fprintf(stderr, "%s\n", profile.error().message.c_str()), 1;
  auto codec = device::makeCodec(*profile, {});
  if (!codec) return std::fprintf(stderr, "%s\n", codec.error().message.c_str()), 1;
  std::signal(SIGTERM, ask);

  device::HidDevice hand(device::traitsOf(*profile), *std::move(codec), test::socketPort(text[1]));
  if (const auto opened = hand.open(); !opened)
    return std::fprintf(stderr, "%s\n", opened.error().message.c_str()), 1;
  std::printf("%s\n", hand.health()->isGuarded ? "guarded" : "not guarded");
  std::fflush(stdout);
  device::Wrench push;
  push.force_D[2] = 0.5;
  for (int ticks = 0; !isRequested; ++ticks) {
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
