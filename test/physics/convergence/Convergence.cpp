// Numbers that must not depend on numerics: the force of the published run, over all its depths.

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
  std::cout << "at most " << 1e3 * spread.most << " mN apart, at " << 1e3 * spread.travel
            << " mm of travel; the peak is " << 1e3 * spread.peak << " mN" << std::endl;
}

TEST(PublishedRun, ChangesByLessThanAMillinewtonWithTheTimeStep)
{
  std::vector<std::vector<double>> runs;
  for (const double timeStep_ms : timeSteps_ms)
    runs.push_back(forceOverTravel({.timeStep_ms = timeStep_ms}));
  const Spread spread = spreadOf(runs);
  print(spread);
  EXPECT_LE(spread.most, tolerance(1e-3, "backward Euler, steps of 0.1 to 10 ms"));
}

TEST(PublishedRun, ChangesByLessThanTwoPercentOfItsPeakWithTheNumberOfNodes)
{
  std::vector<std::vector<double>> runs;
  for (const int nodes : nodeNumbers) runs.push_back(forceOverTravel({.nodes = nodes}));
  const Spread spread = spreadOf(runs);
  print(spread);
  EXPECT_LE(spread.most, tolerance(0.015, "0.5 mm between nodes") * spread.peak);

  // and every refinement comes closer to the finest
  double last = spread.most;
  for (std::size_t i = 1; i + 1 < runs.size(); ++i) {
    const Spread left = spreadOf({runs[i], runs.back()});
    print(left);
    EXPECT_LT(left.most, 0.7 * last) << nodeNumbers[i] << " nodes";
    last = left.most;
  }
}

}  // namespace
}  // namespace perilymph::test
