// SPDX-License-Identifier: BSD-3-Clause

// The Novint Falcon as a device plug-in. Not tried on hardware: see the guide, laboratory-devices.md.

#include <cmath>
#include <cstdlib>

#include "FalconKinematics.h"
#include "FalconPort.h"
#include "PluginEntry.h"
#include "ServoThread.h"

namespace perilymph::novint {

namespace {

using plugin::Answer;
using plugin::Sample;

// As CHAI3D states (CFalconDevice.cpp).
constexpr double maxForce = 8.0;          // [N]
constexpr double maxStiffness = 3000;     // [N/m]
constexpr double maxDamping = 20;         // [N.s/m]
constexpr double workspaceRadius = 0.04;  // [m]
// The middle of the depths that the thighs reach from -20 to 70 degrees, 74 to 173 mm.
constexpr double centerZ = 0.125;  // [m]
// Motor value for a torque on a thigh: libnifalcon's (FalconKinematicStamper.cpp), from where it is
// not stated. Confidence: low; measure the force and correct it by PERILYMPH_FALCON_FORCE_SCALE.
constexpr double countsPerTorque = 10'000.0;  // [1/(N m)]

/// A factor on all forces, 0.1 to 10; 1 if the variable is not set. 0 if it is no such number.
double forceScale()
{
  const char* text = std::getenv("PERILYMPH_FALCON_FORCE_SCALE");
  if (text == nullptr) return 1.0;
  char* end = nullptr;
  const double value = std::strtod(text, &end);
  return *text != 0 && *end == 0 && value >= 0.1 && value <= 10.0 ? value : 0.0;
}

/// The buttons in the program's order: the center one grasps.
std::uint32_t ordered(std::uint32_t buttons) noexcept
{
  return ((buttons >> 2) & 1) | ((buttons & 1) << 1) | ((buttons & 2) << 1) | (buttons & 8);
}

class NovintFalcon {
public:
  ~NovintFalcon() { close(); }

  static void state(PerilymphDeviceTraitsV1& traits)
  {
    std::snprintf(traits.name, sizeof traits.name, "Novint Falcon");
    traits.renders_force = 1;
    traits.max_force_N = maxForce;
    // An exchange takes one to two milliseconds by libftdi (chosen, not measured on a device).
    traits.nominal_period_s = 2e-3;
    traits.workspace_radius_m = workspaceRadius;
    traits.max_stiffness_N_m = maxStiffness;
    traits.max_damping_N_s_m = maxDamping;
    // One count turns a thigh by 0.036 degrees, which moves the grip by about 60 mm times that.
    traits.position_quantum_m = 4e-5;
    // A force waits for half an exchange, and its effect for a whole one (estimated).
    traits.transport_delay_s = 3e-3;
    traits.sensed_translations = 3;
    traits.actuated_translations = 3;
    traits.buttons = 4;
  }

  std::string open()
  {
    close();
    scale_ = forceScale();
    if (scale_ == 0.0)
      return "PERILYMPH_FALCON_FORCE_SCALE must be a number from 0.1 to 10; correct or unset it.";
    const char* firmware = std::getenv("PERILYMPH_FALCON_FIRMWARE");
    std::string error = port_.open(firmware != nullptr ? firmware : "");
    if (!error.empty()) return error;
    position_ = {0.0, 0.0, centerZ};
    isHomed_ = false;
    servo_.start(link_, [this](const Vector& force, Sample& out) { return exchange(force, out); });
    return {};
  }

  void close() noexcept
  {
    servo_.stop();
    port_.close();
  }

  plugin::DeviceLink& link() { return link_; }

private:
  Answer exchange(const Vector& force_D, Sample& sample) noexcept
  {
    const bool isSent = port_.send(encoded(motors(force_D), isHomed_ ? blueLight : redLight));
    if (isSent) link_.noteSent();
    Packet packet;
    const Reply reply = isSent ? port_.receive(packet) : Reply::lost;
    if (reply == Reply::lost) return Answer::lost;
    const auto state = reply == Reply::complete ? decoded(packet) : std::nullopt;
    isHomed_ = state && state->isHomed;
    // Before homing the counts begin anywhere.
    if (!isHomed_) return Answer::silent;
    for (std::size_t i = 0; i < 3; ++i) angles_[i] = armAngle(state->encoders[i]);
    const auto position = kinematics_.position(angles_, position_);
    if (!position) {
      position_ = {0.0, 0.0, centerZ};  // where the next search begins
      isHomed_ = false;                 // and no force until it succeeds
      return Answer::silent;
    }
    position_ = *position;
    sample.position = {position_[0], position_[1], position_[2] - centerZ};
    sample.buttons = ordered(state->buttons);
    return Answer::fresh;
  }

  /// Motor values for a force, in proportion to its torques: one that is too large reduces all three.
  Counts motors(const Vector& force) const noexcept
  {
    if (!isHomed_) return {};
    const Vector torques = kinematics_.torques(angles_, position_, force);
    double largest = 0.0;
    for (const double torque : torques)
      largest = std::max(largest, std::fabs(countsPerTorque * scale_ * torque));
    const double limit = largest > maxMotorCount ? maxMotorCount / largest : 1.0;
    Counts counts{};
    // A positive value turns a motor against its angle.
    for (std::size_t i = 0; i < 3; ++i)
      counts[i] = -static_cast<int>(std::lround(limit * countsPerTorque * scale_ * torques[i]));
    return counts;
  }

  plugin::DeviceLink link_{maxForce};
  FalconPort port_;
  FalconKinematics kinematics_;
  double scale_ = 1.0;
  // Of the device's thread.
  Vector angles_{}, position_{};
  bool isHomed_ = false;
  plugin::ServoThread servo_;  // destroyed first
};

}  // namespace

}  // namespace perilymph::novint

PERILYMPH_DEVICE_PLUGIN(perilymph::novint::NovintFalcon);
