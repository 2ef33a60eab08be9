// SPDX-License-Identifier: BSD-3-Clause

// Final states are those of steps whose forces were balanced as exactly as numbers allow.

#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>
#include <memory>
#include <stdexcept>

#include "ScenarioRun.h"
#include "perilymph/device/ScriptedDevice.h"
#include "perilymph/session/Insertion.h"
#include "perilymph/test/Tolerance.h"

namespace perilymph::test {
namespace {

constexpr double micrometer = 1e-6, millinewton = 1e-3;

struct FinalState {
  std::uint64_t ticks = 0;
  mechanics::InsertionState state;
  std::shared_ptr<const anatomy::ScalaTympani> anatomy;
  std::shared_ptr<const mechanics::InsertionModel> model;
};

/// The state of a scripted insertion at its end, by its own model or another of the same numbers.
FinalState finalState(const session::Scenario& scenario,
                      std::shared_ptr<const anatomy::ScalaTympani> anatomy = nullptr,
                      std::shared_ptr<const mechanics::InsertionModel> model = nullptr)
{
  auto insertion = session::Insertion::prepare(
      scenario.parameters(),
      std::make_unique<device::ScriptedDevice>(scenario.speed().si(), scenario.timeStep().si()),
      std::move(anatomy), std::move(model));
  if (!insertion) throw std::runtime_error(insertion.error().message);
  std::uint64_t done = 0;
  const auto ran = (*insertion)
                       ->runToEnd(
                           [&](const haptics::TickRecord&) {
                             ++done;
                             return true;
                           },
                           session::maxTicks((*insertion)->parameters(), (*insertion)->model()));
  if (!ran) throw std::runtime_error(ran.error().message);
  return {done, (*insertion)->loop().engine().state(), (*insertion)->sharedAnatomy(),
          (*insertion)->sharedModel()};
}

/// The same model with a hundredth of the tolerances and all the work that they take.
std::shared_ptr<const mechanics::InsertionModel> patient(const mechanics::InsertionModel& model)
{
  auto result = std::make_shared<mechanics::InsertionModel>(model);
  mechanics::SolverParameters& solver = result->parts.solver;
  solver.maxEvaluations = solver.maxFactorizations = 1'000'000;
  solver.maxIterationsToRenew = 1'000'000;  // finer steps take more
  solver.forceTolerance *= 0.01;
  solver.motionTolerance *= 0.01;
  solver.motionFraction = 1e-5;
  return result;
}

struct Case {
  const char* name;
  const char* scenario;
  session::Overrides changes;
};

class FinalStates : public testing::TestWithParam<Case> {};
class ShippedScenarios : public testing::TestWithParam<Case> {};

void expectSame(const mechanics::InsertionState& usual, const mechanics::InsertionState& full)
{
  double apart = 0.0;
  for (std::size_t i = 0; i < usual.position_W.size(); ++i)
    apart = std::max(apart, (usual.position_W[i] - full.position_W[i]).norm());
  const double forceApart = (usual.readings.handForce_W - full.readings.handForce_W).norm();
  std::cout << apart / micrometer << " um and " << forceApart / millinewton << " mN of "
            << full.readings.handForce_W.norm() / millinewton << " mN" << std::endl;
  EXPECT_LE(apart, tolerance(1.0 * micrometer, "of a position that a CT gives to 100 um"));
  EXPECT_LE(forceApart, tolerance(0.1 * millinewton, "of a force that a hand feels from 20 mN"));
}

/// What the steps of an insertion leave unbalanced moves its array no more, the tweezers held still.
TEST_P(FinalStates, AreBalanced)
{
  const auto scenario = session::loadScenario(GetParam().scenario, GetParam().changes);
  ASSERT_TRUE(scenario) << scenario.error().message;
  const FinalState end = finalState(*scenario);
  const auto full = patient(*end.model);
  mechanics::Drive still;
  still.handPosition_W = end.state.base_W;
  still.handAxis_W = end.model->startAxis_W;
  still.handCurl_W = end.model->startCurl_W;
  mechanics::InsertionState one = end.state, other = end.state;
  for (int i = 0; i < 50; ++i) {
    mechanics::advance(*end.model, one, still);
    mechanics::advance(*full, other, still);
  }
  expectSame(one, other);
}

/// Nor do they add up over an insertion.
TEST_P(ShippedScenarios, EndAsByFullConvergence)
{
  const auto scenario = session::loadScenario(GetParam().scenario, GetParam().changes);
  ASSERT_TRUE(scenario) << scenario.error().message;
  const FinalState usual = finalState(*scenario);
  const FinalState full = finalState(*scenario, usual.anatomy, patient(*usual.model));
  EXPECT_EQ(usual.ticks, full.ticks);
  expectSame(usual.state, full.state);
}

const Case shipped[] = {{"published", "contour-published", {}},
                        {"booth", "booth", {}},
                        {"meanContour", "mean-contour", {}},
                        {"meanFlex28", "mean-flex28", {}},
                        {"surgery", "surgery-flex28", {}}};

/// Much friction, and arrays at the nodes and step of plans: they stick and slip in turns, and a micronewton
/// decides in which tick, so that only their balance is compared.
const Case others[] = {
    {"tissue", "contour-published", {{"friction", "tissue"}}},
    {"plannedFlex28",
     "surgery-flex28",
     {{"stop_travel_mm", "26"}, {"nodes", "100"}, {"dt_ms", "5"}}},  // at 27 mm the tip is slipping
    {"plannedFlex24",
     "surgery-flex28",
     {{"array", "flex24"}, {"stop_travel_mm", "22"}, {"nodes", "100"}, {"dt_ms", "5"}}},
    {"plannedContour",
     "surgery-flex28",
     {{"array", "contour"}, {"stop_travel_mm", "18"}, {"nodes", "100"}, {"dt_ms", "5"}}},
    {"plannedSlimModiolar",
     "surgery-flex28",
     {{"array", "slim-modiolar"}, {"stop_travel_mm", "15"}, {"nodes", "100"}, {"dt_ms", "5"}}},
};

std::string nameOf(const testing::TestParamInfo<Case>& about) { return about.param.name; }

INSTANTIATE_TEST_SUITE_P(Shipped, FinalStates, testing::ValuesIn(shipped), nameOf);
INSTANTIATE_TEST_SUITE_P(Others, FinalStates, testing::ValuesIn(others), nameOf);
INSTANTIATE_TEST_SUITE_P(, ShippedScenarios, testing::ValuesIn(shipped), nameOf);

}  // namespace
}  // namespace perilymph::test
