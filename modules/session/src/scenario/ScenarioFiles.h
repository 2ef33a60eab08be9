#pragma once

// The files that a scenario names.

#include <filesystem>
#include <string>
#include <vector>

#include "perilymph/foundation/Result.h"
#include "perilymph/session/Scenario.h"

namespace perilymph::session {

/// The file that `patient` means: beside the scenario, else a shipped name or a path.
///
/// @param folder  Folder of the scenario's file; empty without one.
Result<std::filesystem::path> findPatient(const std::string& patient,
                                          const std::filesystem::path& folder);

/// Files of the patient, the array, the friction and the calibration that a scenario names.
std::vector<std::filesystem::path> filesOf(const Scenario& scenario, const std::string& friction,
                                           const std::filesystem::path& folder);

}  // namespace perilymph::session
