// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/outcome/ClinicLibrary.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <map>
#include <set>
#include <tuple>
#include <utility>

#include "StopLengths.h"
#include "perilymph/anatomy/EarWords.h"
#include "perilymph/outcome/OutcomeText.h"
#include "perilymph/planning/Plan.h"
#include "perilymph/planning/PlanFolder.h"
#include "perilymph/planning/PlanReading.h"
#include "perilymph/session/SavedPatients.h"

namespace perilymph::outcome {

namespace {

/// Probability of a translocation from which on an array counts as translocated.
constexpr double likely = 0.5;
/// Difference between two statements of one angle: files have six digits at least (choice, high).
constexpr double sameAngle_deg = 0.05;
/// Digits by which a hash is named in sentences.
constexpr std::size_t shownDigits = 12;

/// One ear with its newest outcome.
struct Implanted {
  const session::SavedPatient* saved = nullptr;
  OutcomeContent content;
  std::string surgeryDay;
  std::string series;  ///< SHA-256 of the CT after surgery.
  Sentence name;       ///< "P-017, left ear", for notes.
};

/// The plans of a library, with their numbers.
struct NumberedPlan {
  planning::PlanFolder folder;
  std::string number;
};

/// "2026-11-20"
std::string textOf(std::chrono::sys_days day)
{
  const std::chrono::year_month_day date{day};
  char text[32];
  std::snprintf(text, sizeof text, "%04d-%02u-%02u", static_cast<int>(date.year()),
                static_cast<unsigned>(date.month()), static_cast<unsigned>(date.day()));
  return text;
}

std::vector<NumberedPlan> plansIn(const std::filesystem::path& folder, std::vector<Sentence>& notes)
{
  planning::PlanFolders read = planning::planFoldersIn(folder);
  for (const Sentence& each : read.unreadable)
    notes.push_back(
        Sentence{"A plan cannot be read, and no outcome is compared with it. %1", each});
  std::vector<NumberedPlan> plans;
  for (planning::PlanFolder& each : read.plans) {
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
Result<const NumberedPlan*> planOf(const std::vector<NumberedPlan>& plans, const Implanted& ear)
{
  const OutcomeContent& content = ear.content;
  const auto found = std::find_if(plans.begin(), plans.end(), [&](const NumberedPlan& each) {
    if (placeOf(each.folder, content.found.array) == each.folder.request.arrays.size())
      return false;
    if (!isOf(each.folder, ear.saved->patient)) return false;
    if (!content.plan.empty() && each.number != content.plan) return false;
    return isPrediction(each.folder.madeUtc, ear.surgeryDay);
  });
  if (found != plans.end()) return &*found;
  if (!content.plan.empty())
    return Error{
        "%1 is left out: its plan %2 with %3 is not there as it was made before the surgery. "
        "Restore "
        "the plan's folder.",
        ear.name, content.plan.substr(0, shownDigits), content.found.array};
  return Error{"%1 is left out: no plan of %2 was made for it before the surgery.", ear.name,
               content.found.array};
}

/// Refuses statements of one thing that differ: in the outcome, in the record and in the patient's file.
Result<void> checkStatements(const Implanted& ear, const session::PatientOutcome& saved)
{
  const FoundArray& found = ear.content.found;
  const Surgery& surgery = ear.content.surgery;
  if (found.side != ear.saved->patient.side)
    return Error{"its outcome is of the %1. Find the contacts in the CT of this ear again.",
                 anatomy::earOf(found.side)};
  if (!surgery.array.empty() && surgery.array != found.array)
    return Error{
        "%1 was found in the CT and %2 was implanted as the surgeon says. Find the contacts again "
        "with the array that was implanted.",
        found.array, surgery.array};
  if (!ear.content.series.empty() && ear.content.series != saved.series)
    return Error{
        "the record and its outcome name different CT series, %1 and %2. Find the contacts again.",
        saved.series.substr(0, shownDigits), ear.content.series.substr(0, shownDigits)};
  const auto apical = std::find_if(found.contacts.begin(), found.contacts.end(),
                                   [](const FoundContact& each) { return each.isInside; });
  if (apical != found.contacts.end() &&
      std::fabs(apical->angle_deg.value - found.angularInsertionDepth_deg.value) > sameAngle_deg)
    return Error{
        "its angular insertion depth is %1 degrees, and its most apical contact inside lies at %2. "
        "Find the contacts again.",
        std::to_string(found.angularInsertionDepth_deg.value),
        std::to_string(apical->angle_deg.value)};
  const std::string tomorrow =
      textOf(std::chrono::floor<std::chrono::days>(std::chrono::system_clock::now()) +
             std::chrono::days(1));
  const std::string savedOn = dayBefore(saved.utc, 0);
  if (savedOn.empty())
    return Error{"its outcome was saved on \"%1\", which is no day. Find the contacts again.",
                 saved.utc};
  if (savedOn > tomorrow)  // clocks differ by less than a day
    return Error{
        "its outcome was saved on %1, which is still to come. Set the clock, and find the contacts "
        "again.",
        savedOn};
  return {};
}

/// Leaves out ears that stand in two files, but for one of them, and those that share a CT with another
/// patient, of whom one is wrong.
void leaveOutTwice(std::vector<Implanted>& ears, LibraryOutcomes& library)
{
  std::map<std::pair<std::string, anatomy::Side>, const Implanted*> first;
  std::map<std::string, std::set<std::string>> patientsOf;
  for (const Implanted& ear : ears) patientsOf[ear.series].insert(ear.saved->patient.label);
  std::vector<Implanted> kept;
  for (const Implanted& ear : ears) {
    const anatomy::Patient& patient = ear.saved->patient;
    const auto [same, isFirst] = first.try_emplace({patient.label, patient.side}, &ear);
    const std::set<std::string>& patients = patientsOf[ear.series];
    if (!isFirst) {
      library.notes.push_back(
          Sentence{"%1 of %2 is left out: the same ear is in %3. Give one of them another code.",
                   ear.name, ear.saved->file, same->second->saved->file});
    } else if (patients.size() > 1) {
      const std::string& other =
          *patients.begin() == patient.label ? *patients.rbegin() : *patients.begin();
      library.notes.push_back(Sentence{
          "%1 is left out: its CT after surgery (%2) is also that of %3. Remove the CT that is not "
          "this patient's and find the contacts again.",
          ear.name, ear.series.substr(0, shownDigits), other});
    } else {
      kept.push_back(ear);
      continue;
    }
    ++library.leftOut.twice;
  }
  ears = std::move(kept);
}

/// The ears with an outcome that can be read, in the order of surgery, then of codes.
std::vector<Implanted> implantedIn(const std::vector<session::SavedPatient>& patients,
                                   LibraryOutcomes& library)
{
  std::vector<Implanted> ears;
  for (const session::SavedPatient& each : patients) {
    if (each.record.outcomes.empty()) continue;
    const session::PatientOutcome& newest = each.record.outcomes.back();
    Implanted ear;
    ear.saved = &each;
    ear.series = newest.series;
    ear.name = Sentence{"%1, %2", each.patient.label, anatomy::earOf(each.patient.side)};
    auto content = outcomeIn(newest.content, ear.name);
    if (!content) {
      ++library.leftOut.unreadable;
      library.notes.push_back(Sentence{"%1 is left out: %2", ear.name, content.error().message});
      continue;
    }
    ear.content = *std::move(content);
    if (const auto done = checkStatements(ear, newest); !done) {
      ++library.leftOut.impossible;
      library.notes.push_back(Sentence{"%1 is left out: %2", ear.name, done.error().message});
      continue;
    }
    if (each.record.isChangedByHand)
      library.notes.push_back(
          Sentence{"%1 was changed by hand; its outcome is compared as it stands there.",
                   session::recordFileOf(each.file)});
    const std::string ctDay = ctDayOf(ear.content, newest.utc);
    ear.surgeryDay = surgeryDay(ctDay, ear.content.surgery);
    if (ear.surgeryDay.empty()) {
      ++library.leftOut.withoutDay;
      library.notes.push_back(
          ctDay.empty()
              ? Sentence{"%1 is left out: the day of its CT is not known, so that no plan is known "
                         "to be made before surgery. Open the outcome on the page Outcome, state "
                         "Day of the CT, and save it again.",
                         ear.name}
              : Sentence{"%1 is left out: the days from surgery to its CT are not known, so that "
                         "no plan is known to be made before surgery. Open the outcome on the page "
                         "Outcome, state them, and save it again.",
                         ear.name});
      continue;
    }
    ears.push_back(std::move(ear));
  }
  std::sort(ears.begin(), ears.end(), [](const Implanted& one, const Implanted& other) {
    return std::tie(one.surgeryDay, one.saved->patient.label, one.saved->file) <
           std::tie(other.surgeryDay, other.saved->patient.label, other.saved->file);
  });
  leaveOutTwice(ears, library);
  return ears;
}

/// Values of a plan's array as its simulations ended; notes what hinders stop lengths.
Result<PlannedOutcome> plannedOf(const NumberedPlan& numbered, const Implanted& ear,
                                 bool isInformative, std::vector<Sentence>& notes,
                                 std::size_t& renewed, const analysis::RunProgress& progress,
                                 const std::stop_token& stop)
{
  planning::PlanRequest request = numbered.folder.request;
  request.draws = numbered.folder.shownDraws;
  const std::size_t array = placeOf(numbered.folder, ear.content.found.array);
  const auto plan = planning::viewPlan(request, numbered.folder.folder / planning::planDrawsFile);
  if (!plan) return plan.error();
  if (plan->seal == Seal::changed)
    return Error{
        "%1 or the plan.json beside it was changed after the program wrote it, and is no "
        "prediction "
        "any more. Restore the plan's folder.",
        numbered.folder.folder / planning::planDrawsFile};
  PlannedOutcome planned = endsOf(*plan, array);
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
  if (lengths->isRenewed) ++renewed;
  planning::StopDraws draws;
  draws.logFrictionSd = std::hypot(parameters.frictionSpread.shared, parameters.frictionSpread.ear);
  for (const planning::UnstoppedDraw& each : lengths->draws)
    if (each.curve.end != haptics::InsertionEnd::refused)
      draws.draws.push_back(planning::stopDrawOf(each));
  planned.stops = std::move(draws);
  return planned;
}

}  // namespace

PlannedOutcome endsOf(const planning::Plan& plan, std::size_t array)
{
  PlannedOutcome ends;
  for (const planning::PlannedInsertion& each : plan.insertions) {
    if (each.array != array || each.insertion.end == haptics::InsertionEnd::refused) continue;
    ends.depths_mm.push_back(inMillimeters(each.insertion.depth));
    ends.angles_deg.push_back(inDegrees(each.insertion.apical));
  }
  return ends;
}

std::string dayBefore(const std::string& utc, int days)
{
  int year = 0;
  unsigned month = 0, day = 0;
  if (std::sscanf(utc.c_str(), "%4d-%2u-%2u", &year, &month, &day) != 3) return {};
  const std::chrono::year_month_day date{std::chrono::year(year), std::chrono::month(month),
                                         std::chrono::day(day)};
  if (!date.ok()) return {};
  return textOf(std::chrono::sys_days(date) - std::chrono::days(days));
}

std::string ctDayOf(const OutcomeContent& content, const std::string& savedUtc)
{
  return content.ctAge_days ? dayBefore(savedUtc, *content.ctAge_days) : std::string();
}

std::string surgeryDay(const std::string& ctDay, const Surgery& surgery)
{
  return surgery.daysToCt ? dayBefore(ctDay, *surgery.daysToCt) : std::string();
}

bool isPrediction(const std::string& planMadeUtc, const std::string& surgeryDay)
{
  const std::string made = dayBefore(planMadeUtc, 0);
  return !made.empty() && made <= surgeryDay;
}

Result<LibraryOutcomes> readOutcomes(const planning::RegistryFolders& folders,
                                     const analysis::RunProgress& progress,
                                     const std::stop_token& stop, StopLengths lengths)
{
  auto read = session::readPatients(folders.patients);
  LibraryOutcomes library;
  library.leftOut.unreadable = read.unreadable.size();
  library.notes = std::move(read.unreadable);
  const std::vector<Implanted> ears = implantedIn(read.patients, library);
  const std::vector<NumberedPlan> plans =
      ears.empty() ? std::vector<NumberedPlan>() : plansIn(folders.plans, library.notes);
  std::size_t renewed = 0;
  for (const Implanted& ear : ears) {
    if (stop.stop_requested()) return Error{"The outcomes were canceled."};
    const FoundArray& found = ear.content.found;
    const auto plan = planOf(plans, ear);
    if (!plan) {
      ++library.leftOut.withoutPlan;
      library.notes.push_back(plan.error().message);
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
    auto planned = plannedOf(**plan, ear, isInformative, library.notes, renewed, progress, stop);
    if (stop.stop_requested()) return Error{"The outcomes were canceled."};
    if (!planned) {
      ++library.leftOut.withoutPlan;
      library.notes.push_back(Sentence{"%1 is left out: %2", ear.name, planned.error().message});
      continue;
    }
    outcome.plan = *std::move(planned);
    if (const auto done = checkOutcome(outcome, ear.name); !done) {
      ++library.leftOut.impossible;
      library.notes.push_back(Sentence{"%1 is left out: %2", ear.name, done.error().message});
      continue;
    }
    library.outcomes.push_back(std::move(outcome));
    library.patients.push_back(ear.saved->patient);
  }
  if (renewed > 0)
    library.notes.push_back(
        Sentence{"Stop lengths were computed again, for %1 plans: those that were there are of "
                 "another build "
                 "of the program or of another plan, or were changed or damaged.",
                 renewed});
  return library;
}

}  // namespace perilymph::outcome
