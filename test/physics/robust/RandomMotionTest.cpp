// SPDX-License-Identifier: BSD-3-Clause

// A hand without skill, for as many ticks as the build says, in every setting of the matrix.

#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>

#include "TrialSettings.h"
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
  // Where contacts come and go, slide and stick, a hundredth of the forces of an insertion. A tip
  // that folds over the rim leaves more in a few of a million steps.
  const long allowance = setting.hasRim ? found.ticks / 200'000 : 0;
  EXPECT_LE(found.unbalanced, allowance);
}

INSTANTIATE_TEST_SUITE_P(, RandomMotion, testing::ValuesIn(settings()),
                         [](const auto& about) { return about.param.name; });

}  // namespace
}  // namespace perilymph::test
