// SPDX-License-Identifier: BSD-3-Clause

// The Touch and other devices of 3D Systems as a device plug-in, by the HD API of OpenHaptics, whose
// header and library the user has. Not tried on hardware: see the guide, laboratory-devices.md.

#include <HD/hd.h>

#include <cmath>

#include "PluginEntry.h"

namespace perilymph::openhaptics {

namespace {

using plugin::Sample;
using plugin::Vector;

// CHAI3D states 3.3 N, 400 N/m, 4 N.s/m and a radius of 75 mm for the Touch (CPhantomDevices.cpp). A
// stronger device renders no more, a weaker one what its driver states.
constexpr double maxForce = 3.3;      // [N]
constexpr double maxStiffness = 400;  // [N/m]
constexpr double maxDamping = 4;      // [N.s/m]
// Half of the height of 120 mm that the PHANToM Omni's data sheet is quoted with (chosen).
constexpr double workspaceRadius = 0.06;  // [m]
constexpr double period = 1e-3;           // of the driver's servo loop [s]
constexpr double metersPerUnit = 1e-3;    // the HD API counts in millimeters

/// The rotation of a matrix of columns, as the HD API gives it, as a unit quaternion w, x, y, z
/// (Shepperd 1978: the largest component first).
std::array<double, 4> quaternion(const HDdouble* m) noexcept
{
  const double diagonal[4] = {m[0] + m[5] + m[10], m[0] - m[5] - m[10], m[5] - m[0] - m[10],
                              m[10] - m[0] - m[5]};
  const double twice[4][4] = {{1.0 + diagonal[0], m[6] - m[9], m[8] - m[2], m[1] - m[4]},
                              {m[6] - m[9], 1.0 + diagonal[1], m[4] + m[1], m[8] + m[2]},
                              {m[8] - m[2], m[4] + m[1], 1.0 + diagonal[2], m[9] + m[6]},
                              {m[1] - m[4], m[8] + m[2], m[9] + m[6], 1.0 + diagonal[3]}};
  const auto largest = std::max_element(diagonal, diagonal + 4) - diagonal;
  const double* const row = twice[largest];
  const double size =
      std::sqrt(row[0] * row[0] + row[1] * row[1] + row[2] * row[2] + row[3] * row[3]);
  return {row[0] / size, row[1] / size, row[2] / size, row[3] / size};
}

class OpenHapticsDevice {
public:
  ~OpenHapticsDevice() { close(); }

  static void state(PerilymphDeviceTraitsV1& traits)
  {
    std::snprintf(traits.name, sizeof traits.name, "3D Systems Touch");
    traits.renders_force = 1;
    traits.max_force_N = maxForce;
    traits.nominal_period_s = period;
    traits.workspace_radius_m = workspaceRadius;
    traits.max_stiffness_N_m = maxStiffness;
    traits.max_damping_N_s_m = maxDamping;
    // A force waits half a period for the servo loop, whose next position shows its effect (estimated).
    traits.transport_delay_s = 1.5 * period;
    traits.sensed_translations = 3;
    traits.sensed_rotations = 3;
    traits.actuated_translations = 3;
    traits.buttons = 2;
  }

  std::string open()
  {
    close();
    // The device that the driver's settings name as the default.
    hdGetError();  // forgets an earlier one
    device_ = hdInitDevice(HD_DEFAULT_DEVICE);
    HDErrorInfo error = hdGetError();
    if (HD_DEVICE_ERROR(error) || device_ == HD_INVALID_HANDLE) {
      const std::string why = hdGetErrorString(error.errorCode);
      device_ = HD_INVALID_HANDLE;
      return "The device of 3D Systems cannot be opened: " + why +
             ". Check its cable, and that the driver's setup lists it.";
    }
    hdMakeCurrentDevice(device_);
    HDdouble strength = 0.0;
    hdGetDoublev(HD_NOMINAL_MAX_FORCE, &strength);
    driverLimit_ = std::isfinite(strength) && strength > 0.0 ? strength : maxForce;
    hdEnable(HD_FORCE_OUTPUT);
    link_.reset();
    hdStartScheduler();
    isScheduled_ = true;
    error = hdGetError();
    if (HD_DEVICE_ERROR(error)) {
      const std::string why = hdGetErrorString(error.errorCode);
      close();
      return "The servo loop of the device of 3D Systems does not start: " + why +
             ". Switch the device off and on.";
    }
    if (hdCheckCalibration() != HD_CALIBRATION_OK) {
      close();
      return "The device of 3D Systems is not calibrated: put its stylet into the inkwell, "
             "calibrate it with the driver's setup, and open it again.";
    }
    callback_ =
        hdScheduleAsynchronous(&OpenHapticsDevice::onServo, this, HD_MAX_SCHEDULER_PRIORITY);
    error = hdGetError();
    if (!HD_DEVICE_ERROR(error)) return {};
    const std::string why = hdGetErrorString(error.errorCode);
    close();
    return "The device of 3D Systems cannot be read: " + why + ". Switch it off and on.";
  }

