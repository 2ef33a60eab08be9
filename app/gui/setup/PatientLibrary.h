// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The patients saved by the user: a file for each code and ear in the patient folder.

#include <QString>
#include <filesystem>
#include <optional>
#include <vector>

#include "perilymph/anatomy/Patient.h"
#include "perilymph/foundation/Result.h"
#include "perilymph/session/SavedPatients.h"

namespace perilymph::gui {

using session::SavedPatient;

/// The readable patients of the patient folder, the last used first.
std::vector<SavedPatient> savedPatients();

/// The saved patient with a code and an ear; empty if there is none.
std::optional<SavedPatient> findSavedPatient(const std::string& code, anatomy::Side side);

/// Whether a patient's cochlea was measured in a CT, as the patient or the saved one with the code
/// states.
bool isMeasuredInCt(const anatomy::Patient& patient);

/// The file in which a code and an ear are saved: "P-017-left.toml", or the one that has them.
std::filesystem::path libraryFileOf(const anatomy::Patient& patient);

/// Saves a patient as "P-017-left.toml", with a new version in its record. An error if the code is
/// not one, if another file has this code and ear, and while another program works on it.
///
/// @param replaced  The patient's previous file, if it was saved before.
Result<std::filesystem::path> savePatientInLibrary(
    const anatomy::Patient& patient,
    const std::optional<std::filesystem::path>& replaced = std::nullopt);

/// Makes a patient the first of savedPatients().
void markUsed(const std::filesystem::path& file);

/// "P-017 · left ear"
QString nameOfPatient(const anatomy::Patient& patient);

/// "EAS, revision"
QString tagsText(const session::PatientRecord& record);

/// " · measures changed by hand", or nothing.
QString handChange(const anatomy::Patient& patient);

/// "A 9.20, B 6.80 mm", or the three lengths; "changed by hand: ..." first.
QString numbersOfPatient(const anatomy::Patient& patient);

}  // namespace perilymph::gui
