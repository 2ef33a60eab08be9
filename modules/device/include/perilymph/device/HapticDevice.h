// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The interface of all input devices: haptic devices, mouse, scripts and recordings.

#include <array>
#include <cstdint>
#include <optional>
#include <string>

#include "perilymph/device/DeviceHealth.h"
#include "perilymph/foundation/RealTime.h"
#include "perilymph/foundation/Result.h"
#include "perilymph/foundation/Units.h"

namespace perilymph::device {

/// Bits of DeviceSample::buttons.
enum Button : std::uint32_t {
  graspButton = 1u << 0,  ///< The dead-man's button: the array follows while it is held.
};

/// Content of one report, in the device's frame D: x right, y up, z toward the user.
struct DeviceSample {
  std::uint64_t sequence = 0;                            ///< Incremented with each fresh report.
  std::array<double, 3> position_D{};                    ///< [m]
  std::array<double, 4> rotation_D{1.0, 0.0, 0.0, 0.0};  ///< Unit quaternion w, x, y, z.
  std::uint32_t buttons = 0;                             ///< Button bits.
  std::uint32_t isValid = 0;                             ///< 0 after the device stopped responding.
};

/// A force and a torque in the device's frame.
struct Wrench {
  std::array<double, 3> force_D{};   ///< [N]
  std::array<double, 3> torque_D{};  ///< [N.m]
};

/// When a device sends input reports.
enum class Reporting : std::uint8_t {
  periodic,  ///< By its own clock, whether moved or not.
  onChange,  ///< Only while it moves: silence means no motion.
  onWrite,   ///< One for each output report; the first one must be requested.
  polled,    ///< Never unsolicited: the host requests a feature report.
};

/// Capabilities of the hardware. Known before open(). 0 means unknown.
struct DeviceTraits {
  std::string name;             ///< Display name: "Scripted insertion".
  bool rendersForce = false;    ///< The device renders forces.
  double maxForce = 0.0;        ///< [N]; 0 if no force is rendered.
  double nominalPeriod = 1e-3;  ///< Between reports [s].

  Reporting reporting = Reporting::periodic;
  int sensedTranslations = 3;    ///< Axes of D that the device senses, 0 to 3.
  int sensedRotations = 0;       ///< 0 to 3.
  int actuatedTranslations = 0;  ///< Axes of D along which it can push, 0 to 3.
  int actuatedRotations = 0;     ///< 0 to 3.
  /// Bit i is the axis that it can push along (x, y, z of D: 0 to 2) or turn about (3 to 5); 0: the
  /// first ones of each count.
  std::uint32_t actuatedAxes = 0;
  int buttons = 1;                ///< Including the grasp button.
  double workspaceRadius = 0.0;   ///< Around D's origin [m].
  double maxTorque = 0.0;         ///< [N.m]
  double maxStiffness = 0.0;      ///< Stiffest wall that it renders stably [N/m].
  double maxDamping = 0.0;        ///< [N.s/m]
  double handleDamping = 0.0;     ///< Damping of the handle itself, without force [N.s/m].
  double handleMass = 0.0;        ///< As felt at the handle [kg].
  double positionQuantum = 0.0;   ///< Step of a sensed position [m].
  double forceQuantum = 0.0;      ///< Step of a shown force [N].
  double transportDelay = 0.0;    ///< From a force to the report that shows its effect [s].
  double watchdog = 0.0;          ///< Time after which the device itself drops an old force [s].
  std::uint8_t polledReport = 0;  ///< Number of the feature report to request if polled.

  /// Whether it can push along an axis of D: 0, 1, 2 for x, y, z.
  bool pushesAlong(int axis) const noexcept
  {
    if (!rendersForce) return false;
    return actuatedAxes != 0 ? (actuatedAxes >> axis & 1u) != 0 : axis < actuatedTranslations;
  }
  /// Whether it can turn the hand about an axis of D.
  bool turnsAbout(int axis) const noexcept
  {
    if (maxTorque <= 0.0) return false;
    return actuatedAxes != 0 ? (actuatedAxes >> (axis + 3) & 1u) != 0 : axis < actuatedRotations;
  }
};

/// Result of waiting for a report.
enum class Awaited : std::uint8_t {
  fresh,    ///< A fresh report arrived.
  nothing,  ///< None arrived in time.
  cannot,   ///< This device cannot be waited for, at least not now.
};

/// What a script tells a device to do.
enum class ScriptedMotion : std::uint8_t { hold, insert, withdraw };

/// A device that senses the user's motion and may render forces.
///
/// open() and close() run on the UI thread and may block. read() and write() run on the haptic
/// thread, a thousand times a second, and must not block.
class HapticDevice {
public:
  virtual ~HapticDevice() = default;

  /// Capabilities of the hardware. Known before open().
  virtual DeviceTraits traits() const = 0;

  virtual Result<void> open() = 0;
  virtual void close() noexcept = 0;

  /// The newest sample; `isValid` is 0 after the device stopped responding. Real-time safe.
  virtual DeviceSample read() noexcept = 0;

  /// Stores the wrench for the writer; rendered until the next call. Real-time safe.
  virtual void write(const Wrench& wrench_D) noexcept = 0;

  /// Waits for the next fresh report, so that a loop can tick by the device's clock. Haptic thread,
  /// between ticks.
  virtual Awaited await(Duration /*most*/) noexcept { return Awaited::cannot; }

  /// Sets the motion of a device that follows a script; its user moves any other. Any thread.
  virtual void move(ScriptedMotion /*motion*/) noexcept {}

  /// Health of the device; empty without hardware. UI thread.
  virtual std::optional<DeviceHealth> health() { return std::nullopt; }
};

}  // namespace perilymph::device
