// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Patients that a call names.

#include <string>

#include "perilymph/anatomy/Patient.h"

namespace perilymph::cli {

/// Reads a shipped patient or a patient's file, and says on standard error if its measures were
/// changed by hand or carry no seal.
Result<anatomy::Patient> readPatient(const std::string& name);

/// What readPatient() says, of a patient that a scenario names.
void printNoteOn(const anatomy::Patient& patient);

}  // namespace perilymph::cli
