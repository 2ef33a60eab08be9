// SPDX-License-Identifier: BSD-3-Clause

// Independence of resolution: the force of the published run, over all depths.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <string>

#include "PublishedRun.h"
#include "perilymph/test/Tolerance.h"

namespace perilymph::test {
namespace {

constexpr double timeSteps_ms[] = {CONVERGENCE_TIME_STEPS_MS};
constexpr int nodeNumbers[] = {CONVERGENCE_NODES};
constexpr double boneTimeSteps_ms[] = {BONE_TIME_STEPS_MS};
constexpr int boneNodes[] = {BONE_NODES};

/// Number of samples of the published run before its first rib, 17.0 mm from the tip, which starts
/// 2 mm inside, reaches the opening by 0.275 mm.
const auto firstRibTouches = static_cast<std::size_t>(std::lround(14.7e-3 / sampleTravel));

void print(const Spread& spread)
{
  std::cout << "at most " << 1e3 * spread.maximum << " mN apart, at " << 1e3 * spread.travel
            << " mm of travel; the peak is " << 1e3 * spread.peak << " mN" << std::endl;
}

TEST(PublishedRun, ChangesByLessThanAMillinewtonWithTheTimeStepUpToTheFirstRib)
{
  std::vector<std::vector<double>> runs;
  for (const double timeStep_ms : timeSteps_ms)
    runs.push_back(forceOverTravel({.timeStep_ms = timeStep_ms}));
  const Spread spread = spreadOf(runs);
  print(spread);
  // at the rib the force rises by 81 mN within 0.14 mm, and the longest step is 0.02 mm of it
  EXPECT_LE(spread.maximum, tolerance(0.015, "a seventh of a flank") * spread.peak);
  for (auto& run : runs) run.resize(firstRibTouches);
  const Spread before = spreadOf(runs);
  print(before);
  EXPECT_LE(before.maximum, tolerance(1e-3, "backward Euler, steps of 0.1 to 10 ms"));
}

TEST(PublishedRun, ChangesByLessThanTwoPercentOfItsPeakWithTheNumberOfNodes)
{
  std::vector<std::vector<double>> runs;
  for (const int nodes : nodeNumbers) runs.push_back(forceOverTravel({.nodes = nodes}));
  const Spread spread = spreadOf(runs);
  print(spread);
  EXPECT_LE(spread.maximum, tolerance(0.02, "0.5 mm between nodes") * spread.peak);

  // and every refinement comes closer to the finest; around 11.3 mm the array sticks and slips in turns,
  // and when it slips depends on the nodes
  const double ripple = tolerance(0.5e-3, "stick and slip, between 11.1 and 11.5 mm of travel");
  double last = spread.maximum;
  for (std::size_t i = 1; i + 1 < runs.size(); ++i) {
    const Spread left = spreadOf({runs[i], runs.back()});
    print(left);
    EXPECT_LT(left.maximum, std::max(0.7 * last, ripple)) << nodeNumbers[i] << " nodes";
    last = left.maximum;
  }
}

// Against the published wall, a soft straight array presses it by a few millinewton here and there,
// and its bend at the ends of each contact dies away over (4 EI / k)^(1/4), with k the wall's
// stiffness per length: 0.6 mm at its tip. With 50 nodes that is the distance between two of them,
// and the force ripples as they pass.
TEST(SoftStraightRun, RipplesByAMillinewtonOrSoWhereNodesAreAsFarApartAsItsContactsReach)
{
  std::vector<std::vector<double>> runs;
  for (const int nodes : {50, 100, 200})
    runs.push_back(
        forceOverTravel({.scenario = "mean-flex28",
                         .speed_mm_s = 4.0,
                         .nodes = nodes,
                         .more = {{"wall_stiffness_N_m", "441"}, {"wall_lining_mm", "0.01"}}}));
  const Spread coarse = spreadOf({runs[0], runs[2]}), usual = spreadOf({runs[1], runs[2]});
  print(coarse);
  print(usual);
  EXPECT_LE(coarse.maximum, tolerance(1.5e-3, "0.6 mm between nodes"));
  EXPECT_LE(usual.maximum, tolerance(0.8e-3, "0.3 mm between nodes"));
}

/// An insertion into the mean cochlea, whose wall is bone.
struct BoneCase {
  const char* array;
  const char* friction;
  double speed_mm_s;
  const char* travel_mm;
};

class BoneRun : public testing::TestWithParam<BoneCase> {
protected:
  static double peakOf(int nodes, double timeStep_ms)
  {
    const BoneCase& run = GetParam();
    return spreadOf({forceOverTravel({.scenario = "mean-flex28",
                                      .speed_mm_s = run.speed_mm_s,
                                      .nodes = nodes,
                                      .timeStep_ms = timeStep_ms,
                                      .more = {{"array", run.array},
                                               {"friction", run.friction},
                                               {"stop_travel_mm", run.travel_mm}}})})
        .peak;
  }
};

TEST_P(BoneRun, ChangesItsPeakByLessThanThreePercentWithNodesAndTimeStep)
{
  const double usual = peakOf(100, 1.0);
  for (const int nodes : boneNodes) {
    const double peak = peakOf(nodes, 2.0);
    std::cout << nodes << " nodes, 2 ms: " << 1e3 * peak << " mN" << std::endl;
    EXPECT_NEAR(peak, usual, tolerance(0.03, "0.3 mm between nodes") * usual) << nodes << " nodes";
  }
  for (const double timeStep_ms : boneTimeSteps_ms) {
    const double peak = peakOf(100, timeStep_ms);
    std::cout << "100 nodes, " << timeStep_ms << " ms: " << 1e3 * peak << " mN" << std::endl;
    EXPECT_NEAR(peak, usual, tolerance(0.03, "stick-slip") * usual) << timeStep_ms << " ms";
  }
}

// With the friction of tissue a FLEX28 buckles outside the opening from 18 to 20 mm on.
INSTANTIATE_TEST_SUITE_P(Arrays, BoneRun,
                         testing::Values(BoneCase{"flex28", "soap-10", 2.0, "22"},
                                         BoneCase{"flex28", "tissue", 1.0, "17"},
                                         BoneCase{"nucleus-straight", "tissue", 1.0, "12"}),
                         [](const auto& of) {
                           std::string name = std::string(of.param.array) + of.param.friction;
                           std::erase(name, '-');
                           return name;
                         });

// An oval array whose reach toward the wall were that of the moment would rattle in the grooves of
// the mean cochlea, by 4 mN from one sample to the next.
TEST(OvalArrayAgainstBone, DoesNotRattle)
{
  const std::vector<double> force = forceOverTravel({.scenario = "mean-flex28", .speed_mm_s = 4.0});
  double largest = 0.0;
  for (std::size_t i = 1; i < force.size(); ++i)
    largest = std::max(largest, std::fabs(force[i] - force[i - 1]));
  EXPECT_LE(largest, tolerance(0.4e-3, "as a node passes the rim"));
}

}  // namespace
}  // namespace perilymph::test
