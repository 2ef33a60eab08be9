// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The files named by a scenario.

#include <filesystem>
#include <string>
#include <vector>

#include "perilymph/foundation/Result.h"
#include "perilymph/session/Scenario.h"

namespace perilymph::session {

/// Finds the file of a patient: beside the scenario, else by a shipped name or a path.
///
/// @param folder  Folder of the scenario's file; empty without one.
Result<std::filesystem::path> findPatient(const std::string& patient,
                                          const std::filesystem::path& folder);

/// Files of patient, array, friction and calibration that a scenario names.
std::vector<std::filesystem::path> filesOf(const ScenarioContent& scenario,
                                           const std::string& friction,
                                           const std::filesystem::path& folder);

}  // namespace perilymph::session
