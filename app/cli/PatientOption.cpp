// SPDX-License-Identifier: BSD-3-Clause
#include "PatientOption.h"

#include "Terminal.h"
#include "perilymph/foundation/Resources.h"

namespace perilymph::cli {

Result<anatomy::Patient> readPatient(const std::string& name)
{
  const auto file = findByName("patient", "resources/patients", name);
  if (!file) return file.error();
  auto patient = anatomy::loadPatient(*file);
  if (patient) printNoteOn(*patient);
  return patient;
}

void printNoteOn(const anatomy::Patient& patient)
{
  if (const std::string note = noteOn(patient); !note.empty()) printError("{}\n", note);
}

}  // namespace perilymph::cli
