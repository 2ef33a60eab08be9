// SPDX-License-Identifier: BSD-3-Clause
#include "gui/setup/PlanStore.h"

#include <algorithm>
#include <system_error>

#include "gui/run/StateFolder.h"
#include "gui/setup/Setup.h"
#include "perilymph/foundation/AtomicFile.h"
#include "perilymph/foundation/Sha256.h"
#include "perilymph/foundation/TomlReader.h"
#include "perilymph/foundation/Version.h"

namespace perilymph::gui {

namespace {

namespace fs = std::filesystem;

constexpr const char* patientFile = "patient.toml";
constexpr const char* requestFile = "plan.toml";
constexpr const char* notesFile = "notes.txt";
constexpr std::size_t keyLength = 8;  // hexadecimal digits

std::string quoted(const std::string& text) { return tomlQuoted(QString::fromStdString(text)); }

std::string requestText(const StoredPlan& plan)
{
  const planning::PlanRequest& request = plan.request;
  std::string arrays;
  for (const std::string& array : request.arrays)
    arrays += (arrays.empty() ? "" : ", ") + quoted(array);
  return "made = " + quoted(plan.madeUtc) + "\narrays = [" + arrays +
         "]\nscenario = " + quoted(request.scenario) +
         (request.friction ? "\nfriction = " + quoted(*request.friction) : "") +
         "\ndraws = " + std::to_string(request.draws) + "\nseed = " + std::to_string(request.seed) +
         "\nis_coarse = " + (request.resolution ? "true" : "false") +
         "\nshown_draws = " + std::to_string(plan.shownDraws) +
         "\nis_complete = " + (plan.isComplete ? "true" : "false") + "\n";
}

}  // namespace

fs::path plansFolder() { return stateFolder() / "plans"; }

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
  if (const auto saved = anatomy::savePatient(plan.request.patient, plan.folder / patientFile);
      !saved)
    return saved;
  return writeWhole(plan.folder / requestFile, requestText(plan));
}

Result<StoredPlan> readStoredPlan(const fs::path& folder)
{
  auto reader = TomlReader::open(folder / requestFile);
  if (!reader) return reader.error();
  constexpr long maxSeed = 1000000000;
  StoredPlan plan;
  plan.folder = folder;
  plan.madeUtc = reader->text("made");
  plan.request.arrays = reader->values("arrays");
  plan.request.scenario = reader->text("scenario");
  if (std::string friction = reader->text("friction", ""); !friction.empty())
    plan.request.friction = std::move(friction);
  const long draws = reader->integer("draws", 1, long(planning::maxDraws), 64);
  plan.request.draws = static_cast<std::size_t>(draws);
  plan.request.seed = static_cast<std::uint64_t>(reader->integer("seed", 0, maxSeed, 1));
  if (!reader->flag("is_coarse", true)) plan.request.resolution.reset();
  plan.shownDraws = static_cast<std::size_t>(reader->integer("shown_draws", 0, draws, 0));
  plan.isComplete = reader->flag("is_complete", false);
  if (const auto done = reader->finish(); !done) return done.error();
  const auto patient = anatomy::loadPatient(folder / patientFile);
  if (!patient) return patient.error();
  plan.request.patient = *patient;
  return plan;
}

std::vector<StoredPlan> storedPlans()
{
  std::vector<StoredPlan> plans;
  std::error_code failure;
  fs::directory_iterator entries(plansFolder(), failure);
  if (failure) return plans;  // none was made yet
  for (const fs::directory_entry& entry : entries)
    if (auto plan = readStoredPlan(entry.path())) plans.push_back(*std::move(plan));
  std::sort(plans.begin(), plans.end(), [](const StoredPlan& one, const StoredPlan& other) {
    return std::tie(one.madeUtc, one.folder) > std::tie(other.madeUtc, other.folder);
  });
  return plans;
}

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
