// SPDX-License-Identifier: BSD-3-Clause
#include "gui/pages/ct/MeasuredSetup.h"

#include <filesystem>
#include <system_error>

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
  const auto preset = session::loadScenario("mean-contour", {{"patient", file.string()}});
  if (!preset) return preset.error();
  auto own = asOwn(*preset);
  if (!own) return own.error();
  std::map<SetupField, ValueSource> sources{{SetupField::lengthA, ValueSource::ct},
                                            {SetupField::widthB, ValueSource::ct}};
  if (own->patient().basalTurn && own->patient().basalTurn->h)
    sources[SetupField::heightH] = ValueSource::ct;
  return Setup{*std::move(own), std::move(sources)};
}

}  // namespace perilymph::gui
