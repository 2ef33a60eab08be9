// SPDX-License-Identifier: BSD-3-Clause
#include "gui/setup/PatientSetup.h"

#include <map>
#include <optional>
#include <utility>

#include "perilymph/anatomy/AnatomySource.h"

namespace perilymph::gui {

namespace {

/// What was measured in a CT, unless it was changed afterward.
std::map<SetupField, ValueSource> measuredInCt(const anatomy::Patient& patient)
{
  std::map<SetupField, ValueSource> sources;
  if (patient.seal == Seal::changed) return sources;
  if (patient.basalTurn) {
    sources[SetupField::lengthA] = ValueSource::ct;
    sources[SetupField::widthB] = ValueSource::ct;
    if (patient.basalTurn->h) sources[SetupField::heightH] = ValueSource::ct;
    return sources;
  }
  for (const SetupField field :
       {SetupField::scalaLength, SetupField::windowWidth, SetupField::windowHeight})
    sources[field] = ValueSource::ct;
  return sources;
}

}  // namespace

Result<Setup> setupOfPatient(const anatomy::Patient& patient, const session::Scenario* base)
{
  if (const auto possible = anatomy::checkPatient(patient); !possible) return possible.error();
  std::optional<session::Scenario> preset;
  if (base == nullptr) {
    auto shipped = session::loadScenario(patient.basalTurn ? "mean-contour" : "contour-published");
    if (!shipped) return shipped.error();
    preset = *std::move(shipped);
    base = &*preset;
  }
  auto own = withPatient(*base, patient);
  if (!own) return own.error();
  return Setup{*std::move(own), measuredInCt(patient)};
}

Result<Setup> setupOfPatientFile(const std::filesystem::path& file)
{
  const auto patient = anatomy::loadPatient(file);
  if (!patient) return patient.error();
  return setupOfPatient(*patient);
}

}  // namespace perilymph::gui