  void close() noexcept
  {
    if (device_ == HD_INVALID_HANDLE) return;
    isClosing_ = true;
    // The servo loop renders zero once more and then ends its callback; a loop that stands still is
    // not waited for.
    const std::int64_t end = plugin::now() + 100'000'000;
    const timespec step{0, 1'000'000};
    while (callback_ != 0 && !hasEnded_ && plugin::now() < end) ::nanosleep(&step, nullptr);
    if (isScheduled_) hdStopScheduler();
    if (callback_ != 0 && !hasEnded_) hdUnschedule(callback_);
    hdDisable(HD_FORCE_OUTPUT);
    hdDisableDevice(device_);
    device_ = HD_INVALID_HANDLE;
    callback_ = 0;
    isScheduled_ = isClosing_ = hasEnded_ = false;
  }

  plugin::DeviceLink& link() { return link_; }

private:
  static HDCallbackCode HDCALLBACK onServo(void* device)
  {
    return static_cast<OpenHapticsDevice*>(device)->servo();
  }

  /// One period of the driver's servo loop.
  HDCallbackCode servo() noexcept
  {
    const bool isLast = isClosing_;
    hdBeginFrame(device_);
    HDdouble place[3] = {}, matrix[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
    HDint buttons = 0;
    hdGetDoublev(HD_CURRENT_POSITION, place);
    hdGetDoublev(HD_CURRENT_TRANSFORM, matrix);
    hdGetIntegerv(HD_CURRENT_BUTTONS, &buttons);
    Vector force = isLast ? Vector{} : link_.force();
    const double size = std::hypot(force[0], force[1], force[2]);
    for (double& part : force) part *= size > driverLimit_ ? driverLimit_ / size : 1.0;
    const HDdouble given[3] = {force[0], force[1], force[2]};
    hdSetDoublev(HD_CURRENT_FORCE, given);
    hdEndFrame(device_);
    link_.noteSent();
    // Any error: also of the driver's own limits, which has switched the force off.
    const HDErrorInfo error = hdGetError();
    if (HD_DEVICE_ERROR(error)) link_.lose();
    if (!HD_DEVICE_ERROR(error)) {
      Sample sample;
      // x right, y up, z toward the user, as D.
      for (std::size_t i = 0; i < 3; ++i) sample.position[i] = metersPerUnit * place[i];
      sample.rotation = quaternion(matrix);
      sample.buttons = ((buttons & HD_DEVICE_BUTTON_1) != 0 ? 1u : 0u) |
                       ((buttons & HD_DEVICE_BUTTON_2) != 0 ? 2u : 0u);
      link_.deliver(sample);
    }
    if (!isLast) return HD_CALLBACK_CONTINUE;
    hasEnded_ = true;
    return HD_CALLBACK_DONE;
  }

  plugin::DeviceLink link_{maxForce};
  HHD device_ = HD_INVALID_HANDLE;
  HDSchedulerHandle callback_ = 0;
  double driverLimit_ = maxForce;  // [N]
  bool isScheduled_ = false;
  std::atomic<bool> isClosing_{false}, hasEnded_{false};
};

}  // namespace

}  // namespace perilymph::openhaptics

PERILYMPH_DEVICE_PLUGIN(perilymph::openhaptics::OpenHapticsDevice);
