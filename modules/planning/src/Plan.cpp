// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/planning/Plan.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <stop_token>
#include <utility>

#include "PlanFile.h"
#include "PlanNames.h"
#include "PlanSetup.h"
#include "perilymph/analysis/RunProgress.h"
#include "perilymph/foundation/InParallel.h"
#include "perilymph/foundation/Version.h"
#include "perilymph/planning/PlanReading.h"

namespace perilymph::planning {

namespace {

/// Draws between two transactions: what a crash loses at most.
constexpr std::size_t blockSize = 8;
/// Number of draws after which the bands are looked at next: 64, 128, 256, ...
std::size_t nextLook(std::size_t done, std::size_t draws)
{
  std::size_t look = fewestForBand;
  while (look <= done) look *= 2;
  return std::min(look, draws);
}

/// The first draws of a list by draw and array.
std::vector<PlannedInsertion> upTo(std::size_t draws, std::size_t arrays,
                                   const std::vector<PlannedInsertion>& insertions)
{
  return {insertions.begin(), insertions.begin() + static_cast<std::ptrdiff_t>(draws * arrays)};
}

/// Whether enough simulations count with the clinic's resistance, for every array.
bool hasClinicDepths(const Plan& plan)
{
  return std::all_of(plan.arrays.begin(), plan.arrays.end(),
                     [](const ArrayPlan& each) { return each.inClinic.has_value(); });
}

/// What a plan.json knows of its arrays before they were inserted.
std::vector<PlannedArray> arraysOf(const Plan& stored)
{
  std::vector<PlannedArray> arrays;
  for (const ArrayPlan& each : stored.arrays) {
    PlannedArray array{each.name, {}};
    for (const ContactBand& contact : each.contacts) array.filter_Hz.push_back(contact.filter_Hz);
    const bool isKnown = std::any_of(array.filter_Hz.begin(), array.filter_Hz.end(),
                                     [](double filter_Hz) { return filter_Hz > 0.0; });
    if (!isKnown) array.filter_Hz.clear();
    arrays.push_back(std::move(array));
  }
  return arrays;
}

/// Whether a plan.json, to six digits, is of a patient.
bool isSamePatient(const anatomy::Patient& stored, const anatomy::Patient& patient)
{
  const auto isSame = [](Length one, Length other) {
    return std::fabs(inMillimeters(one - other)) < 1e-4;
  };
  if (stored.label != patient.label || stored.side != patient.side ||
      stored.origin.seriesKey != patient.origin.seriesKey || !patient.basalTurn)
    return false;
  const anatomy::BasalTurn &one = *stored.basalTurn, &other = *patient.basalTurn;
  return isSame(one.a, other.a) && isSame(one.b, other.b) && bool(one.h) == bool(other.h) &&
         (!one.h || isSame(*one.h, *other.h));
}

bool isSameApproach(const std::optional<anatomy::Approach>& stored,
                    const std::optional<anatomy::Approach>& approach)
{
  if (!stored || !approach) return stored.has_value() == approach.has_value();
  return std::fabs(inDegrees(stored->tilt - approach->tilt)) < 1e-6 &&
         std::fabs(inDegrees(stored->turn - approach->turn)) < 1e-6;
}

/// Whether two names are of one file: the command line keeps in plan.json what was given, in plan.toml where it is.
bool isSameName(const std::string& one, const std::string& other)
{
  return bareName(one) == bareName(other);
}

/// Whether a plan.json is of a request that is kept beside it.
bool isOf(const PlanRequest& stored, const PlanRequest& request)
{
  return isSamePatient(stored.patient, request.patient) &&
         isSameName(stored.scenario, request.scenario) &&
         stored.friction.has_value() == request.friction.has_value() &&
         isSameName(stored.friction.value_or(""), request.friction.value_or("")) &&
         stored.seed == request.seed && isSameApproach(stored.approach, request.approach);
}

}  // namespace

Result<Plan> viewPlan(const PlanRequest& request, const std::filesystem::path& draws)
{
  const auto file = session::InsertionTable::open(draws, planKind());
  if (!file) return file.error();
  SealedFacts facts = file->facts();
  const std::string fingerprint = facts[session::fingerprintFact];
  auto kept = insertionsIn(*file);
  if (!kept) return kept.error();
  const std::size_t arrays = request.arrays.size();
  const bool isOfThem = !kept->empty() && kept->back().array + 1 == arrays;
  if (!isOfThem || request.draws == 0 || request.draws > kept->size() / arrays)
    return Error{"%1 has %2 insertions, not %3 of each of %4 arrays. Make the plan again.", draws,
                 kept->size(), request.draws, arrays};
  Plan plan;
  plan.request = request;
  plan.seal = file->seal();
  plan.insertions = upTo(request.draws, arrays, *kept);
  const auto setup = preparePlan(request);
  plan.isCurrent = plan.seal != Seal::changed && setup &&
                   fingerprintOf(request, *setup) == fingerprint &&
                   facts[session::programFact] == buildId();
  if (plan.isCurrent) {
    plan.fingerprint = fingerprint;
    plan.thresholds = setup->thresholds;
    plan.friction = frictionOf(*setup);
    plan.frictionSpread = frictionSpreadOf(*setup);
    addSummary(plan, setup->arrays);
    addClinic(plan, *setup);
    return plan;
  }
  const auto stored = readPlan(draws);
  if (!stored) return stored.error();
  if (!std::ranges::equal(stored->plan.request.arrays, request.arrays, isSameName) ||
      (!stored->plan.fingerprint.empty() && stored->plan.fingerprint != fingerprint))
    return Error{"The plan.json beside %1 is of another plan. Make the plan again.", draws};
  if (stored->plan.seal == Seal::changed || !isOf(stored->plan.request, request))
    plan.seal = Seal::changed;
  if (plan.seal != Seal::changed) plan.fingerprint = fingerprint;
  plan.thresholds = stored->plan.thresholds;
  plan.friction = stored->plan.friction;
  plan.frictionSpread = stored->plan.frictionSpread;
  addSummary(plan, arraysOf(stored->plan));
  plan.clinic = stored->plan.clinic;
  for (std::size_t i = 0; i < plan.arrays.size() && i < stored->plan.arrays.size(); ++i)
    plan.arrays[i].inClinic = stored->plan.arrays[i].inClinic;
  return plan;
}

Result<Plan> makePlan(const PlanRequest& request, const std::filesystem::path& draws,
                      const analysis::RunProgress& progress, const std::stop_token& stop)
{
  const auto setup = preparePlan(request);
  if (!setup) return setup.error();
  Plan plan;
  plan.request = request;
  plan.thresholds = setup->thresholds;
  plan.friction = frictionOf(*setup);
  plan.frictionSpread = frictionSpreadOf(*setup);
  plan.fingerprint = fingerprintOf(request, *setup);
  std::optional<session::InsertionTable> file;
  if (!draws.empty()) {
    auto opened =
        session::InsertionTable::openToContinue(draws, planKind(), planFacts(plan.fingerprint));
    if (!opened) return opened.error();
    file.emplace(*std::move(opened));
    auto kept = insertionsIn(*file);
    if (!kept) return kept.error();
    if (!kept->empty() && kept->back().array + 1 != request.arrays.size())
      return Error{"%1 has draws of %2 arrays, not of %3. Delete it or give another folder.", draws,
                   kept->back().array + 1, request.arrays.size()};
    plan.insertions = *std::move(kept);
  }

  const std::size_t arrays = request.arrays.size();
  std::size_t done = plan.insertions.size() / arrays;
  // A file with more draws than are needed now: those that the same request would have run.
  std::size_t look = nextLook(0, request.draws);
  while (true) {
    while (done < look) {
      const std::size_t count = std::min(blockSize, look - done);
      std::vector<std::vector<PlannedInsertion>> block(count);
      const auto work = [&](std::size_t piece, const std::stop_token& ending) -> Result<void> {
        auto run = runDraw(request, *setup, done + piece + 1, ending);
        if (!run) return run.error();
        // an insertion that was interrupted has ended nowhere
        if (!ending.stop_requested()) block[piece] = *std::move(run);
        return {};
      };
      const auto ran = doInParallel(
          count, request.jobs, work,
          [&](std::size_t pieces) {
            if (progress) progress((done + pieces) * arrays, request.draws * arrays);
          },
          stop);
      // what is complete up to the first draw that is not, also of a block that was interrupted
      std::vector<PlannedInsertion> added;
      for (auto draw = block.begin(); draw != block.end() && draw->size() == arrays; ++draw)
        std::move(draw->begin(), draw->end(), std::back_inserter(added));
      if (file && !added.empty())
        if (const auto kept = file->append(rowsOf(added)); !kept) return kept.error();
      if (!ran) return ran.error();
      std::move(added.begin(), added.end(), std::back_inserter(plan.insertions));
      done += count;
    }
    auto all = std::exchange(plan.insertions, upTo(look, arrays, plan.insertions));
    addSummary(plan, setup->arrays);
    addClinic(plan, *setup);
    const bool canEnd = hasConverged(plan) && (!setup->clinic || hasClinicDepths(plan));
    if (look == request.draws || (request.stopsEarly && canEnd)) break;
    plan.insertions = std::move(all);
    look = nextLook(look, request.draws);
  }
  if (file)
    if (const auto closed = file->close(); !closed) return closed.error();
  return plan;
}

Result<std::string> fingerprintOf(const PlanRequest& request)
{
  const auto setup = preparePlan(request);
  if (!setup) return setup.error();
  return fingerprintOf(request, *setup);
}

}  // namespace perilymph::planning
