// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/planning/Plan.h"

#include <algorithm>
#include <memory>
#include <optional>

#include "PlanDraw.h"
#include "PlanFile.h"
#include "perilymph/analysis/InParallel.h"
#include "perilymph/analysis/InsertionByHand.h"
#include "perilymph/foundation/Resources.h"
#include "perilymph/foundation/Sha256.h"
#include "perilymph/session/Csv.h"
#include "perilymph/session/Scenario.h"

namespace perilymph::planning {

namespace {

/// Draws between two transactions: some seconds of work, which an interruption loses at most.
constexpr std::size_t blockSize = 8;
/// Draws after which the bands are first looked at; then after twice as many, and so on.
constexpr std::size_t fewestDraws = 16;
/// Travel that every array allows, until the array's full one is known.
constexpr const char* anyStopTravel = "0.1";

/// What a plan runs: an array's parameters before anything is drawn.
struct Nominal {
  session::InsertionParameters parameters;
  std::string name;  ///< The array's, for display.
  std::string text;  ///< Its scenario as run.
  double stiffnessDeviation = 0.0;
};

Result<Nominal> nominalOf(const PlanRequest& request, const std::string& array,
                          const Uncertainty& uncertainty)
{
  const auto scenario = session::loadScenario(
      request.scenario, {{"array", array}, {"stop_travel_mm", anyStopTravel}});
  if (!scenario) return Error{array + ": " + scenario.error().message};
  Nominal nominal{scenario->parameters(), scenario->array().name, scenario->text(),
                  uncertainty.stiffnessOf(scenario->array())};
  session::InsertionParameters& parameters = nominal.parameters;
  parameters.withdraws = false;
  parameters.cochlea.source = anatomy::AnatomySource::mean;
  parameters.stopTravel = session::fullTravel(parameters.array, parameters.startInside);
  if (!(parameters.stopTravel.si() > 0.0))
    return Error{"The array " + nominal.name + " starts at its full depth. Lower start_inside_mm."};
  parameters.engine.stopTravel = parameters.stopTravel.si();
  return nominal;
}

PlannedInsertion plannedOf(const PlanDraw& draw, double stiffness, std::size_t number,
                           std::size_t array)
{
  PlannedInsertion planned;
  planned.draw = number;
  planned.array = array;
  const anatomy::BasalTurn& turn = *draw.patient.basalTurn;
  planned.a_mm = inMillimeters(turn.a);
  planned.b_mm = inMillimeters(turn.b);
  planned.h_mm = turn.h ? inMillimeters(*turn.h) : 0.0;
  planned.tilt_deg = inDegrees(draw.tilt);
  planned.turn_deg = inDegrees(draw.turn);
  planned.stiffness = stiffness;
  planned.friction = draw.surgeon.frictionFactor;
  planned.speed_mm_s = inMillimetersPerSecond(draw.surgeon.speed);
  planned.stop_mN = inMillinewtons(draw.surgeon.stop);
  return planned;
}

/// The insertions of all arrays in one draw, in one cochlea.
Result<std::vector<PlannedInsertion>> runDraw(const PlanRequest& request,
                                              const std::vector<Nominal>& nominal,
                                              const Uncertainty& uncertainty,
                                              const analysis::HandDistribution& hand,
                                              std::size_t number, const std::atomic<bool>& isAsked)
{
  const PlanDraw draw = drawPlan(request.patient, uncertainty, hand, request.seed, number);
  std::shared_ptr<const anatomy::ScalaTympani> anatomy;
  std::vector<PlannedInsertion> insertions;
  for (std::size_t i = 0; i < nominal.size() && !isAsked; ++i) {
    const double stiffness = stiffnessFactor(draw, nominal[i].stiffnessDeviation);
    const auto parameters = drawnParameters(nominal[i].parameters, draw, stiffness);
    if (!anatomy) {
      auto built = session::buildAnatomy(parameters);
      if (!built) return built.error();
      anatomy = *built;
    }
    PlannedInsertion planned = plannedOf(draw, stiffness, number, i);
    planned.insertion =
        analysis::insertByHand(parameters, anatomy, hand, draw.surgeon, bandSpacing, isAsked);
    insertions.push_back(std::move(planned));
  }
  return insertions;
}

std::string fingerprintOf(const PlanRequest& request, const std::vector<Nominal>& nominal)
{
  Sha256 hash;
  const auto add = [&hash](const std::string& text) {
    hash.add(std::to_string(text.size()) + ":" + text);
  };
  add("plan 1");
  add(std::to_string(request.seed));
  add(anatomy::patientText(request.patient));
  for (const Nominal& each : nominal) add(each.text);
  return hash.hex();
}

/// Number of draws after which the bands are looked at next.
std::size_t nextLook(std::size_t done, std::size_t draws)
{
  std::size_t look = fewestDraws;
  while (look <= done) look *= 2;
  return std::min(look, draws);
}

}  // namespace

Result<Plan> makePlan(const PlanRequest& request, const std::filesystem::path& draws,
                      const PlanProgress& progress)
{
  if (!request.patient.basalTurn)
    return Error{"The patient " + request.patient.label +
                 " has no A and B, which a plan needs. Measure them, or use 'simulate'."};
  if (request.arrays.empty()) return Error{"A plan needs at least one array. Name one."};
  if (request.draws < 1 || request.draws > maxDraws)
    return Error{"A plan of " + std::to_string(request.draws) + " draws is not possible; 1 to " +
                 std::to_string(maxDraws) + " are."};
  const auto uncertainty = shippedUncertainty();
  if (!uncertainty) return uncertainty.error();
  const auto hand = analysis::shippedHand();
  if (!hand) return hand.error();
  std::vector<Nominal> nominal;
  std::vector<std::string> names;
  for (const std::string& array : request.arrays) {
    auto one = nominalOf(request, array, *uncertainty);
    if (!one) return one.error();
    names.push_back(one->name);
    nominal.push_back(*std::move(one));
  }

  Plan plan;
  plan.request = request;
  plan.fingerprint = fingerprintOf(request, nominal);
  std::optional<PlanFile> file;
  if (!draws.empty()) {
    auto opened = PlanFile::open(draws, plan.fingerprint);
    if (!opened) return opened.error();
    file.emplace(*std::move(opened));
    auto kept = file->read();
    if (!kept) return kept.error();
    plan.insertions = *std::move(kept);
  }

  const std::size_t arrays = nominal.size();
  std::size_t done = plan.insertions.size() / arrays;
  // A file with more draws than are needed now: those that the same request would have run.
  std::size_t look = nextLook(0, request.draws);
  const auto upTo = [&](std::size_t count) {
    return std::vector<PlannedInsertion>(
        plan.insertions.begin(),
        plan.insertions.begin() + static_cast<std::ptrdiff_t>(count * arrays));
  };
  while (true) {
    while (done < look) {
      const std::size_t count = std::min(blockSize, look - done);
      std::vector<std::vector<PlannedInsertion>> block(count);
      const auto work = [&](std::size_t piece, const std::atomic<bool>& isAsked) -> Result<Done> {
        auto run = runDraw(request, nominal, *uncertainty, *hand, done + piece + 1, isAsked);
        if (!run) return run.error();
        block[piece] = *std::move(run);
        return Done{};
      };
      const auto ran = analysis::doInParallel(count, request.jobs, work, [&](std::size_t pieces) {
        return !progress || progress((done + pieces) * arrays, request.draws * arrays);
      });
      if (!ran) return ran.error();
      std::vector<PlannedInsertion> added;
      for (auto& draw : block) std::move(draw.begin(), draw.end(), std::back_inserter(added));
      if (file)
        if (const auto kept = file->append(added); !kept) return kept.error();
      std::move(added.begin(), added.end(), std::back_inserter(plan.insertions));
      done += count;
    }
    plan.arrays = summarize(request, names, upTo(look));
    if (look == request.draws || (request.stopsEarly && bandsStand(plan.arrays))) break;
    look = nextLook(look, request.draws);
  }
  plan.insertions = upTo(look);
  if (file)
    if (const auto closed = file->close(); !closed) return closed.error();
  return plan;
}

}  // namespace perilymph::planning
