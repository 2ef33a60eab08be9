// SPDX-License-Identifier: BSD-3-Clause

// The angle at which an array buckles in front of the opening does not depend on how many nodes it has,
// nor on the time step.

#include <gtest/gtest.h>

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

/// An insertion by hand into the mean cochlea.
struct Hand {
  const char* array;
  const char* travel_mm;  ///< To the last millimeter of the array.
  const char* friction;
  const char* freeLength_mm;
};

ScenarioRun runOf(const Hand& hand, int nodes, double step_ms)
{
  return runScenario("surgery-flex28", {{"array", hand.array},
                                        {"stop_travel_mm", hand.travel_mm},
                                        {"friction", hand.friction},
                                        {"free_length_mm", hand.freeLength_mm},
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
  EXPECT_EQ(haptics::nameOf(coarse.end), haptics::nameOf(fine.end)) << what;
  EXPECT_NEAR(inDegrees(radians(coarse.angle)), inDegrees(radians(fine.angle)), allowed_deg)
      << what;
#ifdef ENDS_ALL
  std::printf("| %s | %s | %s | %s |", hand.array, hand.friction, hand.freeLength_mm,
              haptics::nameOf(fine.end));
  const auto print = [](const ScenarioRun& run) {
    std::printf(" %.1f, %.1f |", inDegrees(radians(run.angle)), 1e3 * run.peakForce);
  };
  print(fine);
  print(coarse);
  for (const int nodes : {50, 75, 100, 200}) print(runOf(hand, nodes, 1.0));
  std::printf("\n");
#endif
}

TEST(AnArrayInFrontOfTheOpening, BucklesAtTheSameAngleWithTheNodesOfAPlan)
{
  expectAsWithMoreNodes({"flex28", "27", "tissue", "3.5"}, 200);
}

#ifdef ENDS_ALL
TEST(AnArrayInFrontOfTheOpening, BucklesAtTheSameAngleWithTheNodesOfAPlanWhateverTheArray)
{
  const std::pair<const char*, const char*> arrays[] = {
      {"evo", "23"},           {"flex20", "19"},         {"flex24", "23"},
      {"flex26", "25"},        {"flex28", "27"},         {"flexsoft", "29"},
      {"hifocus-slimj", "21"}, {"hybrid-l24", "15"},     {"medel-compressed", "13"},
      {"medel-medium", "22"},  {"medel-standard", "29"}, {"nucleus-straight", "22"},
      {"slim-straight", "23"}};
  std::printf(
      "array, friction, mm free, end, degrees and peak mN with 400 nodes and 1 ms, as in a plan, "
      "with 50, 75, 100, 200 nodes and 1 ms\n");
  for (const auto& [array, travel_mm] : arrays)
    for (const char* friction : {"tissue", "endosteum"})
      for (const char* free_mm : {"3", "4", "5"})
        expectAsWithMoreNodes({array, travel_mm, friction, free_mm}, 400);
}
#endif

}  // namespace
}  // namespace perilymph::test
