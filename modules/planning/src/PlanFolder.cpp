// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/planning/PlanFolder.h"

#include <algorithm>
#include <system_error>
#include <tuple>
#include <utility>

#include "perilymph/anatomy/Patient.h"
#include "perilymph/foundation/TomlReader.h"
#include "perilymph/planning/Plan.h"

namespace perilymph::planning {

namespace fs = std::filesystem;

Result<PlanFolder> readPlanFolder(const fs::path& folder)
{
  auto reader = TomlReader::open(folder / planRequestFile);
  if (!reader) return reader.error();
  constexpr long maxSeed = 1000000000;
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
