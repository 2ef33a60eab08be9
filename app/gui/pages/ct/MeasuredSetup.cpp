// SPDX-License-Identifier: BSD-3-Clause
#include "gui/pages/ct/MeasuredSetup.h"

#include <filesystem>
#include <system_error>

#include "gui/setup/PatientLibrary.h"
#include "gui/setup/PatientSetup.h"
#include "perilymph/imaging/MeasuredPatient.h"

namespace perilymph::gui {

Result<anatomy::Patient> patientOfMeasures(const ct::CochleaMeasures& measures, const QString& code)
{
  anatomy::Patient named = imaging::measuredPatient(measures);
  named.label = code.toStdString();
  // each ear of a patient has a file of its own
  const auto file = libraryFileOf(named);
  std::error_code ignored;  // an error is reported when the file is written
  std::filesystem::create_directories(file.parent_path(), ignored);
  if (const auto saved = imaging::writeMeasuredPatient(measures, named.label, file); !saved)
    return saved.error();
  // the scenario carries the measures and not the path of the file
  return anatomy::loadPatient(file);
}

Result<Setup> setupOfMeasures(const ct::CochleaMeasures& measures, const QString& code)
{
  const auto patient = patientOfMeasures(measures, code);
  if (!patient) return patient.error();
  return setupOfPatient(*patient);
}

}  // namespace perilymph::gui
