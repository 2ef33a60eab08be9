// SPDX-License-Identifier: BSD-3-Clause

// A hand without skill, for as many ticks as the build says, in every setting of the matrix.

#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>

#include "TrialSettings.h"
#include "perilymph/mechanics/advance.h"
#include "perilymph/test/Tolerance.h"

namespace perilymph::test {
namespace {

class RandomMotion : public testing::TestWithParam<Setting> {};

TEST_P(RandomMotion, BreaksNothing)
{
  const Setting& setting = GetParam();
  const Findings found =
      run(setting, setting.isWatchedLonger ? ROBUST_TICKS_OF_ONE : ROBUST_TICKS, 1);
  std::cout << setting.name << ": " << summaryOf(found) << std::endl;

  EXPECT_EQ(found.notFinite, 0);
  EXPECT_LE(found.unexplained, tolerance(0.1e-6, "rounding"));
  // Nothing comes out that did not go in; a joule's millionth for rounding and for what is left
  // unbalanced.
  constexpr double microjoule = 1e-6;
  EXPECT_GE(found.minEnergy, -microjoule);
  if (found.startsRelaxed) {
    EXPECT_GE(found.minHandEnergy, -microjoule);
  }
  // The work of a tick is bounded, and what it leaves is settled soon: an array bent sharply at the
  // end of its sheath, pressed by nearly 2 N, takes longest.
  EXPECT_LE(found.maxEvaluations, mechanics::SolverParameters{}.maxEvaluations);
  EXPECT_LE(found.maxFactorizations, mechanics::SolverParameters{}.maxFactorizations);
  const double longest = setting.stylet == StyletUse::held ? 0.3 : 50e-3;
  EXPECT_LE(static_cast<double>(found.longestSettling) * setting.timeStep,
            tolerance(longest, "a step that goes on in the next ones"));
  EXPECT_LE(found.restsUnsettled, found.rests / 200);
  // An array about to snap may go another way: then it rests elsewhere, as balanced.
  EXPECT_LE(static_cast<double>(found.restsElsewhere),
            tolerance(0.1, "arrays about to snap") * static_cast<double>(found.rests) + 1.0);
}

INSTANTIATE_TEST_SUITE_P(, RandomMotion, testing::ValuesIn(settings()),
                         [](const auto& about) { return about.param.name; });

}  // namespace
}  // namespace perilymph::test
