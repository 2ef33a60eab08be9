// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Converts a patient's numbers to a setup.

#include <filesystem>

#include "gui/setup/Setup.h"
#include "perilymph/anatomy/Patient.h"
#include "perilymph/foundation/Result.h"

namespace perilymph::gui {

/// A setup with a patient's cochlea, whose numbers count as measured in CT. The scenario carries the
/// numbers themselves and no path of a file.
///
/// @param base  Array, technique, friction and all else; if null, those of a shipped preset: with
///              the mean cochlea if A and B are given, else with the published one.
Result<Setup> setupOfPatient(const anatomy::Patient& patient,
                             const session::Scenario* base = nullptr);

/// The same of a patient file (.toml).
Result<Setup> setupOfPatientFile(const std::filesystem::path& file);

}  // namespace perilymph::gui
