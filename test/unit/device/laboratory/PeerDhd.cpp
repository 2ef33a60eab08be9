// SPDX-License-Identifier: BSD-3-Clause

// A substitute of Force Dimension's libdhd with an omega.3 behind it: calls that wait for the device, x
// toward the user, y right, z up.

#include <dhdc.h>

#include <optional>

#include "PeerState.h"

namespace {

using perilymph::test::PeerHandle;
using perilymph::test::PeerState;

struct Omega {
  PeerState* state = perilymph::test::sharedPeer();
  std::optional<PeerHandle> handle;
  bool isForceOn = false;
};
Omega omega;
constexpr char own = 3;

/// A call to the device: waits while it is silent, and tells whether it is there.
bool reaches(char device)
{
  constexpr std::int64_t transfer = 100'000;  // [ns]
  do perilymph::test::elapse(transfer);
  while (omega.state->fault == PeerState::silent);
  return device == own && omega.handle && omega.state->fault != PeerState::unplugged;
}

}  // namespace

extern "C" {

int dhdOpen()
{
  if (omega.state == nullptr || omega.state->fault != PeerState::none) return -1;
  omega.handle.emplace(*omega.state);
  ++omega.state->opened;
  return own;
}
int dhdClose(char)
{
  omega.handle.reset();
  ++omega.state->closed;
  return 0;
}
int dhdEnableForce(unsigned char isOn, char device)
{
  omega.isForceOn = isOn == DHD_ON;
  if (!omega.isForceOn && omega.handle) omega.handle->render({});
  return device == own ? 0 : -1;
}
int dhdSetGravityCompensation(int, char device) { return device == own ? 0 : -1; }
int dhdGetPosition(double* x, double* y, double* z, char device)
{
  if (!reaches(device)) return -1;
  const auto place = omega.handle->position();
  *x = place[2];
  *y = place[0];
  *z = place[1];
  return 0;
}
int dhdSetForce(double x, double y, double z, char device)
{
  if (!reaches(device)) {
    if (omega.handle) omega.handle->render({});  // without a cable it renders nothing
    return -1;
  }
  omega.handle->render(omega.isForceOn ? perilymph::test::Vector3{y, z, x}
                                       : perilymph::test::Vector3{});
  return 0;
}
int dhdGetButton(int index, char device)
{
  if (!reaches(device)) return -1;
  return index == 0 && (omega.state->buttons & 1) != 0 ? DHD_ON : DHD_OFF;
}
const char* dhdErrorGetLastStr() { return "no device found"; }

}  // extern "C"
