// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The files named by a scenario.

#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "perilymph/foundation/Result.h"
#include "perilymph/session/Scenario.h"

namespace perilymph::session {

/// Keys that name a shipped file or give a path.
inline constexpr std::array<const char*, 3> fileKeys = {"array", "friction", "calibration"};

/// Finds the file of a patient: beside the scenario, else by a shipped name or a path.
///
/// @param folder  Folder of the scenario's file; empty without one.
Result<std::filesystem::path> findPatient(const std::string& patient,
                                          const std::filesystem::path& folder);

/// A file beside the scenario as an absolute path, where a key gives its path; else what stands there.
std::string pathBeside(const std::string& nameOrFile, const std::filesystem::path& folder);

/// Files of patient, array, friction and calibration that a scenario names.
std::vector<std::filesystem::path> filesOf(const ScenarioContent& scenario,
                                           const std::string& friction,
                                           const std::filesystem::path& folder);

}  // namespace perilymph::session
