// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Test of a device: reports, write times, and force.

#include <array>
#include <filesystem>
#include <optional>
#include <string>

#include "perilymph/device/DeviceHealth.h"
#include "perilymph/device/DeviceRegistry.h"
#include "perilymph/haptics/ForceTrial.h"

namespace perilymph::cli {

struct TrialOutcome {
  std::optional<device::DeviceHealth> health;
  bool isPlugin = false;        ///< The device of a plug-in.
  device::DeviceTraits traits;  ///< With the measured values.
  double stiffness = 0.0;  ///< Maximum stiffness of the coupling at 1 kHz [N/m]; 0 without force.
  /// Damping that a handle needs for this stiffness and the shipped damping to be passive [N.s/m].
  double passiveHandleDamping = 0.0;
  int axes = 0;                 ///< Number of axes that render a force or a torque.
  double greatest = 0.0;        ///< Intended maximum force of the test [N].
  double greatestTorque = 0.0;  ///< Intended maximum torque of the test [N.m].
  /// Results along D's x, y, z, then about them.
  std::array<haptics::ForceTrial::Axis, haptics::ForceTrial::axes> forces;
  /// A sentence: why the force was not tested on every axis; empty if it was.
  std::string untested;
  int samples = 0;            ///< Samples read while listening.
  int fresh = 0;              ///< Samples that were new and valid.
  bool wasPressed = false;    ///< The grasp button was held at some time.
  bool canBePressed = false;  ///< The device has a button.

  /// Number of axes on which a force other than zero was rendered to the end.
  int axesShown() const;
  /// A sentence: what the test found missing; empty if it passed: reports, the button, and the force
  /// on every axis.
  std::string shortcoming() const;
};

/// Opens the device, listens for three seconds, then renders at most 0.5 N on each axis while the
/// button is held. Prints instructions on standard output; ends automatically, or with Ctrl-C.
///
/// @param tape  File for all reports; none if empty.
Result<TrialOutcome> tryDevice(const device::FoundDevice& found, const std::filesystem::path& tape);

/// The same with the device of a plug-in (a shared library).
Result<TrialOutcome> tryPlugin(const std::filesystem::path& library);

}  // namespace perilymph::cli
