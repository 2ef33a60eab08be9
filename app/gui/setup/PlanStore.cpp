// SPDX-License-Identifier: BSD-3-Clause
#include "gui/setup/PlanStore.h"

#include <system_error>

#include "gui/setup/Setup.h"
#include "perilymph/foundation/AtomicFile.h"
#include "perilymph/foundation/Sha256.h"
#include "perilymph/foundation/StateFolder.h"
#include "perilymph/foundation/Version.h"

namespace perilymph::gui {

namespace {

namespace fs = std::filesystem;

constexpr const char* notesFile = "notes.txt";
constexpr std::size_t keyLength = 8;  // hexadecimal digits

std::string quoted(const std::string& text) { return tomlQuoted(QString::fromStdString(text)); }

/// The keys of an approach, as a scenario has them; none without one.
std::string approachText(const planning::PlanRequest& request)
{
  if (!request.approach) return {};
  const auto decimal = [](Angle angle) {
    return QString::number(inDegrees(angle), 'f', 2).toStdString();
  };
  return "\napproach_tilt_deg = " + decimal(request.approach->tilt) +
         "\napproach_turn_deg = " + decimal(request.approach->turn);
}

std::string requestText(const StoredPlan& plan)
{
  const planning::PlanRequest& request = plan.request;
  std::string arrays;
  for (const std::string& array : request.arrays)
    arrays += (arrays.empty() ? "" : ", ") + quoted(array);
  return "made = " + quoted(plan.madeUtc) + "\narrays = [" + arrays +
         "]\nscenario = " + quoted(request.scenario) +
         (request.friction ? "\nfriction = " + quoted(*request.friction) : "") +
         approachText(request) +
         (request.clinicResistance ? "\nclinic_resistance = " + quoted(*request.clinicResistance)
                                   : "") +
         "\ndraws = " + std::to_string(request.draws) + "\nseed = " + std::to_string(request.seed) +
         "\nis_coarse = " + (request.resolution ? "true" : "false") +
         "\nshown_draws = " + std::to_string(plan.shownDraws) +
         "\nis_complete = " + (plan.isComplete ? "true" : "false") + "\n";
}

}  // namespace

fs::path folderOfPlan(const planning::PlanRequest& request)
{
  Sha256 hash;
  const auto add = [&hash](const std::string& text) {
    hash.add(std::to_string(text.size()) + ":" + text);
  };
  add(buildId());
  // a request that cannot be planned gets a folder, too, and then an error
  const auto fingerprint = planning::fingerprintOf(request);
  add(fingerprint ? *fingerprint : fingerprint.error().message);
  const char* ear = request.patient.side == anatomy::Side::left ? "-left-" : "-right-";
  return plansFolder() /
         (fileNameOf(request.patient.label) + ear + hash.hex().substr(0, keyLength));
}

Result<void> savePlan(const StoredPlan& plan)
{
  std::error_code failure;
  fs::create_directories(plan.folder, failure);
  if (failure)
    return Error{
        "%1 cannot be created: %2. Check the permissions of its folder and the space on the disk.",
        plan.folder, failure.message()};
  if (const auto saved =
          anatomy::savePatient(plan.request.patient, plan.folder / planning::planPatientFile);
      !saved)
    return saved;
  return writeWhole(plan.folder / planning::planRequestFile, requestText(plan));
}

std::vector<StoredPlan> storedPlans() { return planning::planFoldersIn(plansFolder()).plans; }

QString notesOf(const fs::path& folder)
{
  const auto notes = readWhole(folder / notesFile);
  return notes ? QString::fromStdString(*notes) : QString();
}

Result<void> saveNotes(const fs::path& folder, const QString& notes)
{
  return writeWhole(folder / notesFile, notes.toStdString());
}

}  // namespace perilymph::gui
