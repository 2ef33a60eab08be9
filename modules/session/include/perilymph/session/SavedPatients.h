// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The patients in a folder: a file for each code and ear, with its record.

#include <filesystem>
#include <vector>

#include "perilymph/anatomy/Patient.h"
#include "perilymph/foundation/Sentence.h"
#include "perilymph/session/PatientRecord.h"

namespace perilymph::session {

struct SavedPatient {
  anatomy::Patient patient;
  std::filesystem::path file;
  PatientRecord record = {};  ///< Empty if it cannot be read.
};

struct SavedPatients {
  std::vector<SavedPatient> patients;  ///< The last used first.
  std::vector<Sentence> unreadable;    ///< Why a patient or a record cannot be read, with its file.
};

/// Reads the patients of a folder; none of a folder that does not exist.
SavedPatients readPatients(const std::filesystem::path& folder);

/// Whether two patients have the same measures, errors, scan and landmarks.
bool haveSameMeasures(const anatomy::Patient& one, const anatomy::Patient& other);

}  // namespace perilymph::session
