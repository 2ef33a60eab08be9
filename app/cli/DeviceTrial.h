#pragma once

// A device tried out: how it reports, how fast it takes a force, and the force itself.

#include <filesystem>
#include <optional>

#include "perilymph/device/DeviceHealth.h"
#include "perilymph/device/DeviceRegistry.h"

namespace perilymph::cli {

struct TrialOutcome {
  std::optional<device::DeviceHealth> health;  ///< None of a plug-in: it measures nothing itself.
  device::DeviceTraits traits;                 ///< With what was measured.
  double stiffness = 0.0;  ///< Stiffest coupling it renders at 1 kHz [N/m]; 0 without force.
  int axesFelt = 0;        ///< Axes on which the force was shown.
  int axes = 0;            ///< Axes that show a force.
  int samples = 0;         ///< Read while listening.
  int fresh = 0;           ///< Samples that were new and valid.
};

/// Opens the device, listens for three seconds, then shows at most 0.5 N on each axis while the
/// button is held. Says on standard output what to do; ends by itself, or with Ctrl-C.
///
/// @param tape  Where to keep every report; nowhere if empty.
Result<TrialOutcome> tryDevice(const device::FoundDevice& found, const std::filesystem::path& tape);

/// The same with the device of a plug-in, which is a shared library.
Result<TrialOutcome> tryPlugin(const std::filesystem::path& library);

}  // namespace perilymph::cli
