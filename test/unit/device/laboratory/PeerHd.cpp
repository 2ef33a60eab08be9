// SPDX-License-Identifier: BSD-3-Clause

// A substitute of OpenHaptics' libHD with a Touch behind it: a servo loop at 1 kHz in a thread of its
// own, positions in millimeters, a force that is rendered from frame to frame.

#include <HD/hd.h>

#include <cstring>
#include <mutex>
#include <optional>
#include <thread>

#include "PeerState.h"

namespace {

using perilymph::test::PeerHandle;
using perilymph::test::PeerState;

struct Touch {
  PeerState* state = perilymph::test::sharedPeer();
  std::optional<PeerHandle> handle;
  std::thread servo;
  std::atomic<bool> isStopping{false};
  std::mutex mutex;  // of the callback
  HDSchedulerCallback callback = nullptr;
  void* data = nullptr;
  HDerror error = HD_SUCCESS;
  bool isForceOn = false;
  bool isInFrame = false;
  perilymph::test::Vector3 force{};

  bool isGone() const
  {
    return state == nullptr || state->fault == PeerState::absent ||
           state->fault == PeerState::unplugged;
  }
  void run()
  {
    while (!isStopping) {
      perilymph::test::elapse(1'000'000);
      const std::lock_guard lock(mutex);
      if (callback == nullptr || state->fault == PeerState::silent) continue;
      if (callback(data) != HD_CALLBACK_CONTINUE) callback = nullptr;
    }
  }
};

Touch touch;
constexpr HDerror communication = 77;

}  // namespace

extern "C" {

HHD hdInitDevice(HDstring name)
{
  if (name != HD_DEFAULT_DEVICE || touch.isGone()) {
    touch.error = communication;
    return HD_INVALID_HANDLE;
  }
  touch.handle.emplace(*touch.state);
  ++touch.state->opened;
  return 1;
}
void hdDisableDevice(HHD) { ++touch.state->closed; }
void hdMakeCurrentDevice(HHD) {}
void hdBeginFrame(HHD) { touch.isInFrame = true; }
void hdEndFrame(HHD)
{
  touch.isInFrame = false;
  if (touch.isGone()) {
    touch.error = communication;
    touch.force = {};
  }
  touch.handle->render(touch.isForceOn ? touch.force : perilymph::test::Vector3{});
}
void hdEnable(HDenum capability) { touch.isForceOn = capability == HD_FORCE_OUTPUT; }
void hdDisable(HDenum) { touch.isForceOn = false; }
void hdGetDoublev(HDenum name, HDdouble* values)
{
  if (name == HD_NOMINAL_MAX_FORCE) values[0] = touch.state->driverLimit;
  if (!touch.isInFrame) return;
  if (name == HD_CURRENT_POSITION) {
    const auto place = touch.handle->position();
    for (std::size_t i = 0; i < 3; ++i) values[i] = 1e3 * place[i];
  }
  if (name == HD_CURRENT_TRANSFORM) {  // columns
    const double cosine = std::cos(touch.state->turn), sine = std::sin(touch.state->turn);
    const double columns[16] = {cosine, sine, 0, 0, -sine, cosine, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
    std::memcpy(values, columns, sizeof columns);
  }
}
void hdGetIntegerv(HDenum name, HDint* values)
{
  if (name == HD_CURRENT_BUTTONS) values[0] = static_cast<HDint>(touch.state->buttons.load());
}
void hdSetDoublev(HDenum name, const HDdouble* values)
{
  if (name == HD_CURRENT_FORCE && touch.isInFrame) touch.force = {values[0], values[1], values[2]};
}
HDErrorInfo hdGetError()
{
  const HDErrorInfo error{touch.error, 0, 1};
  touch.error = HD_SUCCESS;
  return error;
}
HDstring hdGetErrorString(HDerror) { return "communication error"; }
HDenum hdCheckCalibration()
{
  return touch.state->isReady != 0 ? HD_CALIBRATION_OK : HD_CALIBRATION_NEEDS_MANUAL_INPUT;
}
void hdStartScheduler()
{
  touch.isStopping = false;
  touch.servo = std::thread([] { touch.run(); });
}
void hdStopScheduler()
{
  touch.isStopping = true;
  if (touch.servo.joinable()) touch.servo.join();
}
HDSchedulerHandle hdScheduleAsynchronous(HDSchedulerCallback callback, void* data, HDushort)
{
  const std::lock_guard lock(touch.mutex);
  touch.callback = callback;
  touch.data = data;
  return 5;
}
void hdUnschedule(HDSchedulerHandle)
{
  const std::lock_guard lock(touch.mutex);
  touch.callback = nullptr;
}

}  // extern "C"
