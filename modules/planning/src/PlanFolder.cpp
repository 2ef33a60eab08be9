// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/planning/PlanFolder.h"

#include <algorithm>
#include <system_error>
#include <tuple>
#include <utility>

#include "PlanNames.h"
#include "perilymph/anatomy/Patient.h"
#include "perilymph/figures/Strings.h"
#include "perilymph/foundation/AtomicFile.h"
#include "perilymph/foundation/Resources.h"
#include "perilymph/foundation/TomlQuoted.h"
#include "perilymph/foundation/TomlReader.h"
#include "perilymph/planning/Plan.h"

namespace perilymph::planning {

namespace fs = std::filesystem;

namespace {

/// What a request names, quoted: a shipped name as it is, a file by its absolute path.
std::string placeOf(std::string_view kind, std::string_view shipped, const std::string& nameOrFile)
{
  const auto file = findByName(kind, shipped, nameOrFile);
  std::error_code ignored;
  if (!file || *file != fs::path(nameOrFile)) return tomlQuoted(nameOrFile);
  return tomlQuoted(fs::absolute(*file, ignored).lexically_normal().string());
}

std::string requestText(const PlanFolder& plan)
{
  const PlanRequest& request = plan.request;
  std::string arrays;
  for (const std::string& array : request.arrays)
    arrays += (arrays.empty() ? "" : ", ") + placeOf("array", "plugins/electrodes", array);
  std::string text = "made = " + tomlQuoted(plan.madeUtc) + "\narrays = [" + arrays +
                     "]\nscenario = " + tomlQuoted(request.scenario);
  if (request.friction)
    text += "\nfriction = " + placeOf("friction", "resources/friction", *request.friction);
  if (const auto& approach = request.approach)
    text += "\napproach_tilt_deg = " + figures::fixed(inDegrees(approach->tilt), 2) +
            "\napproach_turn_deg = " + figures::fixed(inDegrees(approach->turn), 2);
  if (request.clinicResistance) {
    std::error_code ignored;
    text +=
        "\nclinic_resistance = " +
        tomlQuoted(fs::absolute(*request.clinicResistance, ignored).lexically_normal().string());
  }
  return text + "\ndraws = " + std::to_string(request.draws) +
         "\nseed = " + std::to_string(request.seed) +
         "\nis_coarse = " + (request.resolution ? "true" : "false") +
         "\nshown_draws = " + std::to_string(plan.shownDraws) +
         "\nis_complete = " + (plan.isComplete ? "true" : "false") + "\n";
}

}  // namespace

std::vector<std::pair<std::string, std::string>> requestFiles(const PlanFolder& plan)
{
  return {{planPatientFile, anatomy::patientText(plan.request.patient)},
          {planRequestFile, requestText(plan)}};
}

Result<void> savePlanFolder(const PlanFolder& plan)
{
  std::error_code failure;
  fs::create_directories(plan.folder, failure);
  if (failure)
    return Error{
        "%1 cannot be created: %2. Check the permissions of its folder and the space on the disk.",
        plan.folder, failure.message()};
  for (const auto& [name, text] : requestFiles(plan))
    if (const auto done = writeWhole(plan.folder / name, text, {Links::refused, Audience::owner});
        !done)
      return done;
  return {};
}

Result<PlanFolder> readPlanFolder(const fs::path& folder)
{
  std::error_code ignored;
  if (fs::exists(folder / planJsonFile, ignored) && !fs::exists(folder / planRequestFile, ignored))
    return Error{
        "%1 has a %2 but no %3, which 'perilymph-cli plan' did not write in former versions. Make "
        "the plan again, into another folder.",
        folder, planJsonFile, planRequestFile};
  auto reader = TomlReader::open(folder / planRequestFile);
  if (!reader) return reader.error();
  PlanFolder plan;
  plan.folder = folder;
  plan.madeUtc = reader->text("made");
  plan.request.arrays = reader->values("arrays");
  plan.request.scenario = reader->text("scenario");
  if (std::string friction = reader->text("friction", ""); !friction.empty())
    plan.request.friction = std::move(friction);
  if (reader->has("approach_tilt_deg") || reader->has("approach_turn_deg")) {
    constexpr Range approach_deg{-anatomy::steepestApproach_deg, anatomy::steepestApproach_deg};
    plan.request.approach =
        anatomy::Approach{degrees(reader->number("approach_tilt_deg", approach_deg)),
                          degrees(reader->number("approach_turn_deg", approach_deg))};
  }
  if (std::string clinic = reader->text("clinic_resistance", ""); !clinic.empty())
    plan.request.clinicResistance = std::move(clinic);
  const long draws = reader->integer("draws", 1, long(maxDraws), 64);
  plan.request.draws = static_cast<std::size_t>(draws);
  plan.request.seed = static_cast<std::uint64_t>(reader->integer("seed", 0, maxSeed, 1));
  if (!reader->flag("is_coarse", true)) plan.request.resolution.reset();
  plan.shownDraws = static_cast<std::size_t>(reader->integer("shown_draws", 0, draws, 0));
  plan.isComplete = reader->flag("is_complete", false);
  if (const auto done = reader->finish(); !done) return done.error();
  const auto patient = anatomy::loadPatient(folder / planPatientFile);
  if (!patient) return patient.error();
  plan.request.patient = *patient;
  return plan;
}

PlanFolders planFoldersIn(const fs::path& plans)
{
  PlanFolders found;
  std::error_code failure;
  fs::directory_iterator entries(plans, failure);
  if (failure) return found;  // none was made yet
  for (const fs::directory_entry& entry : entries) {
    auto plan = readPlanFolder(entry.path());
    if (plan)
      found.plans.push_back(*std::move(plan));
    else if (fs::exists(entry.path() / planRequestFile, failure))
      found.unreadable.push_back(plan.error().message);
  }
  const auto isNewer = [](const PlanFolder& one, const PlanFolder& other) {
    return std::tie(one.madeUtc, one.folder) > std::tie(other.madeUtc, other.folder);
  };
  std::sort(found.plans.begin(), found.plans.end(), isNewer);
  return found;
}

}  // namespace perilymph::planning
