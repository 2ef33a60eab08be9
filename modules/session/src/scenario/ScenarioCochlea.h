// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The keys of a scenario that say whose cochlea it is.

#include <filesystem>
#include <string>

#include "perilymph/anatomy/AnatomySource.h"
#include "perilymph/foundation/Result.h"
#include "scenario/EffectiveText.h"

namespace perilymph::session {

/// Reads `anatomy` and the patient's numbers: those of the text, or of the file that `patient`
/// names. The key `side` is read later, over the patient's own.
///
/// @param patient        Value of the key `patient`; empty without.
/// @param folder         Folder of the scenario's file; empty without one.
/// @param isOverridden   The patient came as an override, so numbers in the text no longer hold.
/// @return               What is wrong with the patient's file; what is wrong with the keys, the
///                       reader keeps.
Result<void> readCochlea(TomlReader& reader, ScenarioKeys& keys, const std::string& patient,
                         const std::filesystem::path& folder, bool isOverridden,
                         anatomy::Cochlea& cochlea);

}  // namespace perilymph::session
