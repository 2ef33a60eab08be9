// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Converts a patient's numbers to a setup.

#include <filesystem>
#include <string>

#include "gui/setup/Setup.h"
#include "perilymph/anatomy/Patient.h"
#include "perilymph/foundation/Result.h"
#include "perilymph/planning/PlanRequest.h"

namespace perilymph::gui {

/// The scenario of a plan with one of its arrays, inserted fully.
Result<session::Scenario> surgicalScenario(const planning::PlanRequest& request,
                                           const std::string& array);

/// The array that was last inserted into a patient's cochlea; before the first, that of the plans'
/// scenario.
std::string lastArray();
/// Keeps the array of a patient's insertion for the next one.
void rememberArray(const session::Scenario& scenario);

/// A setup with a patient's cochlea, whose numbers count as measured in CT. The scenario carries the
/// numbers themselves and no path of a file.
///
/// @param base  Array, technique, friction and all else; if null, those of a plan with the last
///              array, or of the published cochlea if A and B are not given.
Result<Setup> setupOfPatient(const anatomy::Patient& patient,
                             const session::Scenario* base = nullptr);

/// The same of a patient file (.toml).
Result<Setup> setupOfPatientFile(const std::filesystem::path& file);

}  // namespace perilymph::gui
