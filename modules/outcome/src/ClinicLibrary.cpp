// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/outcome/ClinicLibrary.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <map>
#include <utility>

#include "StopLengths.h"
#include "perilymph/outcome/OutcomeText.h"
#include "perilymph/planning/Plan.h"
#include "perilymph/planning/PlanFolder.h"
#include "perilymph/planning/PlanReading.h"
#include "perilymph/session/SavedPatients.h"

namespace perilymph::outcome {

namespace {

/// Probability of a translocation from which on an array counts as translocated.
constexpr double likely = 0.5;

/// One ear with its newest outcome.
struct Implanted {
  const session::SavedPatient* saved = nullptr;
  OutcomeContent content;
  std::string surgeryDay;
  Sentence name;  ///< "P-017, left ear", for notes.
};

/// The plans of a library, with their numbers.
struct NumberedPlan {
  planning::PlanFolder folder;
  std::string number;
};

std::vector<NumberedPlan> plansIn(const std::filesystem::path& folder)
{
  std::vector<NumberedPlan> plans;
  for (planning::PlanFolder& each : planning::planFoldersIn(folder)) {
    if (each.shownDraws == 0) continue;  // it has no numbers yet
    const auto stored = planning::readPlan(each.folder);
    plans.push_back({std::move(each), stored ? stored->plan.fingerprint : std::string()});
  }
  return plans;
}

std::size_t placeOf(const planning::PlanFolder& plan, const std::string& array)
{
  const auto& arrays = plan.request.arrays;
  return static_cast<std::size_t>(std::find(arrays.begin(), arrays.end(), array) - arrays.begin());
}

bool isOf(const planning::PlanFolder& plan, const anatomy::Patient& patient)
{
  return plan.request.patient.label == patient.label && plan.request.patient.side == patient.side;
}

/// The plan that an ear's outcome is compared with; the newest that is suitable.
const NumberedPlan* planOf(const std::vector<NumberedPlan>& plans, const Implanted& ear)
{
  const auto found = std::find_if(plans.begin(), plans.end(), [&](const NumberedPlan& each) {
    if (placeOf(each.folder, ear.content.found.array) == each.folder.request.arrays.size())
      return false;
    if (!isOf(each.folder, ear.saved->patient)) return false;
    if (!ear.content.plan.empty() && each.number != ear.content.plan) return false;
    return each.folder.madeUtc.substr(0, ear.surgeryDay.size()) <= ear.surgeryDay;
  });
  return found == plans.end() ? nullptr : &*found;
}

/// Values of a plan's array as its simulations ended; notes what hinders stop lengths.
Result<PlannedOutcome> plannedOf(const NumberedPlan& numbered, const Implanted& ear,
                                 bool isInformative, std::vector<Sentence>& notes,
                                 const analysis::RunProgress& progress, const std::stop_token& stop)
{
  planning::PlanRequest request = numbered.folder.request;
  request.draws = numbered.folder.shownDraws;
  const std::size_t array = placeOf(numbered.folder, ear.content.found.array);
  const auto plan = planning::viewPlan(request, numbered.folder.folder / planning::planDrawsFile);
  if (!plan) return plan.error();
  PlannedOutcome planned;
  for (const planning::PlannedInsertion& each : plan->insertions) {
    if (each.array != array || each.insertion.end == haptics::InsertionEnd::refused) continue;
    planned.depths_mm.push_back(inMillimeters(each.insertion.depth));
    planned.angles_deg.push_back(inDegrees(each.insertion.apical));
  }
  const auto scenario =
      planning::scenarioOf(request, request.arrays[array], session::anyStopTravel);
  if (!scenario) return scenario.error();
  const session::InsertionParameters& parameters = scenario->parameters();
  planned.friction = parameters.friction.staticCoefficient;
  planned.insertable_mm = inMillimeters(
      parameters.startInside + session::fullTravel(parameters.array, parameters.startInside));
  if (!isInformative) return planned;
  const auto number = planning::fingerprintOf(request);
  if (!number || plan->fingerprint != *number || !parameters.frictionSpread.isKnown()) {
    notes.push_back(Sentence{
        "%1: the plan's simulations cannot be run again as they were made, so that its length "
        "tells nothing about resistance.",
        ear.name});
    return planned;
  }
  const auto lengths = stopLengths(request, array, numbered.folder.folder, progress, stop);
  if (stop.stop_requested()) return Error{"The outcomes were canceled."};
  if (!lengths) {
    notes.push_back(Sentence{"%1: %2", ear.name, lengths.error().message});
    return planned;
  }
  planning::StopDraws draws;
  draws.logFrictionSd = std::hypot(parameters.frictionSpread.shared, parameters.frictionSpread.ear);
  for (const planning::UnstoppedDraw& each : *lengths)
    if (each.curve.end != haptics::InsertionEnd::refused)
      draws.draws.push_back(planning::stopDrawOf(each));
  planned.stops = std::move(draws);
  return planned;
}

}  // namespace

std::string surgeryDay(const std::string& utc, int daysBefore)
{
  int year = 0;
  unsigned month = 0, day = 0;
  if (std::sscanf(utc.c_str(), "%4d-%2u-%2u", &year, &month, &day) != 3) return {};
  const std::chrono::year_month_day date{std::chrono::year(year), std::chrono::month(month),
                                         std::chrono::day(day)};
  if (!date.ok()) return {};
  const std::chrono::year_month_day before{std::chrono::sys_days(date) -
                                           std::chrono::days(daysBefore)};
  char text[32];
  std::snprintf(text, sizeof text, "%04d-%02u-%02u", static_cast<int>(before.year()),
                static_cast<unsigned>(before.month()), static_cast<unsigned>(before.day()));
  return text;
}

Result<LibraryOutcomes> readOutcomes(const planning::RegistryFolders& folders,
                                     const analysis::RunProgress& progress,
                                     const std::stop_token& stop, StopLengths lengths)
{
  auto read = session::readPatients(folders.patients);
  LibraryOutcomes library;
  library.notes = std::move(read.unreadable);
  std::vector<Implanted> ears;
  for (const session::SavedPatient& each : read.patients) {
    if (each.record.outcomes.empty()) continue;
    const session::PatientOutcome& newest = each.record.outcomes.back();
    const Sentence name{
        "%1, %2", each.patient.label,
        each.patient.side == anatomy::Side::left ? Sentence{"left ear"} : Sentence{"right ear"}};
    auto content = outcomeIn(newest.content, name);
    if (!content) {
      library.notes.push_back(content.error().message);
      continue;
    }
    const int days = content->surgery.daysToCt.value_or(0);
    ears.push_back({&each, *std::move(content), surgeryDay(newest.utc, days), name});
  }
  const std::vector<NumberedPlan> plans =
      ears.empty() ? std::vector<NumberedPlan>() : plansIn(folders.plans);
  for (const Implanted& ear : ears) {
    if (stop.stop_requested()) return Error{"The outcomes were canceled."};
    const FoundArray& found = ear.content.found;
    const NumberedPlan* plan = planOf(plans, ear);
    if (plan == nullptr) {
      library.notes.push_back(
          Sentence{"%1 is left out: no plan of %2 was made for it before the surgery.", ear.name,
                   found.array});
      continue;
    }
    MeasuredOutcome outcome;
    outcome.surgeryUtc = ear.surgeryDay;
    outcome.array = found.array;
    outcome.surgery = ear.content.surgery;
    outcome.depth_mm = {found.insertedLength_mm, found.insertedLengthSd_mm};
    if (found.contactsInside > 0) outcome.angle_deg = found.angularInsertionDepth_deg;
    outcome.isDisplaced = found.isFolded || found.translocationProbability > likely;
    const bool isInformative = lengths == StopLengths::computed &&
                               evidenceOf(outcome.surgery, outcome.isDisplaced) != Evidence::none;
    auto planned = plannedOf(*plan, ear, isInformative, library.notes, progress, stop);
    if (stop.stop_requested()) return Error{"The outcomes were canceled."};
    if (!planned) {
      library.notes.push_back(Sentence{"%1 is left out: %2", ear.name, planned.error().message});
      continue;
    }
    outcome.plan = *std::move(planned);
    library.outcomes.push_back(std::move(outcome));
    library.patients.push_back(ear.saved->patient);
  }
  return library;
}

}  // namespace perilymph::outcome
