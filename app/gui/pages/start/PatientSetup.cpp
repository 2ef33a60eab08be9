// SPDX-License-Identifier: BSD-3-Clause
#include "gui/pages/start/PatientSetup.h"

#include <filesystem>
#include <map>
#include <system_error>

#include "perilymph/anatomy/Population.h"
#include "perilymph/foundation/Resources.h"

namespace perilymph::gui {

namespace {

std::map<SetupField, ValueSource> measuredInCt(const anatomy::Patient& patient)
{
  const anatomy::Patient usual;
  std::map<SetupField, ValueSource> provenance;
  const auto note = [&provenance](SetupField field, bool isGiven) {
    if (isGiven) provenance[field] = ValueSource::ct;
  };
  if (const auto& turn = patient.basalTurn) {
    note(SetupField::lengthA, turn->a != anatomy::spreadOfA().mean);
    note(SetupField::widthB, turn->b != anatomy::spreadOfB().mean);
    note(SetupField::heightH, turn->h.has_value());
    return provenance;
  }
  note(SetupField::scalaLength, patient.scalaTympaniLength != usual.scalaTympaniLength);
  note(SetupField::windowWidth, patient.roundWindowWidth != usual.roundWindowWidth);
  note(SetupField::windowHeight, patient.roundWindowHeight != usual.roundWindowHeight);
  return provenance;
}

}  // namespace

Result<Setup> setupOfPatient(const anatomy::Patient& patient)
{
  if (const auto possible = anatomy::checkPatient(patient); !possible) return possible.error();
  const auto file = patientFolder() / fileNameOf(patient.label);
  std::error_code ignored;  // an error is reported when the file is written
  std::filesystem::create_directories(file.parent_path(), ignored);
  if (const auto saved = anatomy::savePatient(patient, file); !saved) return saved.error();
  const auto preset = session::loadScenario(
      patient.basalTurn ? "mean-contour" : "contour-published", {{"patient", file.string()}});
  if (!preset) return preset.error();
  auto own = asOwn(*preset);
  if (!own) return own.error();
  return Setup{*std::move(own), measuredInCt(patient)};
}

}  // namespace perilymph::gui
