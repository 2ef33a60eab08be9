// SPDX-License-Identifier: BSD-3-Clause

// The omega and other devices of Force Dimension as a device plug-in, by the maker's SDK, whose header
// and library the user has. Not tried on hardware: see the guide, laboratory-devices.md.

#include <dhdc.h>

#include "PluginEntry.h"
#include "ServoThread.h"

namespace perilymph::forcedimension {

namespace {

using plugin::Answer;
using plugin::Sample;
using plugin::Vector;

// CHAI3D states 12 N, 5000 N/m, 30 N.s/m and a radius of 75 mm for the omega.3 (CDeltaDevices.cpp).
// Stronger devices render no more. The radius is a smaller choice: the omega is flatter than wide.
constexpr double maxForce = 12.0;          // [N]
constexpr double maxStiffness = 5000;      // [N/m]
constexpr double maxDamping = 30;          // [N.s/m]
constexpr double workspaceRadius = 0.055;  // [m]
constexpr double period = 1e-3;            // [s]

class ForceDimensionDevice {
public:
  ~ForceDimensionDevice() { close(); }

  static void state(PerilymphDeviceTraitsV1& traits)
  {
    std::snprintf(traits.name, sizeof traits.name, "Force Dimension omega");
    traits.renders_force = 1;
    traits.max_force_N = maxForce;
    traits.nominal_period_s = period;
    traits.workspace_radius_m = workspaceRadius;
    traits.max_stiffness_N_m = maxStiffness;
    traits.max_damping_N_s_m = maxDamping;
    // A force waits half a period for the next exchange, whose position is older than its effect by
    // another one (estimated).
    traits.transport_delay_s = 1.5 * period;
    traits.sensed_translations = 3;
    traits.actuated_translations = 3;
    traits.buttons = 1;
  }

  std::string open()
  {
    close();
    const int id = dhdOpen();
    if (id < 0)
      return std::string("No device of Force Dimension can be opened: ") + dhdErrorGetLastStr() +
             ". Check its cable and power, and close other programs that use it.";
    device_ = static_cast<char>(id);
    isOpen_ = true;
    // The program compensates no weight.
    if (dhdSetGravityCompensation(DHD_ON, device_) < 0 || dhdEnableForce(DHD_ON, device_) < 0) {
      const std::string why = dhdErrorGetLastStr();
      close();
      return "The device of Force Dimension does not switch its force on: " + why +
             ". Calibrate it as its manual says, and press its force button.";
    }
    servo_.start(link_, [this](const Vector& force, Sample& out) { return exchange(force, out); });
    return {};
  }

  void close() noexcept
  {
    servo_.stop();
    if (!isOpen_) return;
    dhdEnableForce(DHD_OFF, device_);
    dhdClose(device_);
    isOpen_ = false;
  }

  plugin::DeviceLink& link() { return link_; }

private:
  // The SDK's axes: x toward the user, y right, z up; D: x right, y up, z toward the user.
  Answer exchange(const Vector& force_D, Sample& sample) noexcept
  {
    // Not negative: done, done without a transfer because the last was just now, or motors saturated.
    if (dhdSetForce(force_D[2], force_D[0], force_D[1], device_) < 0) return Answer::lost;
    link_.noteSent();
    double x = 0.0, y = 0.0, z = 0.0;
    if (dhdGetPosition(&x, &y, &z, device_) < 0) return Answer::lost;
    const int button = dhdGetButton(0, device_);
    if (button < 0) return Answer::lost;
    sample.position = {y, z, x};
    sample.buttons = button == DHD_ON ? 1u : 0u;
    return Answer::fresh;
  }

  plugin::DeviceLink link_{maxForce};
  char device_ = -1;
  bool isOpen_ = false;
  plugin::ServoThread servo_;  // destroyed first
};

}  // namespace

}  // namespace perilymph::forcedimension

PERILYMPH_DEVICE_PLUGIN(perilymph::forcedimension::ForceDimensionDevice);
