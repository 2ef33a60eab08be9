// SPDX-License-Identifier: BSD-3-Clause
#include "gui/pages/ct/MeasuredSetup.h"

#include <filesystem>
#include <system_error>

#include "gui/setup/PatientSetup.h"
#include "perilymph/foundation/Resources.h"
#include "perilymph/imaging/MeasuredPatient.h"

namespace perilymph::gui {

Result<Setup> setupOfMeasures(const ct::CochleaMeasures& measures, const QString& code)
{
  const auto file = patientFolder() / fileNameOf(code.toStdString());
  std::error_code ignored;  // an error is reported when the file is written
  std::filesystem::create_directories(file.parent_path(), ignored);
  if (const auto saved = imaging::writeMeasuredPatient(measures, file); !saved)
    return saved.error();
  // the scenario carries the measures and not the path of the file
  const auto patient = anatomy::loadPatient(file);
  if (!patient) return patient.error();
  return setupOfPatient(*patient);
}

}  // namespace perilymph::gui
