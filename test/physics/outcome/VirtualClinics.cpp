// SPDX-License-Identifier: BSD-3-Clause
#include "VirtualClinics.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "../plan/TruePatient.h"
#include "PlanSetup.h"
#include "perilymph/analysis/InsertionByHand.h"
#include "perilymph/analysis/RandomStream.h"
#include "perilymph/foundation/InParallel.h"
#include "perilymph/foundation/Math.h"

namespace perilymph::test {

namespace {

// Of this test alone; the table's differ from the daily ones.
constexpr std::uint64_t seedOfPatients = CLINIC_SEED + 10'001, seedOfPlans = CLINIC_SEED + 20'002,
                        seedOfTruths = CLINIC_SEED + 30'003;
/// Reach of the true frictions: 2.5 SD of a clinic's shift and 2 SD between ears.
constexpr double frictionReach = 1.1;
/// How much stiffer the arrays of World::stiffer are, its lengths and its surgeons.
constexpr double stiffer = 1.5, lengthError_mm = 1.5, strongStop_mN = 120.0;
/// Error of a length in a CT (goals of the array found in a CT: 0.1 to 0.35 mm along it).
constexpr double ctSd_mm = 0.3;

planning::PlanRequest requestFor(const anatomy::Patient& patient, std::uint64_t number)
{
  planning::PlanRequest request;
  request.patient = patient;
  request.arrays = {"flex28"};
  request.seed = seedOfPlans + number;
  // the same for plan and truth, so that it does not matter to the coverage
  request.resolution = planning::Resolution{40, milliseconds(10)};
  return request;
}

/// Everything of a patient that his pushes need.
struct Prepared {
  TruePatient patient;
  planning::PlanRequest request;
  planning::PlanSetup setup;
};

TruePush pushTruly(const Prepared& prepared, std::uint64_t number, std::size_t truth,
                   std::size_t truths, double stiffness, const std::stop_token& stop)
{
  const planning::Nominal& nominal = prepared.setup.nominal.front();
  planning::PlanDraw luck =
      planning::drawPlan(prepared.patient.measured, prepared.setup.uncertainty, prepared.setup.hand,
                         seedOfTruths + number, truth + 1, nominal.parameters.frictionSpread);
  TruePush push;
  push.logFriction = frictionReach *
                     ((2.0 * static_cast<double>(truth) + 1.0) / static_cast<double>(truths) - 1.0);
  luck.surgeon.frictionFactor = exponential(push.logFriction);
  const auto parameters = planning::drawnParameters(
      nominal.parameters, luck,
      stiffness * planning::stiffnessFactor(luck, nominal.stiffnessDeviation),
      prepared.request.resolution);
  const auto curve = analysis::pushWithoutStop(parameters, prepared.patient.anatomy,
                                               prepared.setup.hand, luck.surgeon, stop);
  for (const auto& rise : curve.rises) {
    push.rise_mN.push_back(inMillinewtons(rise.force));
    push.rise_mm.push_back(inMillimeters(rise.depth));
  }
  push.end_mm = inMillimeters(curve.depth);
  push.isFull = curve.end == haptics::InsertionEnd::finished ||
                curve.end == haptics::InsertionEnd::stoppedByResistance;
  return push;
}

/// One of the pushes, by the density of its friction around a clinic's.
const TruePush& pushWith(const std::vector<TruePush>& pushes, double frictionShift, double uniform)
{
  std::vector<double> sums;
  double sum = 0.0;
  for (const TruePush& each : pushes) {
    const double deviate = (each.logFriction - frictionShift) / planning::earFrictionSd;
    sums.push_back(sum += exponential(-0.5 * deviate * deviate));
  }
  const auto found = std::lower_bound(sums.begin(), sums.end(), uniform * sum);
  return pushes[static_cast<std::size_t>(found - sums.begin())];
}

}  // namespace

double TruePush::stop_mm(double limit_mN) const
{
  const auto found = std::lower_bound(rise_mN.begin(), rise_mN.end(), limit_mN);
  if (found == rise_mN.end()) return std::numeric_limits<double>::infinity();
  return rise_mm[static_cast<std::size_t>(found - rise_mN.begin())];
}

Result<Pool> makePool(const PoolSize& size)
{
  std::vector<Prepared> prepared;
  for (std::uint64_t i = 1; i <= size.patients; ++i) {
    auto patient = truePatient(seedOfPatients, i);
    if (!patient) return patient.error();
    auto request = requestFor(patient->measured, i);
    auto setup = planning::preparePlan(request);
    if (!setup) return setup.error();
    prepared.push_back({*std::move(patient), std::move(request), *std::move(setup)});
  }
  const planning::PlanSetup& setup = prepared.front().setup;
  const session::InsertionParameters& parameters = setup.nominal.front().parameters;
  Pool pool;
  analysis::Surgeon surgeon;
  surgeon.intended = 0.0;
  pool.allInside_mm = inMillimeters(analysis::intendedDepth(parameters, surgeon));
  surgeon.intended = 1.0;
  pool.insertable_mm = inMillimeters(analysis::intendedDepth(parameters, surgeon));
  pool.stopLow_mN = inMillinewtons(setup.hand.stopLow);
  pool.stopHigh_mN = inMillinewtons(setup.hand.stopHigh);
  pool.patients.resize(size.patients);
  for (PoolPatient& each : pool.patients) {
    each.plan.draws.resize(size.draws);
    each.plan.logFrictionSd = planning::frictionSpreadOf(setup);
    each.truths.resize(size.truths);
    each.stiffTruths.resize(size.truths);
  }
  const std::size_t ofPatient = size.draws + 2 * size.truths;
  const auto work = [&](std::size_t piece, const std::stop_token& stop) -> Result<void> {
    const std::size_t i = piece / ofPatient, place = piece % ofPatient;
    PoolPatient& patient = pool.patients[i];
    if (place < size.draws) {
      const auto draw =
          planning::runWithoutStop(prepared[i].request, prepared[i].setup, 0, place + 1, stop);
      if (!draw) return draw.error();
      patient.plan.draws[place] = planning::stopDrawOf(*draw);
      return {};
    }
    const bool isStiff = place - size.draws >= size.truths;
    const std::size_t truth = (place - size.draws) % size.truths;
    (isStiff ? patient.stiffTruths : patient.truths)[truth] =
        pushTruly(prepared[i], i + 1, truth, size.truths, isStiff ? stiffer : 1.0, stop);
    return {};
  };
  const auto done = doInParallel(size.patients * ofPatient, 0, work);
  if (!done) return done.error();
  return pool;
}

ClinicRun runClinic(const Pool& pool, World world, std::size_t patients, std::uint64_t seed,
                    std::uint64_t number)
{
  using outcome::Evidence;
  const auto within = [](analysis::RandomStream& random, double sd) {
    return random.normal(0.0, sd, -3.0 * sd, 3.0 * sd);
  };
  analysis::RandomStream ofClinic(seed, number, 1);
  ClinicRun run;
  run.frictionShift = within(ofClinic, planning::frictionShiftSd);
  run.stopShift = within(ofClinic, planning::stopShiftSd);
  outcome::ResistancePosterior posterior;
  for (std::size_t i = 0; i < patients; ++i) {
    analysis::RandomStream random(seed, number, 2 + i);
    const auto chosen =
        static_cast<std::size_t>(random.uniform() * static_cast<double>(pool.patients.size()));
    const PoolPatient& patient = pool.patients[chosen];
    const TruePush& truth = pushWith(world == World::stiffer ? patient.stiffTruths : patient.truths,
                                     run.frictionShift, random.uniform());
    const double hand_mN = random.between(pool.stopLow_mN, pool.stopHigh_mN);
    const double limit_mN =
        world == World::stopAt120 ? strongStop_mN : hand_mN * exponential(run.stopShift);
    const double stop_mm = truth.stop_mm(limit_mN);
    const double intended_mm = random.between(pool.allInside_mm, pool.insertable_mm);
    const double end_mm = truth.isFull ? std::numeric_limits<double>::infinity() : truth.end_mm;
    outcome::InsertedLength inserted;
    inserted.length_mm = std::min({stop_mm, intended_mm, end_mm});
    inserted.evidence = inserted.length_mm == stop_mm  ? Evidence::resisted
                        : inserted.length_mm == end_mm ? Evidence::none
                                                       : Evidence::censored;
    if (world == World::reasonsMissing && random.uniform() < 0.5)
      inserted.evidence = Evidence::none;
    if (world == World::lengthsOff) inserted.length_mm += lengthError_mm;
    inserted.length_mm += ctSd_mm * random.normal();
    inserted.sd_mm = ctSd_mm;
    inserted.insertable_mm = pool.insertable_mm;
    inserted.year = 2026;
    run.scores.push_back(posterior.add(inserted, patient.plan));
  }
  run.meanFrictionShift = posterior.meanFrictionShift();
  run.meanStopShift = posterior.meanStopShift();
  run.resisted = posterior.count(Evidence::resisted);
  run.censored = posterior.count(Evidence::censored);
  run.uninformative = posterior.count(Evidence::none);
  run.isOffered = posterior.isOffered();
  return run;
}

}  // namespace perilymph::test
