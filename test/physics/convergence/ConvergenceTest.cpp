// SPDX-License-Identifier: BSD-3-Clause

// Independence of resolution: the force of the published run, over all depths.

#include <gtest/gtest.h>

#include <iostream>

#include "PublishedRun.h"
#include "perilymph/test/Tolerance.h"

namespace perilymph::test {
namespace {

constexpr double timeSteps_ms[] = {CONVERGENCE_TIME_STEPS_MS};
constexpr int nodeNumbers[] = {CONVERGENCE_NODES};

void print(const Spread& spread)
{
  std::cout << "at most " << 1e3 * spread.maximum << " mN apart, at " << 1e3 * spread.travel
            << " mm of travel; the peak is " << 1e3 * spread.peak << " mN" << std::endl;
}

TEST(PublishedRun, ChangesByLessThanAMillinewtonWithTheTimeStep)
{
  std::vector<std::vector<double>> runs;
  for (const double timeStep_ms : timeSteps_ms)
    runs.push_back(forceOverTravel({.timeStep_ms = timeStep_ms}));
  const Spread spread = spreadOf(runs);
  print(spread);
  EXPECT_LE(spread.maximum, tolerance(1e-3, "backward Euler, steps of 0.1 to 10 ms"));
}

TEST(PublishedRun, ChangesByLessThanTwoPercentOfItsPeakWithTheNumberOfNodes)
{
  std::vector<std::vector<double>> runs;
  for (const int nodes : nodeNumbers) runs.push_back(forceOverTravel({.nodes = nodes}));
  const Spread spread = spreadOf(runs);
  print(spread);
  EXPECT_LE(spread.maximum, tolerance(0.015, "0.5 mm between nodes") * spread.peak);

  // and every refinement comes closer to the finest
  double last = spread.maximum;
  for (std::size_t i = 1; i + 1 < runs.size(); ++i) {
    const Spread left = spreadOf({runs[i], runs.back()});
    print(left);
    EXPECT_LT(left.maximum, 0.7 * last) << nodeNumbers[i] << " nodes";
    last = left.maximum;
  }
}

// A soft straight array presses the wall by a few millinewton here and there, and its bend at the
// ends of each contact dies away over (4 EI / k)^(1/4), with k the wall's stiffness per length: 0.6
// mm at its tip. With 50 nodes that is the distance between two of them, and the force ripples as
// they pass.
TEST(SoftStraightRun, RipplesByAMillinewtonOrSoWhereNodesAreAsFarApartAsItsContactsReach)
{
  std::vector<std::vector<double>> runs;
  for (const int nodes : {50, 100, 200})
    runs.push_back(forceOverTravel({.scenario = "mean-flex28", .speed_mm_s = 4.0, .nodes = nodes}));
  const Spread coarse = spreadOf({runs[0], runs[2]}), usual = spreadOf({runs[1], runs[2]});
  print(coarse);
  print(usual);
  EXPECT_LE(coarse.maximum, tolerance(1.5e-3, "0.6 mm between nodes"));
  EXPECT_LE(usual.maximum, tolerance(0.8e-3, "0.3 mm between nodes"));
}

}  // namespace
}  // namespace perilymph::test
