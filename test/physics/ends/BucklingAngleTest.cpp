// SPDX-License-Identifier: BSD-3-Clause

// The angle at which an array buckles in front of the opening does not depend on how many nodes it has,
// nor on the time step.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "ScenarioRun.h"
#include "perilymph/foundation/Math.h"
#include "perilymph/planning/PlanResult.h"
#include "perilymph/session/Csv.h"
#include "perilymph/test/Tolerance.h"

namespace perilymph::test {
namespace {

const double allowed_deg = tolerance(5.0, "of a band of 100 to 200");

/// The largest force at which a plan's surgeon stops (test/physics/plan). Above it an array snaps from one
/// shape inside the cochlea to the next, and steps and nodes decide when: printed, but not judged.
constexpr const char* largestStop_N = "0.1";
#ifdef ENDS_ALL
constexpr const char* noStop_N = "0";
#endif

/// An insertion into the mean cochlea, by a hand that stops at a force.
struct Hand {
  const char* array;
  const char* travel_mm;  ///< To the last millimeter of the array.
  const char* friction;
  const char* freeLength_mm;
  const char* stop_N = largestStop_N;
  const char* packing = "0.06";  ///< Loosely packed wires buckle at lower forces.
};

ScenarioRun runOf(const Hand& hand, int nodes, double step_ms)
{
  return runScenario("surgery-flex28", {{"array", hand.array},
                                        {"stop_travel_mm", hand.travel_mm},
                                        {"friction", hand.friction},
                                        {"free_length_mm", hand.freeLength_mm},
                                        {"stop_force_N", hand.stop_N},
                                        {"wire_packing", hand.packing},
                                        {"nodes", std::to_string(nodes)},
                                        {"dt_ms", session::shortestDecimal(step_ms)}});
}

void expectAsWithMoreNodes(const Hand& hand, int finest)
{
  const planning::Resolution plan;
  const ScenarioRun fine = runOf(hand, finest, 1.0);
  const ScenarioRun coarse = runOf(hand, plan.nodes, inMilliseconds(plan.step));
  const std::string what =
      std::string(hand.array) + ", " + hand.friction + ", " + hand.freeLength_mm + " mm free: ";
  ASSERT_EQ(fine.error + coarse.error, "") << what;
  // where the array would buckle at the stop force, either may come first
  const double stop = std::stod(hand.stop_N);
  const bool isAtStop = std::min(fine.peakForce, coarse.peakForce) > 0.95 * stop;
  if (!isAtStop) {
    EXPECT_STREQ(haptics::nameOf(coarse.end), haptics::nameOf(fine.end)) << what;
  }
  EXPECT_NEAR(inDegrees(radians(coarse.angle)), inDegrees(radians(fine.angle)), allowed_deg)
      << what;
}

TEST(AnArrayInFrontOfTheOpening, BucklesAtTheSameAngleWithTheNodesOfAPlan)
{
  const Hand hand{"flex28", "27", "tissue", "3.5"};
  expectAsWithMoreNodes(hand, 200);
  EXPECT_EQ(runOf(hand, 200, 1.0).end, haptics::InsertionEnd::buckled);
}

#ifdef ENDS_ALL
void printWithEachResolution(const Hand& hand)
{
  std::printf("| %s | %s | %s | %s |", hand.array, hand.friction, hand.freeLength_mm, hand.stop_N);
  const planning::Resolution plan;
  const std::pair<int, double> each[] = {{400, 1.0}, {plan.nodes, inMilliseconds(plan.step)},
                                         {50, 1.0},  {75, 1.0},
                                         {100, 1.0}, {200, 1.0}};
  for (const auto& [nodes, step_ms] : each) {
    const ScenarioRun run = runOf(hand, nodes, step_ms);
    std::printf(" %s %.1f, %.1f |", haptics::nameOf(run.end), inDegrees(radians(run.angle)),
                1e3 * run.peakForce);
  }
  std::printf("\n");
  std::fflush(stdout);
}

TEST(AnArrayInFrontOfTheOpening, BucklesAtTheSameAngleWithTheNodesOfAPlanWhateverTheArray)
{
  const std::pair<const char*, const char*> arrays[] = {
      {"evo", "23"},           {"flex20", "19"},         {"flex24", "23"},
      {"flex26", "25"},        {"flex28", "27"},         {"flexsoft", "29"},
      {"hifocus-slimj", "21"}, {"hybrid-l24", "15"},     {"medel-compressed", "13"},
      {"medel-medium", "22"},  {"medel-standard", "29"}, {"nucleus-straight", "22"},
      {"slim-straight", "23"}};
  std::printf(
      "array, friction, mm free, stop force, end, degrees and peak mN with 400 nodes and 1 ms, as "
      "in "
      "a plan, with 50, 75, 100, 200 nodes and 1 ms\n");
  for (const auto& [array, travel_mm] : arrays)
    for (const char* friction : {"tissue", "endosteum"})
      for (const char* free_mm : {"3", "4", "5"}) {
        const Hand hand{array, travel_mm, friction, free_mm};
        expectAsWithMoreNodes(hand, 400);
        printWithEachResolution(hand);
        if (std::string(friction) == "endosteum" && std::string(free_mm) == "3")
          printWithEachResolution({array, travel_mm, friction, free_mm, noStop_N});
      }
}
#endif

}  // namespace
}  // namespace perilymph::test
