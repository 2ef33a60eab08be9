// SPDX-License-Identifier: BSD-3-Clause
#include "gui/setup/PatientSetup.h"

#include <map>
#include <optional>
#include <utility>

#include "gui/run/UserSettings.h"
#include "gui/setup/EnteredMeasures.h"
#include "perilymph/anatomy/AnatomySource.h"
#include "perilymph/session/Csv.h"
#include "perilymph/session/InsertionParameters.h"

namespace perilymph::gui {

namespace {

/// Where a patient's measures come from: a CT only if the patient names it.
std::map<SetupField, ValueSource> sourcesOf(const anatomy::Patient& patient)
{
  const ValueSource source = isFromCt(patient) ? ValueSource::ct : ValueSource::typed;
  const auto sourceOf = [&](const char* measure) {
    return isEntered(patient, measure) ? ValueSource::typed : source;
  };
  std::map<SetupField, ValueSource> sources;
  if (patient.basalTurn) {
    sources[SetupField::lengthA] = sourceOf("A");
    sources[SetupField::widthB] = sourceOf("B");
    if (patient.basalTurn->h) sources[SetupField::heightH] = sourceOf("H");
    return sources;
  }
  for (const SetupField field :
       {SetupField::scalaLength, SetupField::windowWidth, SetupField::windowHeight})
    sources[field] = source;
  return sources;
}

const QString lastArrayKey = QStringLiteral("insertion/array");

}  // namespace

Result<session::Scenario> surgicalScenario(const planning::PlanRequest& request,
                                           const std::string& array)
{
  const auto any = planning::scenarioOf(request, array, session::anyStopTravel);
  if (!any) return any.error();
  const Length full = session::fullTravel(any->array(), any->startInside());
  return planning::scenarioOf(request, array, session::shortestDecimal(inMillimeters(full)));
}

std::string lastArray()
{
  const std::string kept = UserSettings().value(lastArrayKey).toString().toStdString();
  const planning::PlanRequest usual;
  // its file may be gone
  if (!kept.empty() && planning::scenarioOf(usual, kept, session::anyStopTravel)) return kept;
  const auto scenario = session::loadScenario(usual.scenario);
  return scenario ? scenario->arrayName() : std::string();
}

void rememberArray(const session::Scenario& scenario)
{
  if (!scenario.patient().basalTurn) return;
  UserSettings().setValue(lastArrayKey, QString::fromStdString(scenario.arrayName()));
}

Result<Setup> setupOfPatient(const anatomy::Patient& patient, const session::Scenario* base)
{
  if (const auto possible = anatomy::checkPatient(patient); !possible) return possible.error();
  std::optional<session::Scenario> preset;
  if (base == nullptr) {
    auto usual = patient.basalTurn ? surgicalScenario({}, lastArray())
                                   : session::loadScenario("contour-published");
    if (!usual) return usual.error();
    preset = *std::move(usual);
    base = &*preset;
  }
  auto own = withPatient(*base, patient);
  if (!own) return own.error();
  return Setup{*std::move(own), sourcesOf(patient)};
}

Result<Setup> setupOfPatientFile(const std::filesystem::path& file)
{
  const auto patient = anatomy::loadPatient(file);
  if (!patient) return patient.error();
  return setupOfPatient(*patient);
}

}  // namespace perilymph::gui
